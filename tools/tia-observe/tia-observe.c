/* tia-observe - what an eye sees of a light-field display, by its pictures. */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <tia/tia.h>

#include "common/lenticular.h"
#include "common/message.h"
#include "common/parse.h"
#include "common/quilt.h"
#include "common/scene/scene.h"
#include "common/signals.h"
#include "observe.h"
#include "ports.h"

static const char usage[] =
    "Usage: tia-observe [options] --eye X,Y,Z -o FILE SCENE PICTURES\n"
    "Shows what an eye sees of the display of SCENE's camera lightfield, from PICTURES that tia drew:\n"
    "a quilt (NAME_qs8x6a0.75.png), a name with %03d of --views or --modules, or what a panel with\n"
    "lenses shows, with --lenticular or --calibration as tia was told. The screen fills the picture.\n"
    "The eye is X right of the screen's middle, Y above it and Z before it.\n"
    "\n"
    "  -e, --eye X,Y,Z         where the eye is, in the scene's unit\n"
    "  -o, --output FILE       a picture (.png .ppm .bmp .565) or, of a moving eye, a film (.y4m, or a\n"
    "                          picture a frame with %04d in its name)\n"
    "      --views N           the pictures are of N views\n"
    "      --modules M         of M projectors; M,distance=L,spacing=L as tia was told\n"
    "      --lenticular KEYS   a panel's: pitch=50.2,slope=-7.1,center=0.3,subpixels=rgb|bgr|none,\n"
    "                          flip,invert\n"
    "      --calibration FILE  a panel's, by visual.json\n"
    "  -s, --size WxH          of what an eye sees; default that of a view or of the panel\n"
    "      --two D             two eyes, D apart, side by side\n"
    "      --anaglyph          both in one picture, for red and cyan glasses\n"
    "      --to X,Y,Z          the eye moves there\n"
    "  -n, --frames N          in so many frames, default 25\n"
    "  -h, --help, -V, --version\n"
    "\n"
    "Exit status: 0 fine, 1 a file cannot be read or written, 2 wrong usage, scene or pictures.\n";

enum { FINE, FAILED, REFUSED, TWO = 256, ANAGLYPH, TO, VIEWS, MODULES, LENTICULAR, CALIBRATION };
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

static bool number(const char *text, char **end, double *value)
{
    *value = strtod(text, end);
    return *end != text && fabs(*value) < 32768;
}

static int set_eye(const char *option, struct eye *eye)
{
    char *end;

    if (!number(optarg, &end, &eye->x) || *end != ',' || !number(end + 1, &end, &eye->y) || *end != ',' ||
        !number(end + 1, &end, &eye->z) || *end != '\0' || !(eye->z > 0))
        return refuse(REFUSED, option, "not a place before the screen (X,Y,Z like 0.1,0,2.5; Z above 0)");
    return FINE;
}

static int set_two(double *apart)
{
    char *end;

    return number(optarg, &end, apart) && *end == '\0' && *apart > 0
               ? FINE
               : refuse(REFUSED, "--two", "not how far eyes are apart (above 0, like 0.065)");
}

static int parse_option(struct request *r, int option, char **argv)
{
    switch (option) {
    case 'o':
        r->output = optarg;
        return FINE;
    case 'e':
        r->has_eye = true;
        return set_eye("--eye", &r->observation.eye);
    case TO:
        r->moves = true;
        return set_eye("--to", &r->observation.to);
    case TWO:
        return set_two(&r->observation.apart);
    case ANAGLYPH:
        r->observation.anaglyph = true;
        return FINE;
    case VIEWS:
        return parse_number(optarg, NULL, 1, MODULES_MAX, &r->views)
                   ? FINE
                   : refuse(REFUSED, "--views", "not a number from 1 to 65536");
    case MODULES:
        r->modules = optarg;
        return FINE;
    case LENTICULAR:
        r->lenticular = optarg;
        return FINE;
    case CALIBRATION:
        r->calibration = optarg;
        return FINE;
    case 's':
        return parse_size(optarg, NULL, TIA_SIZE_MAX, &r->width, &r->height)
                   ? FINE
                   : refuse(REFUSED, "--size", "not a size (1x1 to 8192x8192, like 640x480)");
    case 'n':
        return parse_number(optarg, NULL, 1, FRAMES_MAX, &r->frames)
                   ? FINE
                   : refuse(REFUSED, "--frames", "not a number from 1 to 1000000");
    default:
        return message_option("tia-observe", option, argv);
    }
}

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
        return refuse(status == TIA_ERR_RANGE ? REFUSED : FAILED, r->file.why, "");
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

    if (format == IMAGE_UNKNOWN || !image_format_has(format, 0) || !image_format_built(format))
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
    static const struct option longs[] = {{"eye", required_argument, NULL, 'e'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"views", required_argument, NULL, VIEWS},
                                          {"modules", required_argument, NULL, MODULES},
                                          {"lenticular", required_argument, NULL, LENTICULAR},
                                          {"calibration", required_argument, NULL, CALIBRATION},
                                          {"size", required_argument, NULL, 's'},
                                          {"two", required_argument, NULL, TWO},
                                          {"anaglyph", no_argument, NULL, ANAGLYPH},
                                          {"to", required_argument, NULL, TO},
                                          {"frames", required_argument, NULL, 'n'},
                                          {"help", no_argument, NULL, 'h'},
                                          {"version", no_argument, NULL, 'V'},
                                          {NULL, 0, NULL, 0}};
    struct request r = {.output = NULL};

    signals_prepare();
    opterr = 0;
    for (int option; (option = getopt_long(argc, argv, ":e:o:s:n:hV", longs, NULL)) != -1;) {
        if (option == 'h' || option == 'V')
            return message_output("tia-observe", option == 'h' ? usage : "tia-observe " TIA_VERSION "\n");
        int status = parse_option(&r, option, argv);
        if (status != FINE)
            return status;
    }
    int status = check(&r, argc - optind);
    if (status != FINE)
        return status;
    r.scene = argv[optind];
    r.pictures = argv[optind + 1];
    if (!r.moves)
        r.observation.to = r.observation.eye;
    return run(&r);
}
