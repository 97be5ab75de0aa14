#include "help.h"

#include <stddef.h>

const char help_overview[] = "Usage: tia [options] [SCENE ...]\n"
                             "Draws a ray-traced scene with integers only, on a screen or into a file.\n"
                             "SCENE is a file, .tia .nff .obj .stl .ply .off or .pgm; without it: a ball.\n"
                             "\n"
                             "  -o, --output FILE        draw into FILE: .png, .ppm, .exr, a film .y4m, ...\n"
                             "  -s, --size WIDTHxHEIGHT  the picture's size, like 640x480\n"
                             "  -d, --display NAME       drm, fbdev, terminal or none; by default what works\n"
                             "  -k, --keys KEYS          press these keys first: a d s w put the light\n"
                             "  -n, --frames N           stop after N frames\n"
                             "      --integrator path    path tracing\n"
                             "      --check              tell all mistakes of SCENE\n"
                             "      --watch              draw SCENE again whenever it changes\n"
                             "\n"
                             "Keys: a d s w put the light, arrows move it; in a SCENE ? shows all, q quits.\n"
                             "\n"
                             "tia --help THEME lists a theme's options, tia --help all those of all themes:\n";

const struct help_theme help_themes[] = {
    {"output", "files and their formats", "output format size colour record thumbnail resume write", NULL},
    {"picture", "size, samples, colours", "size samples depth colour arithmetic dither rotate", NULL},
    {"display", "screens and terminals",
     "display input fps inline dither rotate connector mode stats-overlay list-displays", NULL},
    {"keys", "keyboard and mouse", "keys input", HELP_KEYS},
    {"scene", "reading and checking it", "watch write scene-format check strict", NULL},
    {"eye", "the camera", "eye look up fov orthographic fit", NULL},
    {"time", "films and frame rates", "frames time fps frame-range", NULL},
    {"paths", "path tracing, its noise",
     "depth integrator spp samples-range resume time-limit error denoise guide tone exposure", NULL},
    {"shadows", "techniques, shadow maps", "shadows map-size bias filter tessellated", NULL},
    {"gaze", "foveated rendering", "gaze view-angle w0 m smooth", NULL},
    {"lightfield", "3D panels and projectors", "views lenticular calibration modules module-range", NULL},
    {"farm", "parts, for many machines", "samples-range resume frame-range tile-rows threads module-range", NULL},
    {"inspect", "false colours and rays", "checksum stats stats-overlay view draw-rays", NULL},
    {"speed", "threads and benchmarks", "threads arithmetic stats progress notify benchmark", NULL},
    {NULL, NULL, NULL, NULL}};
