#include "options.h"

#include <getopt.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/tia.h>

#include "common/image/image.h"
#include "materials.h"

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

int refuse(int status, const char *format, ...)
{
    char text[1400];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
    (void)fprintf(stderr, "tia-radio: %s\n", text);
    return status;
}

const char *method_name(enum method method)
{
    static const char *const names[METHODS] = {"image", "sbr", "hybrid"};

    return names[method];
}

static int wrong(const char *option, const char *value, const char *rule)
{
    return refuse(REFUSED, "%s: %.200s: %s", option, value, rule);
}

/* ---- values ---- */

/* A decimal number at *text, which goes on behind it. */
static bool take_number(const char **text, double *value)
{
    char *end;

    *value = strtod(*text, &end);
    if (end == *text || !isfinite(*value))
        return false;
    *text = end;
    return true;
}

/* As many numbers with commas between them, and nothing else. */
static bool parse_numbers(const char *text, double *values, int count)
{
    for (int i = 0; i < count; i++)
        if ((i > 0 && *text++ != ',') || !take_number(&text, &values[i]))
            return false;
    return *text == '\0';
}

static bool to_q16(double metres, tia_q16 *out)
{
    double units = metres * 65536;

    if (fabs(units) >= 2147483647.0)
        return false;
    *out = (tia_q16)llround(units);
    return true;
}

static int parse_place(const char *option, const char *text, struct tia_vec3 *places, unsigned *count)
{
    double at[3];
    struct tia_vec3 place;

    if (*count == PLACES_MOST)
        return wrong(option, text, "one too many (at most 16)");
    if (!parse_numbers(text, at, 3) || !to_q16(at[0], &place.x) || !to_q16(at[1], &place.y) || !to_q16(at[2], &place.z))
        return wrong(option, text, "not X,Y,Z in metres, within 32767 (1.5,2,-3)");
    places[(*count)++] = place;
    return FINE;
}

static int parse_count(const char *option, const char *text, uint32_t low, uint32_t high, uint32_t *value)
{
    char *end;
    unsigned long number = strtoul(text, &end, 10);

    if (*text < '0' || *text > '9' || *end != '\0' || number < low || number > high)
        return refuse(REFUSED, "%s: %.200s: not a number from %u to %u", option, text, (unsigned)low, (unsigned)high);
    *value = (uint32_t)number;
    return FINE;
}

static int parse_frequency(const char *text, double *frequency)
{
    static const char units[] = "kMG";
    static const double factors[] = {1e3, 1e6, 1e9};
    const char *at = text;
    bool fine = take_number(&at, frequency);
    const char *unit = fine && *at != '\0' ? strchr(units, *at) : NULL;

    if (unit) {
        *frequency *= factors[unit - units];
        at++;
    }
    if (!fine || *at != '\0' || *frequency < 1e6 || *frequency > 1e12)
        return wrong("--frequency", text, "not a frequency from 1M to 1000G (2.4G)");
    return FINE;
}

static int parse_size(const char *text, struct options *o)
{
    unsigned width, height;
    char rest;

    if (text[0] < '1' || text[0] > '9' || sscanf(text, "%5ux%5u%c", &width, &height, &rest) != 2 || height == 0 ||
        width > TIA_SIZE_MAX || height > TIA_SIZE_MAX)
        return wrong("--size", text, "not WIDTHxHEIGHT, each 1 to 8192");
    o->width = (uint16_t)width;
    o->height = (uint16_t)height;
    return FINE;
}

static int parse_map(const char *text, struct options *o)
{
    double at;

    if (text[0] < 'x' || text[0] > 'z' || text[1] != '=' || !parse_numbers(text + 2, &at, 1) || !to_q16(at, &o->map_at))
        return wrong("--map", text, "not x=, y= or z= and a number (y=1.5)");
    o->map_axis = text[0] - 'x';
    return FINE;
}

