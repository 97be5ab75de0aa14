/* tia-observe - draws the view of an eye on a light-field display, from the display's pictures. */
#include <stdio.h>
#include <stdlib.h>

#include <tia/tia.h>

#include "common/choices.h"
#include "common/command_line.h"
#include "common/lenticular.h"
#include "common/message.h"
#include "common/parse.h"
#include "common/quilt.h"
#include "common/scene/scene_load.h"
#include "common/scene/scene_report.h"
#include "common/signals.h"
#include "eye_views.h"
#include "ports.h"

enum { FINE, FAILED, REFUSED };
enum { FRAMES = 25, FRAMES_MAX = 1000000 };

struct request {
    const char *output, *scene, *pictures, *modules, *lenticular, *calibration;
    uint32_t views, frames;
    uint16_t width, height;
    bool has_eye, moves;
    struct observation observation;
    struct scene_file file;
    char why[PORT_WHY];
};

static int refuse(int status, const char *what, const char *why)
{
    return message_why("tia-observe", status, what, why);
}

/* ---- the command line ---- */

#define NEAR 32768.0 /* limit of lengths */

static const char *set_eye(void *eye, char *value)
{
    double at[3];

    if (!parse_reals(value, NEAR, at, 3) || at[2] <= 0)
        return "";
    *(struct eye *)eye = (struct eye){at[0], at[1], at[2]};
    return NULL;
}

static const char *set_two(void *apart, char *value)
{
    return parse_reals(value, NEAR, apart, 1) && *(double *)apart > 0 ? NULL : "";
}

#define TO(member) OPTION_TO(struct request, member)
#define EYE(member, given_member)                                                                                      \
    TO(observation.member), .given = offsetof(struct request, given_member), .parse = set_eye,                         \
                            .rule = "not a position in front of the screen (X,Y,Z like 0.1,0,2.5; Z above 0)"

static const struct option_row rows[] = {
    {"eye", 'e', OPTION_PARSED, "X,Y,Z", "the position of the eye, in the scene's unit", EYE(eye, has_eye)},
    {"output", 'o', OPTION_TEXT, "FILE",
     "a picture (.png .ppm .bmp .565) or, for a moving eye, a film (.y4m, or one picture per frame with %04d in its "
     "name)",
     TO(output)},
    {"views", 0, OPTION_NUMBER, "N", "PICTURES are N views", TO(views), .min = 1, .max = MODULES_MAX},
    {"modules", 0, OPTION_TEXT, MODULES_KEYS, "PICTURES are those of M projectors; the values given to tia",
     TO(modules)},
    {"lenticular", 0, OPTION_TEXT, "KEYS", "PICTURES is that of a panel: " LENTICULAR_KEYS, TO(lenticular)},
    {"calibration", 0, OPTION_TEXT, "FILE", "PICTURES is that of the panel of this visual.json", TO(calibration)},
    {"size", 's', OPTION_SIZE, "WIDTHxHEIGHT",
     "the size of the written picture; default that of a view or of the panel",
     OPTION_PAIR(struct request, width, height), .max = TIA_SIZE_MAX},
    {"two", 0, OPTION_PARSED, "DISTANCE", "show two eyes side by side, DISTANCE apart", TO(observation.apart),
     .parse = set_two, .rule = "not a distance of two eyes (above 0, like 0.065)"},
    {"anaglyph", 0, OPTION_FLAG, NULL, "combine both eyes in one picture, for red and cyan glasses",
     TO(observation.anaglyph)},
    {"to", 0, OPTION_PARSED, "X,Y,Z", "move the eye to this position", EYE(to, moves)},
    {"frames", 'n', OPTION_NUMBER, "N", "the number of frames of that movement (default 25)", TO(frames), .min = 1,
     .max = FRAMES_MAX},
    OPTION_END};

static const struct command command = {
    "tia-observe",
    "Usage: tia-observe [options] --eye X,Y,Z -o FILE SCENE PICTURES\n"
    "Shows the view of an eye in front of the display of SCENE's camera lightfield.\n"
    "PICTURES, which tia has drawn, is a quilt (NAME_qs8x6a0.75.png), a name with\n"
    "%03d of --views or --modules, or the picture of a lenticular panel, with the\n"
    "--lenticular or --calibration of tia. The screen fills the written picture from\n"
    "edge to edge. The eye is X to the right of the screen's middle, Y above it and\n"
    "Z in front of it.\n"
    "\n",
    rows,
    "\n"
    "Exit status: 0 success, 1 a file cannot be read or written, 2 usage error,\n"
    "wrong scene or pictures.\n"};

static int check(const struct request *r, int arguments)
{
    if (arguments != 2)
        return refuse(REFUSED, "a scene and its pictures", arguments < 2 ? "are missing (tia-observe -h)" : "only two");
    if (!r->output)
        return refuse(REFUSED, "--output", "is missing (tia-observe -h)");
    if (!r->has_eye)
        return refuse(REFUSED, "--eye", "is missing (tia-observe -h)");
    if ((r->views != 0) + (r->modules != NULL) + (r->lenticular != NULL) + (r->calibration != NULL) > 1)
        return refuse(REFUSED,
                      r->views     ? "--views"
                      : r->modules ? "--modules"
                                   : "--lenticular",
                      r->calibration  ? "not with --calibration"
                      : r->lenticular ? "not with --lenticular"
                                      : "not with --modules");
    if (r->observation.anaglyph && !(r->observation.apart > 0))
        return refuse(REFUSED, "--anaglyph", "needs two eyes (--two 0.065)");
    if (r->frames && !r->moves)
        return refuse(REFUSED, "--frames", "needs an eye that moves (--to X,Y,Z)");
    return FINE;
}

