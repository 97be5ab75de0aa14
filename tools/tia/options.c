#include "options.h"

#include <string.h>
#include <tia/debug.h>

#include "arithmetic.h"
#include "common/choices.h"
#include "common/modules.h"
#include "common/parse.h"
#include "common/thread_pool.h"
#include "help.h"
#include "thumbnail_page.h"

enum { ACUITY_BITS = 8 }; /* w0 and m are Q8.24 */

/* ---- parsers of single options, see `parse` of common/command_line.h ---- */

/* Cuts "drm:/dev/dri/card1" into its name and device. */
static const char *set_port(void *member, char *value)
{
    char *colon = strchr(value, ':');

    *(struct port_option *)member = (struct port_option){value, colon && colon[1] != '\0' ? colon + 1 : NULL};
    if (colon)
        *colon = '\0';
    return NULL;
}

static const char *set_mode(void *mode, char *value)
{
    *(const char **)mode = value;
    return strcmp(value, "help") == 0 || parse_mode(value) ? NULL : "";
}

static const char *set_arithmetic(void *member, char *value)
{
    const struct tia_core **core = member;

    *core = arithmetic_called(value);
    return *core ? NULL : arithmetic_missing(value);
}

static const char *set_rate(void *rate, char *value)
{
    return parse_rate(value, rate) ? NULL : "";
}

/* Accepts "none", or a bias and its amount: "slope=1.5". */
static const char *set_bias(void *member, char *value)
{
    struct tia_shadow_map *map = member;
    const char *equals = strchr(value, '='), *name;
    size_t length = strcspn(value, "=");

    map->bias = TIA_BIAS_NONE;
    while ((name = tia_bias_name(map->bias)) && (strncmp(name, value, length) != 0 || name[length] != '\0'))
        map->bias++;
    map->amount = 0;
    bool fine = map->bias == TIA_BIAS_NONE ? !equals : name && equals && parse_seconds(equals + 1, &map->amount);
    return fine ? NULL : "";
}

/* Accepts the name of an integrator, or "ao=2.5" with a distance, and ends the name at the '='. */
static const char *set_integrator(void *member, char *value)
{
    char *equals = strchr(value, '=');
    const char *name;
    uint32_t number = 0;

    if (equals)
        *equals = '\0';
    while ((name = tia_integrator_name(number)) && strcmp(name, value) != 0)
        number++;
    *(struct integrator_option *)member = (struct integrator_option){number + 1, equals ? equals + 1 : NULL};
    return !name ? "" : equals && number != TIA_OCCLUSION ? "has no distance (ao=2.5 has)" : NULL;
}

static const char *set_place(void *member, char *value)
{
    return parse_place(value, member) ? NULL : "";
}

static const char *set_up(void *member, char *value)
{
    int64_t *up = member;
    return parse_place(value, up) && (up[0] || up[1] || up[2]) ? NULL : "";
}

static const char *set_height(void *member, char *value)
{
    int64_t *height = member;
    return parse_long(value, NULL, height) && *height > 0 ? NULL : "";
}

/* ---- the table, in the manual's order ---- */

#define TO(member) OPTION_TO(struct options, member)
#define PAIR(first, last) OPTION_PAIR(struct options, first, last)
#define GIVEN(member) .given = offsetof(struct options, member)
#define PARSED(member, function) TO(member), .parse = (function)

