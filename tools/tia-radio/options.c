#include "options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <tia/tia.h>

#include "common/image/image.h"
#include "common/message.h"
#include "common/parse.h"
#include "common/sink.h"
#include "refuse.h"
#include "wall_materials.h"

/* ---- values: each function returns NULL, or a message as in common/command_line.h ---- */

#define NEAR (2147483647.0 / 65536) /* limit of coordinates, in metres */
#define NEAR_AREA 32767.0

static const char *add_place(void *member, char *text)
{
    struct places *places = member;

    if (places->count == PLACES_MOST)
        return "one too many (at most 16)";
    return parse_reals(text, NEAR, places->metres[places->count++], 3) ? NULL : "";
}

static const char *set_frequency(void *member, char *text)
{
    static const char units[] = "kMG";
    static const double factors[] = {1e3, 1e6, 1e9};
    double *frequency = member;
    const char *at = text;
    bool fine = parse_real(&at, frequency);
    const char *unit = fine && *at != '\0' ? strchr(units, *at) : NULL;

    if (unit) {
        *frequency *= factors[unit - units];
        at++;
    }
    return fine && *at == '\0' && *frequency >= 1e6 && *frequency <= 1e12 ? NULL : "";
}

static const char *set_map(void *member, char *text)
{
    struct plane *map = member;

    map->axis = text[0] - 'x';
    return map->axis >= 0 && map->axis < 3 && text[1] == '=' && parse_reals(text + 2, NEAR, &map->at, 1) ? NULL : "";
}

static const char *set_area(void *member, char *text)
{
    double *area = member;

    return parse_reals(text, NEAR_AREA, area, 4) && area[0] < area[2] && area[1] < area[3] ? NULL : "";
}

static const char *set_range(void *member, char *text)
{
    double *range = member;

    return parse_reals(text, HUGE_VAL, range, 2) && range[0] < range[1] ? NULL : "";
}

/* Parses one of "permittivity:5", "conductivity:0.1", "thickness:0.2". */
static bool parse_property(const char *text, size_t length, struct naming *naming)
{
    static const char *const words[] = {"permittivity:", "conductivity:", "thickness:"};
    static const double most[] = {1e6, 1e12, 1000};
    double *values[] = {&naming->permittivity, &naming->conductivity, &naming->thickness};

    for (int i = 0; i < 3; i++) {
        size_t word = strlen(words[i]);
        const char *at = text + word;
        if (length > word && strncmp(text, words[i], word) == 0)
            return parse_real(&at, values[i]) && at == text + length && *values[i] >= (i == 0 ? 1 : 0) &&
                   *values[i] <= most[i] && (i < 2 || *values[i] > 0);
    }
    return false;
}

static const char *add_material(void *member, char *text)
{
    struct namings *namings = member;
    const char *equals = strchr(text, '='), *at = equals ? equals + 1 : text;

    if (namings->count == NAMES_MOST)
        return "one too many (at most 64)";
    struct naming *naming = &namings->array[namings->count++];
    *naming = (struct naming){.permittivity = 0};
    if (equals && (equals == text || (size_t)(equals - text) >= sizeof naming->name))
        return "";
    if (equals)
        memcpy(naming->name, text, (size_t)(equals - text));
    for (bool first = true; *at != '\0'; first = false) {
        size_t length = strcspn(at, ",");
        if (!parse_property(at, length, naming)) {
            if (!first || length == 0 || length >= sizeof naming->itu || memchr(at, ':', length))
                return "";
            memcpy(naming->itu, at, length);
            if (!itu_has(naming->itu))
                return "no such material (--materials lists them)";
        }
        at += length;
        at += *at == ',' && at[1] != '\0';
        if (*at == ',')
            return "";
    }
    return naming->itu[0] == '\0' && naming->permittivity == 0 ? "" : NULL;
}

/* ---- the table ---- */