static int parse_rows(const char *text, struct options *o)
{
    unsigned first, last;
    char rest;

    if (text[0] < '0' || text[0] > '9' || sscanf(text, "%5u-%5u%c", &first, &last, &rest) != 2 || first > last ||
        last >= TIA_SIZE_MAX)
        return wrong("--tile-rows", text, "not FIRST-LAST (0-99)");
    o->has_rows = true;
    o->first_row = (uint16_t)first;
    o->last_row = (uint16_t)last;
    return FINE;
}

/* ---- materials ---- */

/* One of "permittivity:5", "conductivity:0.1", "thickness:0.2". */
static bool parse_property(const char *text, size_t length, struct naming *naming)
{
    static const char *const words[] = {"permittivity:", "conductivity:", "thickness:"};
    static const double most[] = {1e6, 1e12, 1000};
    double *values[] = {&naming->permittivity, &naming->conductivity, &naming->thickness};

    for (int i = 0; i < 3; i++) {
        size_t word = strlen(words[i]);
        const char *at = text + word;
        if (length > word && strncmp(text, words[i], word) == 0)
            return take_number(&at, values[i]) && at == text + length && *values[i] >= (i == 0 ? 1 : 0) &&
                   *values[i] <= most[i] && (i < 2 || *values[i] > 0);
    }
    return false;
}

static int parse_material(const char *text, struct options *o)
{
    static const char rule[] = "not [NAME=]MATERIAL[,thickness:M] or [NAME=]permittivity:E,conductivity:S";
    const char *equals = strchr(text, '='), *at = equals ? equals + 1 : text;
    struct naming *naming = &o->namings[o->naming_count];

    if (o->naming_count == NAMES_MOST)
        return wrong("--material", text, "one too many (at most 64)");
    *naming = (struct naming){.permittivity = 0};
    if (equals && (equals == text || (size_t)(equals - text) >= sizeof naming->name))
        return wrong("--material", text, rule);
    if (equals)
        memcpy(naming->name, text, (size_t)(equals - text));
    for (bool first = true; *at != '\0'; first = false) {
        size_t length = strcspn(at, ",");
        if (!parse_property(at, length, naming)) {
            if (!first || length == 0 || length >= sizeof naming->itu || memchr(at, ':', length))
                return wrong("--material", text, rule);
            memcpy(naming->itu, at, length);
            if (!itu_has(naming->itu))
                return refuse(REFUSED, "--material: %.100s: no such material (--materials lists them)", naming->itu);
        }
        at += length;
        at += *at == ',' && at[1] != '\0';
        if (*at == ',')
            return wrong("--material", text, rule);
    }
    if (naming->itu[0] == '\0' && naming->permittivity == 0)
        return wrong("--material", text, rule);
    o->naming_count++;
    return FINE;
}

static int list_materials(void)
{
    (void)printf("# ITU-R P.2040-3, Table 3: permittivity a f^b, conductivity c f^d S/m, f in GHz\n"
                 "%-18s %8s %8s %8s %6s %9s %8s\n",
                 "material", "from GHz", "to GHz", "a", "b", "c", "d");
    for (const struct itu_row *row = itu_rows; row->name; row++)
        (void)printf("%-18s %8g %8g %8g %6g %9g %8g\n", row->name, row->low, row->high, row->a, row->b, row->c, row->d);
    return fflush(stdout) != 0 ? refuse(FAILED, "standard output: cannot be written") : -1;
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
        return parse_place("--tx", optarg, o->tx, &o->tx_count);
    case RX:
        return parse_place("--rx", optarg, o->rx, &o->rx_count);
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
        return refuse(REFUSED, "%.200s: a value is missing (tia-radio -h shows which)", argv[optind - 1]);
    case '?':
        return refuse(REFUSED, "%.200s: unknown option (tia-radio -h lists them)", argv[optind - 1]);
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

int options_parse(struct options *o, int argc, char **argv)
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
        if (option == 'h' || option == 'V') {
            (void)fputs(option == 'h' ? usage : "tia-radio " TIA_VERSION "\n", stdout);
            return fflush(stdout) != 0 ? refuse(FAILED, "standard output: cannot be written") : -1;
        }
        result = parse_option(o, option, argv);
    }
    return result != FINE ? result : check(o, argc, argv);
}
