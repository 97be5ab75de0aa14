#include "arguments.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <tia/tia.h>

#include "common/image/image.h"
#include "common/message.h"
#include "fail.h"
#include "materials.h"
#include "values.h"

static const char usage[] =
    "Usage: tia-radio SCENE --tx X,Y,Z --rx X,Y,Z --frequency HZ [OPTION...]\n"
    "       tia-radio SCENE --tx X,Y,Z --map y=HEIGHT --frequency HZ [OPTION...]\n"
    "Finds the paths of radio waves by reflection at flat faces, and what arrives. Lengths are in metres.\n"
    "\n"
    "      --tx X,Y,Z         a transmitter; up to 16 of them\n"
    "      --rx X,Y,Z         a receiver; up to 16 of them\n"
    "  -f, --frequency HZ     in hertz, or with k, M or G: 2.4G\n"
    "      --reflections N    at most so many, 0-8 (default 2)\n"
    "      --transmissions N  goes through at most so many walls, 0-8 (default 0)\n"
    "      --method METHOD    image, sbr or hybrid (default image)\n"
    "      --density N        rays of sbr and hybrid: 10 N^2 + 2, N 1-2048 (default 64)\n"
    "      --material [NAME=]WHAT   what the scene's material NAME is, or all materials: a material of\n"
    "                         ITU-R P.2040-3 or permittivity:E,conductivity:S; then ,thickness:M\n"
    "      --materials        lists those materials and their frequencies\n"
    "      --up AXIS          what is vertical: y or z (default y)\n"
    "      --polarization P   of maps: vertical or horizontal (default vertical)\n"
    "      --json             JSON instead of a table\n"
    "  -o, --output FILE      the scene with its paths, or the map, as a picture (.png .ppm .bmp .565; a\n"
    "                         part of a map .tiapart)\n"
    "  -s, --size WxH         of the picture or map (default 640x480)\n"
    "      --map AXIS=AT      a map of the gain across AXIS, x, y or z\n"
    "      --area A0,B0,A1,B1   of the map along the other two axes (default: what boxes and triangles\n"
    "                         take up)\n"
    "      --csv FILE         the map's numbers; - is standard output\n"
    "      --range LOW,HIGH   of the map's colours in dB (default -140,-40)\n"
    "      --best-server      paints which transmitter is best, not how good it is\n"
    "      --tile-rows A-B    draws these rows of the map alone; tia-join joins such .tiapart files\n"
    "  -j, --threads N        1-1024 (default: one a processor)\n"
    "  -h, --help, -V, --version\n"
    "\n"
    "Exit status: 0 fine, 1 failure, 2 wrong usage or a scene that will not do.\n";

enum {
    TX = 256,
    RX,
    REFLECTIONS,
    TRANSMISSIONS,
    METHOD,
    DENSITY,
    MATERIAL,
    MATERIALS,
    UP,
    POLARIZATION,
    JSON,
    MAP,
    AREA,
    CSV,
    RANGE,
    BEST_SERVER,
    TILE_ROWS
};

static const struct option longs[] = {{"tx", required_argument, NULL, TX},
                                      {"rx", required_argument, NULL, RX},
                                      {"frequency", required_argument, NULL, 'f'},
                                      {"reflections", required_argument, NULL, REFLECTIONS},
                                      {"transmissions", required_argument, NULL, TRANSMISSIONS},
                                      {"method", required_argument, NULL, METHOD},
                                      {"density", required_argument, NULL, DENSITY},
                                      {"material", required_argument, NULL, MATERIAL},
                                      {"materials", no_argument, NULL, MATERIALS},
                                      {"up", required_argument, NULL, UP},
                                      {"polarization", required_argument, NULL, POLARIZATION},
                                      {"json", no_argument, NULL, JSON},
                                      {"output", required_argument, NULL, 'o'},
                                      {"size", required_argument, NULL, 's'},
                                      {"map", required_argument, NULL, MAP},
                                      {"area", required_argument, NULL, AREA},
                                      {"csv", required_argument, NULL, CSV},
                                      {"range", required_argument, NULL, RANGE},
                                      {"best-server", no_argument, NULL, BEST_SERVER},
                                      {"tile-rows", required_argument, NULL, TILE_ROWS},
                                      {"threads", required_argument, NULL, 'j'},
                                      {"help", no_argument, NULL, 'h'},
                                      {"version", no_argument, NULL, 'V'},
                                      {0}};

static int list_materials(void)
{
    (void)printf("# ITU-R P.2040-3, Table 3: permittivity a f^b, conductivity c f^d S/m, f in GHz\n"
                 "%-18s %8s %8s %8s %6s %9s %8s\n",
                 "material", "from GHz", "to GHz", "a", "b", "c", "d");
    for (const struct itu_row *row = itu_rows; row->name; row++)
        (void)printf("%-18s %8g %8g %8g %6g %9g %8g\n", row->name, row->low, row->high, row->a, row->b, row->c, row->d);
    return message_output("tia-radio", "") ? FAILED : -1;
}

/* ---- the command line ---- */