#define TO(member) OPTION_TO(struct options, member)
#define GIVEN(member) .given = offsetof(struct options, member)
#define PLACE(member) TO(member), .parse = add_place, .rule = "not X,Y,Z in metres, within 32767 (1.5,2,-3)"

static const struct option_row rows[] = {
    {"tx", 0, OPTION_PARSED, "X,Y,Z", "the position of a transmitter; up to 16 times", PLACE(tx)},
    {"rx", 0, OPTION_PARSED, "X,Y,Z", "the position of a receiver; up to 16 times", PLACE(rx)},
    {"frequency", 'f', OPTION_PARSED, "FREQUENCY", "the frequency in hertz, or with k, M or G: 2.4G", TO(frequency),
     .parse = set_frequency, .rule = "not a frequency from 1M to 1000G (2.4G)"},
    {"reflections", 0, OPTION_NUMBER, "N", "the maximum number of reflections, # (default 2)", TO(order),
     .max = TIA_RADIO_ORDER_MAX},
    {"transmissions", 0, OPTION_NUMBER, "N", "the maximum number of walls on a path, # (default 0)", TO(walls),
     .max = TIA_RADIO_WALLS_MAX},
    {"method", 0, OPTION_CHOICE, "image|sbr|hybrid", "the method (default image)", TO(method), .min = METHOD_IMAGE},
    {"density", 0, OPTION_NUMBER, "N", "10 N^2 + 2 rays for sbr and hybrid, N # (default 64)", TO(density), .min = 1,
     .max = TIA_RADIO_DENSITY_MAX},
    {"material", 0, OPTION_PARSED, "[NAME=]WHAT",
     "the properties of the scene's material NAME, or of all materials: a material of ITU-R P.2040-3 or "
     "permittivity:E,conductivity:S; then ,thickness:M",
     TO(namings), .parse = add_material,
     .rule = "not [NAME=]MATERIAL[,thickness:M] or [NAME=]permittivity:E,conductivity:S"},
    {"materials", 0, OPTION_FLAG, NULL, "list those materials and their frequencies", TO(lists)},
    {"up", 0, OPTION_CHOICE, "y|z", "the vertical axis (default y)", TO(up), .min = 1},
    {"polarization", 0, OPTION_CHOICE, "vertical|horizontal", "the polarisation of maps (default vertical)",
     TO(horizontal)},
    {"json", 0, OPTION_FLAG, NULL, "print JSON instead of a table", TO(json)},
    {"output", 'o', OPTION_TEXT, "FILE",
     "write the scene with its paths, or the map, as a picture (.png .ppm .bmp .565; a part of a map .tiapart)",
     TO(output)},
    {"size", 's', OPTION_SIZE, "WIDTHxHEIGHT", "the size of the picture or map (default 640x480)",
     OPTION_PAIR(struct options, width, height), GIVEN(has_size), .max = TIA_SIZE_MAX},
    {"map", 0, OPTION_PARSED, "AXIS=AT", "a map of the gain across AXIS, x, y or z", TO(map), .parse = set_map,
     .rule = "not x=, y= or z= and a number (y=1.5)"},
    {"area", 0, OPTION_PARSED, "A0,B0,A1,B1",
     "the area of the map along the other two axes (default: the extent of all objects but planes)", TO(area),
     .parse = set_area, GIVEN(has_area), .rule = "not A0,B0,A1,B1 in metres, rising, within 32767"},
    {"csv", 0, OPTION_TEXT, "FILE", "write the map's values; - is standard output", TO(csv)},
    {"range", 0, OPTION_PARSED, "LOW,HIGH", "the range of the map's colours in dB (default -140,-40)", TO(range),
     .parse = set_range, .rule = "not LOW,HIGH in dB (-120,-60)"},
    {"best-server", 0, OPTION_FLAG, NULL, "colour the map by the best transmitter instead of the gain",
     TO(best_server)},
    {"tile-rows", 0, OPTION_RANGE, "FIRST-LAST", "draw only these rows of the map, into a .tiapart file for tia-join",
     OPTION_PAIR(struct options, first_row, last_row), GIVEN(has_rows), .max = TIA_SIZE_MAX - 1},
    {"verify", 0, OPTION_TEXT, "FILE", "compute random rows of the map again, and compare their bits with this picture",
     TO(verify)},
    CHOICE_ROWS(struct options, choice),
    {"threads", 'j', OPTION_NUMBER, "N", "the number of threads, # (default: one per processor)", TO(threads), .min = 1,
     .max = THREADS_MAX},
    OPTION_END};