/* ---- the run ---- */

static int load_scene(struct request *r)
{
    int format = scene_format_of(r->scene);

    if (format == SCENE_UNKNOWN)
        return refuse(REFUSED, r->scene, "unknown scene format (name it .tia)");
    int status = scene_open(&r->file, r->scene, format, false);
    if (status)
        return scene_report_print(&r->file, "tia-observe", status == TIA_ERR_RANGE ? REFUSED : FAILED);
    if (!r->file.scene.camera.line)
        return refuse(REFUSED, r->scene, "has no observer line (camera lightfield)");
    return FINE;
}

static int load_pictures(struct request *r)
{
    struct observation *o = &r->observation;
    struct modules modules;
    const char *wrong = r->modules ? modules_parse(&modules, r->modules, &r->file.scene) : NULL;
    if (wrong)
        return refuse(REFUSED, "--modules", wrong);
    int status = pictures_load(&o->pictures, r->pictures, r->modules ? modules.count : r->views);
    if (status)
        return refuse(status == TIA_ERR_RANGE ? REFUSED : FAILED, o->pictures.why, "");
    display_init(&o->display, &r->file.scene, o->pictures.count, r->modules ? &modules : NULL);
    return FINE;
}

static int load_panel(struct request *r)
{
    struct observation *o = &r->observation;
    struct pictures *p = &o->pictures;
    struct lenticular panel;
    struct tia_quilt quilt;
    uint32_t aspect;
    char why[80];
    int status = r->calibration ? calibration_read(&panel, r->calibration) : lenticular_parse(&panel, r->lenticular);

    if (status)
        return refuse(status == TIA_ERR_RANGE ? REFUSED : FAILED, panel.why, "");
    if (quilt_named(r->pictures, &quilt, &aspect))
        return refuse(REFUSED, r->calibration ? "--calibration" : "--lenticular", "not with a quilt");
    status = pictures_load_one(p, r->pictures);
    if (status)
        return refuse(status == TIA_ERR_RANGE ? REFUSED : FAILED, p->why, "");
    (void)snprintf(why, sizeof why, "is %ux%u, the calibration's panel %ux%u", p->width, p->height, panel.width,
                   panel.height);
    if (r->calibration && (p->width != panel.width || p->height != panel.height))
        return refuse(REFUSED, r->pictures, why);
    display_init(&o->display, &r->file.scene, 1, NULL);
    panel_init(&o->panel, &panel.lens, p->width, p->height);
    o->lenses = true;
    return FINE;
}

static int load(struct request *r)
{
    struct observation *o = &r->observation;
    int status = load_scene(r);

    if (status == FINE)
        status = r->lenticular || r->calibration ? load_panel(r) : load_pictures(r);
    if (status != FINE)
        return status;
    o->width = r->width ? r->width : o->pictures.width;
    o->height = r->height ? r->height : o->pictures.height;
    return FINE;
}

static int write_film(struct request *r)
{
    struct observation *o = &r->observation;
    enum image_format format = image_format_of(r->output);
    uint32_t frames = r->moves ? (r->frames ? r->frames : FRAMES) : 1;
    struct image_film film = {.width = o->width * (o->apart > 0 && !o->anaglyph ? 2 : 1),
                              .height = o->height,
                              .rows = o->height,
                              .frames = frames,
                              .all_frames = frames,
                              .rate = {25, 1}};
    struct series series = {.name = r->output, .format = format, .film = film, .why = r->why};

    if (format == IMAGE_UNKNOWN || format == IMAGE_PART || !image_format_has(format, 0) || !image_format_built(format))
        return refuse(REFUSED, r->output, "unknown picture format (name it .png, .ppm, .bmp, .565 or .y4m)");
    if (r->moves && !image_format_films(format) && !series_is_pattern(r->output))
        return refuse(REFUSED, r->output, "one picture for a film (name it .y4m, or with %04d in its name)");
    int status = observe(o, &series);
    return status ? refuse(FAILED, r->why[0] ? r->why : "memory: exhausted", "") : FINE;
}

static int run(struct request *r)
{
    int status = load(r);

    status = status == FINE ? write_film(r) : status;
    pictures_free(&r->observation.pictures);
    scene_close(&r->file);
    return status;
}

int main(int argc, char **argv)
{
    struct request r = {.output = NULL};

    signals_prepare();
    int status = command_parse(&command, &r, &argc, &argv);
    if (status != COMMAND_RUN)
        return status;
    status = check(&r, argc);
    if (status != FINE)
        return status;
    r.scene = argv[0];
    r.pictures = argv[1];
    if (!r.moves)
        r.observation.to = r.observation.eye;
    return run(&r);
}