static const struct option_row rows[] = {
    {"display", 'd', OPTION_PARSED, "auto|drm|fbdev|terminal|none[:DEVICE]",
     "the display, such as drm:/dev/dri/card1 or terminal:halfblocks, symbols, sixel or kitty",
     PARSED(display, set_port)},
    {"output", 'o', OPTION_TEXT, "FILE",
     "draw into FILE, or - for standard output: a picture (.png .ppm .bmp .565 .pfm .exr), a film (.y4m, or one "
     "picture per "
     "frame with %04d in its name) or a part for tia-join (.tiapart)",
     TO(output)},
    {"format", 0, OPTION_CHOICE, IMAGE_FORMATS, "the format of FILE, if its name has no such extension", TO(format),
     .min = IMAGE_PNG},
    {"record", 0, OPTION_TEXT, "FILE", "write a record of the picture, by which tia-verify draws it again", TO(record)},
    {"size", 's', OPTION_SIZE, "WIDTHxHEIGHT", "the picture's size, #; default the display's, 640x480 for a file",
     PAIR(width, height), .max = TIA_SIZE_MAX},
    {"thumbnail", 0, OPTION_NUMBER, "SIZE",
     "draw SCENE, which need not be trusted, as a .png of at most this width and height, #", TO(thumbnail),
     .min = THUMBNAIL_MIN, .max = THUMBNAIL_MAX},
    {"eye", 0, OPTION_PARSED, "X,Y,Z", "put the eye there, in the scene's coordinates",
     PARSED(eye.change.eye, set_place), GIVEN(eye.change.has_eye), .rule = "not a place (X,Y,Z, like 0,2.5,-8)"},
    {"look", 0, OPTION_PARSED, "X,Y,Z", "look at this point", PARSED(eye.change.reference, set_place),
     GIVEN(eye.change.has_reference), .rule = "not a place (X,Y,Z, like 0,2.5,-8)"},
    {"up", 0, OPTION_PARSED, "X,Y,Z", "the direction that is up in the picture", PARSED(eye.change.up, set_up),
     GIVEN(eye.change.has_up), .rule = "not a direction (X,Y,Z, not all 0, like 0,0,1)"},
    {"fov", 0, OPTION_DECIMAL, "DEGREES", "the vertical field of view, 1 to 170", TO(eye.change.fov),
     .min = TIA_FOV_MIN, .max = TIA_FOV_MAX, .rule = "not an angle (1 to 170 degrees)"},
    {"orthographic", 0, OPTION_PARSED, "HEIGHT", "parallel rays, from a window of this height",
     PARSED(eye.change.height, set_height), .rule = "not a height (above 0, like 2.5)"},
    {"fit", 0, OPTION_FLAG, NULL, "move the eye so that the whole scene is seen, from the same direction", TO(eye.fit)},
    {"samples", 0, OPTION_NUMBER, "1|4|16", "rays per pixel, for antialiasing; default the scene's", TO(samples),
     .max = TIA_SAMPLES_MAX},
    {"depth", 0, OPTION_NUMBER, "N", "reflections and refractions along a path, #; default the scene's", TO(depth),
     .min = 1, .max = TIA_DEPTH_MAX},
    {"integrator", 0, OPTION_PARSED, "whitted|ao|ao=DISTANCE|path", "the integrator; default the scene's",
     PARSED(integrator, set_integrator)},
    {"spp", 0, OPTION_NUMBER, "N", "samples per pixel of ao and path, #", TO(spp), .min = 1, .max = TIA_SPP_MAX},
    {"samples-range", 0, OPTION_RANGE, "FIRST-LAST", "draw only these samples, counted from 0, into a part (.tiapart)",
     PAIR(first_sample, last_sample), GIVEN(samples_range), .max = UINT32_MAX - 1},
    {"resume", 0, OPTION_TEXT, "FILE", "keep finished rows in FILE, and continue with them", TO(resume)},
    {"time-limit", 0, OPTION_DECIMAL, "SECONDS", "stop after that time; for ao and path", TO(time_limit), .min = 1,
     .max = INT32_MAX, .rule = "not a number of seconds (above 0, to 32767.999, like 10)"},
    {"error", 0, OPTION_DECIMAL, "PART", "stop at this estimated error, 0.02 for 2 percent; for ao and path", TO(error),
     .min = 1, .max = TIA_Q16_ONE, .rule = "not an error (0.0001 to 1, like 0.02)"},
    {"denoise", 0, OPTION_FLAG, NULL, "remove the noise of a .png, .ppm, .pfm or .exr; for ao and path", TO(denoise)},
    {"guide", 0, OPTION_CHOICE, "normal|depth|albedo|error", "draw this guide of the denoiser instead", TO(guide),
     .min = TIA_SHOW_NORMAL},
    {"tone", 0, OPTION_CHOICE, "linear|srgb", "the transfer function; for ao and path", TO(tone),
     .min = TIA_TONE_LINEAR},
    {"exposure", 0, OPTION_TEXT, "STOPS", "multiply the light by 2^STOPS; for ao and path", TO(exposure)},
    {"colour", 0, OPTION_CHOICE, "565|888|16", "bits per channel of a .png or .ppm", TO(colour), GIVEN(colour_given)},
    {"shadows", 0, OPTION_CHOICE, SHADOW_TECHNIQUES, "the shadow technique; default the scene's", TO(shadows),
     .min = 1},
    {"map-size", 0, OPTION_NUMBER, "64|128|256|512|1024|2048|4096", "texels along a shadow map's side", TO(map.size),
     .max = TIA_MAP_SIZE_MAX},
    {"bias", 0, OPTION_PARSED, "none|constant=A|slope=A|normal=A|plane=A", "the bias of shadow maps, and its amount",
     PARSED(map, set_bias), .rule = "not none, or constant, slope, normal or plane with an amount (slope=1.5)"},
    {"filter", 0, OPTION_CHOICE, "none|bilinear|3x3|5x5|7x7|poisson|pcss", "the filter of shadow maps", TO(map.filter),
     .min = TIA_FILTER_NONE},
    {"tessellated", 0, OPTION_TEXT, "ERROR",
     "draw curved shapes as flat faces at most ERROR from the surface, except with traced shadows; 0: by rays",
     TO(tessellated)},
    {"keys", 'k', OPTION_TEXT, "KEYS",
     "press these keys first: the scene's (a d s w) and <left> <right> <up> <down> <pgup> <pgdn>", TO(key_text)},
    {"input", 'i', OPTION_PARSED, "auto|evdev|tty|none[:DEVICE]", "the keyboard", PARSED(input, set_port)},
    {"frames", 'n', OPTION_NUMBER, "N", "stop after N frames; by default a film ends at the last keyframe", TO(frames),
     .min = 1, .max = UINT32_MAX},
    {"inline", 0, OPTION_FLAG, NULL, "print the picture into the terminal's scrollback, as -d terminal -n 1 does",
     TO(in_line)},
    {"time", 0, OPTION_DECIMAL, "SECONDS", "draw the scene at this time; a film begins there", TO(time),
     .max = INT32_MAX, .rule = "not a number of seconds (0 to 32767.999, like 1.25)"},
    {"fps", 0, OPTION_PARSED, "RATE",
     "frames per second of a film, 25 (default) or 30000/1001; on a screen without --frames, the target frame rate "
     "while things move",
     PARSED(rate, set_rate), GIVEN(rate_given), .rule = "not a rate (1 to 1000000 frames, like 25 or 30000/1001)"},
    {"frame-range", 0, OPTION_RANGE, "FIRST-LAST", "draw only these frames of a film, counted from 0",
     PAIR(first_frame, last_frame), GIVEN(frame_range), .max = UINT32_MAX - 1},
    {"tile-rows", 0, OPTION_RANGE, "FIRST-LAST", "draw only these rows of each picture, into a part",
     PAIR(first_row, last_row), GIVEN(tile_rows), .max = UINT32_MAX - 1},
    {"threads", 'j', OPTION_NUMBER, "N", "#; default: all processors", TO(threads), .min = 1, .max = THREADS_MAX},
    {"arithmetic", 0, OPTION_PARSED, "q16|f32|f64|f128", "fixed point (q16, the default) or floating point",
     PARSED(core, set_arithmetic)},
    {"dither", 0, OPTION_FLAG, NULL, "ordered dithering, to hide the banding of RGB565", TO(dither)},
    {"rotate", 0, OPTION_NUMBER, "0|90|180|270", "degrees clockwise", TO(rotate), .max = 270},
    {"connector", 0, OPTION_TEXT, "NAME|help", "the connector of a DRM device", TO(connector)},
    {"mode", 0, OPTION_PARSED, "preferred|WIDTHxHEIGHT[@HERTZ]|help", "the mode of a DRM device",
     PARSED(mode, set_mode), .rule = "not preferred, WxH or WxH@HERTZ (--mode help lists what there is)"},
    {"checksum", 0, OPTION_FLAG, NULL, "print each frame's number and CRC-32", TO(checksum)},
    {"stats", 0, OPTION_FLAG, NULL, "print one JSON object on standard error at the end", TO(stats)},
    {"stats-overlay", 0, OPTION_FLAG, NULL, "show times, frames per second and latency on the picture",
     TO(stats_overlay)},
    {"progress", 0, OPTION_FLAG, NULL,
     "show percent, time passed and left, on coarse pictures or, for a file, on standard error", TO(progress)},
    {"notify", 0, OPTION_FLAG, NULL, "beep, or notify, on the terminal when work of more than a second ends",
     TO(notify)},
    {"benchmark", 0, OPTION_FLAG, NULL,
     "measure this machine for about a minute, or --frames N of each: a table, and a line that tia-verify checks",
     TO(benchmark)},
    {"view", 0, OPTION_CHOICE, "colour|depth|normal|object|cost|light|path", "false colours", TO(views.view)},
    {"draw-rays", 0, OPTION_PIXEL, "X,Y", "draw the rays of this pixel into the picture", PAIR(views.x, views.y),
     GIVEN(views.draws_rays), .max = TIA_SIZE_MAX - 1},
    {"views", 0, OPTION_NUMBER, "N",
     "draw each of N views of a camera lightfield, into a name with %03d; NAME_qs8x6a0.75.png gets a quilt of 8 x 6 "
     "views",
     TO(light.views), .min = 1, .max = MODULES_MAX},
    {"lenticular", 0, OPTION_TEXT, "KEYS", "draw for a lenticular panel: " LENTICULAR_KEYS, TO(light.lenticular)},
    {"calibration", 0, OPTION_TEXT, "FILE", "draw for the panel of this visual.json of a Looking Glass",
     TO(light.calibration)},
    {"modules", 0, OPTION_TEXT, MODULES_KEYS, "draw a picture for each of M projectors behind the screen",
     TO(light.modules)},
    {"module-range", 0, OPTION_RANGE, "FIRST-LAST", "draw only these modules, counted from 0",
     PAIR(first_frame, last_frame), GIVEN(light.module_range), .max = MODULES_MAX - 1},
    {"gaze", 0, OPTION_PIXEL, "X,Y", "foveated rendering around this pixel; follows the mouse", PAIR(gaze.x, gaze.y),
     GIVEN(gazes), .max = UINT16_MAX},
    {"view-angle", 0, OPTION_DECIMAL, "DEGREES",
     "the angle that the picture's width subtends at the eye, 1 to 170; default 50", TO(gaze.view_angle),
     .min = TIA_FOV_MIN, .max = TIA_FOV_MAX, .rule = "not an angle (1 to 170 degrees)"},
    {"w0", 0, OPTION_DECIMAL, "DEGREES", "acuity w0 + m e: the smallest angle at the gaze; default 1/48", TO(gaze.w0),
     GIVEN(w0_given), .max = INT32_MAX, .bits = ACUITY_BITS, .rule = "not a number from 0 to 127 (like 0.0275)"},
    {"m", 0, OPTION_DECIMAL, "SLOPE", "acuity w0 + m e: the increase per degree off the gaze; default 0.0275",
     TO(gaze.m), GIVEN(m_given), .max = INT32_MAX, .bits = ACUITY_BITS,
     .rule = "not a number from 0 to 127 (like 0.0275)"},
    {"smooth", 0, OPTION_FLAG, NULL, "interpolate the pixels that are left out", TO(gaze.smooth)},
    {"watch", 0, OPTION_FLAG, NULL, "draw the scene again whenever one of its files changes", TO(watches)},
    {"write", 0, OPTION_TEXT, "FILE.tia", "write SCENE, a model, as a scene to edit; - is standard output", TO(write)},
    {"list-displays", 0, OPTION_FLAG, NULL, "list the displays, and why one cannot be opened", TO(action),
     .min = ACTION_LIST},
    {"scene-format", 0, OPTION_CHOICE, SCENE_FORMATS, "the format of SCENE, if its name has no such extension",
     TO(scene_format)},
    {"check", 0, OPTION_FLAG, NULL, "tell all mistakes of each SCENE, and draw nothing; exit status 0 or 1",
     TO(checks)},
    {"strict", 0, OPTION_FLAG, NULL, "treat warnings about the scene as errors", TO(strict)},
    OPTION_END_THEMES(help_themes, help_overview)};

const struct command tia_command = {"tia",
                                    "Usage: tia [options] [SCENE ...]\n"
                                    "Draws a ray-traced scene with integers only, on a screen or into a file. SCENE\n"
                                    "is a file, .tia, .nff, .obj, .stl, .ply, .off or .pgm, or another model's; or -\n"
                                    "for standard input; without it a ball on the ground is drawn. On a screen there\n"
                                    "may be several scenes: n and p show the next and the previous one.\n"
                                    "\n",
                                    rows, "\n" HELP_KEYS};