static const struct command command = {"tia-radio",
                                       "Usage: tia-radio SCENE --tx X,Y,Z --rx X,Y,Z --frequency HZ [OPTION...]\n"
                                       "       tia-radio SCENE --tx X,Y,Z --map y=HEIGHT --frequency HZ [OPTION...]\n"
                                       "Finds the paths of radio waves by reflection at flat faces, and their fields.\n"
                                       "Lengths are in metres.\n"
                                       "\n",
                                       rows,
                                       "\n"
                                       "Exit status: 0 success, 1 failure, 2 usage error or a scene that is not\n"
                                       "usable.\n"};

static int list_materials(void)
{
    (void)printf("# ITU-R P.2040-3, Table 3: permittivity a f^b, conductivity c f^d S/m, f in GHz\n"
                 "%-18s %8s %8s %8s %6s %9s %8s\n",
                 "material", "from GHz", "to GHz", "a", "b", "c", "d");
    for (const struct itu_row *row = itu_rows; row->name; row++)
        (void)printf("%-18s %8g %8g %8g %6g %9g %8g\n", row->name, row->low, row->high, row->a, row->b, row->c, row->d);
    return message_output("tia-radio", "");
}

static int check_verify(const struct options *o)
{
    const char *why = choice_check(&o->choice);

    if (why)
        return refuse(REFUSED, "%s", why);
    if (o->output || o->csv || o->has_rows)
        return refuse(REFUSED, "--verify: compares a picture, without --output, --csv and --tile-rows");
    return o->method == METHOD_SBR ? refuse(REFUSED, "--map: needs exact paths (--method image or hybrid)") : FINE;
}

static int check_map(const struct options *o)
{
    if (o->map.axis < 0)
        return o->csv || o->has_area || o->best_server || o->has_rows || o->verify
                   ? refuse(REFUSED,
                            "--csv, --area, --best-server, --tile-rows and --verify are for maps (--map y=1.5)")
                   : FINE;
    if (o->rx.count > 0 || o->json)
        return refuse(REFUSED, "--map: its pixels are the receivers (without --rx and --json)");
    if (o->verify)
        return check_verify(o);
    if (!o->output && !o->csv)
        return refuse(REFUSED, "--map: needs --output FILE or --csv FILE");
    if (sink_is_same(o->output, o->csv))
        return refuse(REFUSED, "--csv: needs a file of its own");
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
    if (argc == 0)
        return refuse(REFUSED, "no scene is named (tia-radio -h)");
    o->scene = argv[0];
    if (argc > 1)
        return refuse(REFUSED, "%.200s: one scene at a time", argv[1]);
    if (o->tx.count == 0)
        return refuse(REFUSED, "--tx: is missing (tia-radio -h)");
    if (o->rx.count == 0 && o->map.axis < 0)
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
                          .map = {.axis = -1},
                          .width = 640,
                          .height = 480,
                          .range = {-140, -40},
                          .threads = threads_processors(),
                          .format = IMAGE_UNKNOWN};
    int result = command_parse(&command, o, &argc, &argv);
    if (result != COMMAND_RUN)
        return result;
    if (o->lists)
        return list_materials();
    result = check(o, argc, argv);
    return result == FINE ? COMMAND_RUN : result;
}