static int parse_words(struct options *o, int option, const char *text)
{
    switch (option) {
    case METHOD:
        for (o->method = METHOD_IMAGE; o->method < METHODS; o->method++)
            if (strcmp(text, method_name(o->method)) == 0)
                return FINE;
        return wrong("--method", text, "not image, sbr or hybrid");
    case UP:
        o->up = text[0] - 'x';
        return strcmp(text, "y") == 0 || strcmp(text, "z") == 0 ? FINE : wrong("--up", text, "not y or z");
    case POLARIZATION:
        o->horizontal = strcmp(text, "horizontal") == 0;
        return o->horizontal || strcmp(text, "vertical") == 0
                   ? FINE
                   : wrong("--polarization", text, "not vertical or horizontal");
    case AREA:
        o->has_area = parse_numbers(text, o->area, 4) && o->area[0] < o->area[2] && o->area[1] < o->area[3] &&
                      fabs(o->area[0]) < 32767 && fabs(o->area[1]) < 32767 && fabs(o->area[2]) < 32767 &&
                      fabs(o->area[3]) < 32767;
        return o->has_area ? FINE : wrong("--area", text, "not A0,B0,A1,B1 in metres, rising, within 32767");
    default: {
        double range[2];
        if (!parse_numbers(text, range, 2) || range[0] >= range[1])
            return wrong("--range", text, "not LOW,HIGH in dB (-120,-60)");
        o->low = range[0];
        o->high = range[1];
        return FINE;
    }
    }
}

static int parse_option(struct options *o, int option, char **argv)
{
    switch (option) {
    case TX:
        return parse_place("--tx", optarg, o->tx_at, &o->tx_count);
    case RX:
        return parse_place("--rx", optarg, o->rx_at, &o->rx_count);
    case 'f':
        return parse_frequency(optarg, &o->frequency);
    case REFLECTIONS:
        return parse_count("--reflections", optarg, 0, TIA_RADIO_ORDER_MAX, &o->order);
    case TRANSMISSIONS:
        return parse_count("--transmissions", optarg, 0, TIA_RADIO_WALLS_MAX, &o->walls);
    case DENSITY:
        return parse_count("--density", optarg, 1, TIA_RADIO_DENSITY_MAX, &o->density);
    case 'j':
        return parse_count("--threads", optarg, 1, THREADS_MAX, &o->threads);
    case MATERIAL:
        return parse_material(optarg, o);
    case 's':
        o->has_size = true;
        return parse_size(optarg, o);
    case MAP:
        return parse_map(optarg, o);
    case TILE_ROWS:
        return parse_rows(optarg, o);
    case JSON:
        o->json = true;
        return FINE;
    case BEST_SERVER:
        o->best_server = true;
        return FINE;
    case 'o':
        o->output = optarg;
        return FINE;
    case CSV:
        o->csv = optarg;
        return FINE;
    case ':':
    case '?':
        return message_option("tia-radio", option, argv);
    default:
        return parse_words(o, option, optarg);
    }
}

static int check_map(const struct options *o)
{
    if (o->map_axis < 0)
        return o->csv || o->has_area || o->best_server || o->has_rows
                   ? refuse(REFUSED, "--csv, --area, --best-server and --tile-rows are for maps (--map y=1.5)")
                   : FINE;
    if (o->rx_count > 0 || o->json)
        return refuse(REFUSED, "--map: its pixels are the receivers (without --rx and --json)");
    if (!o->output && !o->csv)
        return refuse(REFUSED, "--map: needs --output FILE or --csv FILE");
    if (o->method == METHOD_SBR)
        return refuse(REFUSED, "--map: needs exact paths (--method image or hybrid)");
    if (o->has_rows && o->last_row >= o->height)
        return refuse(REFUSED, "--tile-rows: the map has %u rows, 0-%u", o->height, o->height - 1u);
    return FINE;
}

static int check_output(struct options *o)
{
    if (!o->output)
        return FINE;
    o->format = image_format_of(o->output);
    if (o->format == IMAGE_UNKNOWN || !image_format_has(o->format, 0) || o->format == IMAGE_Y4M)
        return refuse(REFUSED, "%.200s: unknown picture format (name it .png, .ppm, .bmp, .565 or .tiapart)",
                      o->output);
    if (!image_format_built(o->format))
        return refuse(REFUSED, "%.200s: this build does not write such files (use .ppm)", o->output);
    if (o->has_rows != (o->format == IMAGE_PART))
        return refuse(REFUSED, "%.200s: parts are .tiapart files, drawn with --tile-rows", o->output);
    return FINE;
}

static int check(struct options *o, int argc, char **argv)
{
    if (optind >= argc)
        return refuse(REFUSED, "no scene is named (tia-radio -h)");
    o->scene = argv[optind++];
    if (optind < argc)
        return refuse(REFUSED, "%.200s: one scene at a time", argv[optind]);
    if (o->tx_count == 0)
        return refuse(REFUSED, "--tx: is missing (tia-radio -h)");
    if (o->rx_count == 0 && o->map_axis < 0)
        return refuse(REFUSED, "--rx: is missing, and so is --map (tia-radio -h)");
    if (o->frequency == 0)
        return refuse(REFUSED, "--frequency: is missing (tia-radio -h)");
    int result = check_map(o);
    return result != FINE ? result : check_output(o);
}

int arguments_parse(struct options *o, int argc, char **argv)
{
    *o = (struct options){.order = 2,
                          .density = 64,
                          .up = 1,
                          .map_axis = -1,
                          .width = 640,
                          .height = 480,
                          .low = -140,
                          .high = -40,
                          .threads = threads_processors(),
                          .format = IMAGE_UNKNOWN};
    int result = FINE;

    opterr = 0;
    for (int option; result == FINE && (option = getopt_long(argc, argv, ":f:o:s:j:hV", longs, NULL)) != -1;) {
        if (option == MATERIALS)
            return list_materials();
        if (option == 'h' || option == 'V')
            return message_output("tia-radio", option == 'h' ? usage : "tia-radio " TIA_VERSION "\n") ? FAILED : -1;
        result = parse_option(o, option, argv);
    }
    return result != FINE ? result : check(o, argc, argv);
}
