/* tia-compile - converts a scene file to const tables in C, for programs without a file system. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/render.h>

#include "common/convert.h"
#include "common/parse.h"
#include "scene_memory.h"
#include "unit.h"

#define LIGHTS_MOST 65535

/* True for a name of less than 64 letters that a program may give a table: one that C reserves is not. */
static bool is_name(const char *value)
{
    static const char keywords[] =
        " auto break case char const continue default do double else enum extern float for goto if inline int long "
        "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
        "NULL asm bool false main offsetof true ";
    char word[68];
    size_t length = strlen(value);
    bool fine = length > 0 && length < 64;

    for (size_t i = 0; i < length; i++)
        fine = fine &&
               (isalpha((unsigned char)value[i]) || value[i] == '_' || (i > 0 && isdigit((unsigned char)value[i])));
    (void)snprintf(word, sizeof word, " %.64s ", value);
    if (value[0] == '_' && (value[1] == '_' || isupper((unsigned char)value[1])))
        return false;
    return fine && !strstr(keywords, word);
}

static const char *set_name(void *symbol, char *value)
{
    *(const char **)symbol = value;
    return is_name(value) ? NULL : "";
}

static const char *add_size(void *member, char *value)
{
    struct convert_tiles *tiles = member;
    uint16_t *size = tiles->size[tiles->count];

    if (tiles->count == CONVERT_TILES)
        return "more than 16 sizes";
    tiles->count++;
    return parse_size(value, NULL, TIA_SIZE_MAX, &size[0], &size[1]) ? NULL : "";
}

static const char *set_picture(void *member, char *value)
{
    struct convert_telltales *all = member;

    return parse_size(value, NULL, TIA_SIZE_MAX, &all->width, &all->height) ? NULL : "";
}

/* Parses "NAME=X,Y,WIDTH,HEIGHT". */
static const char *add_rectangle(void *member, char *value)
{
    struct convert_telltales *all = member;
    char *equals = strchr(value, '=');
    const char *at = equals;
    uint32_t n[4];

    if (all->count == CONVERT_TELLTALES)
        return "more than 16 rectangles";
    if (!equals)
        return "";
    for (int i = 0; i < 4; i++)
        if ((i > 0 && *at != ',') || !parse_number(at + 1, i < 3 ? &at : NULL, i < 2 ? 0 : 1, TIA_SIZE_MAX, &n[i]))
            return "";
    *equals = '\0';
    for (unsigned i = 0; i < all->count; i++)
        if (strcmp(all->of[i].name, value) == 0)
            return "two rectangles of this name";
    all->of[all->count].name = value;
    all->of[all->count++].area = (struct tia_tile){(uint16_t)n[0], (uint16_t)n[1], (uint16_t)n[2], (uint16_t)n[3]};
    return is_name(value) ? NULL : "";
}

static const char *check_telltales(const struct request *request, const char **why)
{
    const struct convert_telltales *all = &request->telltales;

    *why = "it needs --rectangle and --output";
    if (all->width && (!all->count || !request->output))
        return "--crc";
    *why = "it needs --crc";
    if (!all->width && all->count)
        return "--rectangle";
    *why = "a rectangle is not inside the picture";
    for (unsigned i = 0; i < all->count; i++)
        if ((uint32_t)all->of[i].area.x + all->of[i].area.width > all->width ||
            (uint32_t)all->of[i].area.y + all->of[i].area.height > all->height)
            return "--rectangle";
    return NULL;
}

static const struct option_row rows[] = {
    {"output", 'o', OPTION_TEXT, "FILE.c", "the file to write; - is standard output", CONVERT_TO(output)},
    {"memory", 0, OPTION_TEXT, "FILE.h",
     "write the memory sizes of the scene as macros: SYMBOL_VIEW, SYMBOL_STACK and, for each size, "
     "SYMBOL_ROWS_320, SYMBOL_HITS_320x240 and SYMBOL_VIEWER_320x240",
     CONVERT_TO(memory)},
    {"size", 's', OPTION_PARSED, "WIDTHxHEIGHT", "the size of a picture or a tile; up to 16 times", CONVERT_TO(tiles),
     .parse = add_size, .rule = "not a size (1x1 to 8192x8192, like 320x240)"},
    {"lights", 0, OPTION_NUMBER, "N", "the maximum number of lights; default: the scene's, plus one for each key line",
     CONVERT_TO(lights), .min = 1, .max = LIGHTS_MOST},
    {"name", 0, OPTION_PARSED, "SYMBOL", "default: scene", CONVERT_TO(symbol), .parse = set_name,
     .rule = "not a name in C, of less than 64 letters"},
    {"crc", 0, OPTION_PARSED, "WIDTHxHEIGHT",
     "write SYMBOL_telltales, too: the CRC-32 of each rectangle of a picture of this size, without and after each key",
     CONVERT_TO(telltales), .parse = set_picture, .rule = "not a size (1x1 to 8192x8192, like 320x240)"},
    {"rectangle", 0, OPTION_PARSED, "NAME=X,Y,WIDTH,HEIGHT", "a rectangle for --crc; up to 16 times",
     CONVERT_TO(telltales), .parse = add_rectangle,
     .rule = "not a rectangle (a name in C, and four numbers, like ball=100,60,120,80)"},
    CONVERT_END};

static const struct command command = {"tia-compile",
                                       "Usage: tia-compile SCENE -o FILE.c [--name SYMBOL]\n"
                                       "       tia-compile SCENE -o FILE.c --crc WIDTHxHEIGHT\n"
                                       "                   --rectangle NAME=X,Y,WIDTH,HEIGHT...\n"
                                       "       tia-compile SCENE --memory FILE.h [--name SYMBOL] [--lights N]\n"
                                       "                   [-s WIDTHxHEIGHT]...\n"
                                       "Writes a scene as C: const tables, with its bounding volume hierarchy, as\n"
                                       "`const struct tia_scene SYMBOL`. The file needs only tia's public headers.\n"
                                       "\n",
                                       rows, CONVERT_NOTES};

/* Largest number of objects without a hierarchy: it would be a single box around them all, a waste of flash. */
#define FEW 4

static struct tia_scene compiled_scene(const struct tia_scene *scene)
{
    struct tia_scene compiled = *scene;

    if (scene->sphere_count + scene->shape_count <= FEW && scene->mesh_count == 0)
        compiled.bvh = NULL;
    return compiled;
}

static int write_memory(const struct request *request, const struct tia_scene *scene, char *why)
{
    struct tia_scene compiled = compiled_scene(scene);

    return memory_write(request, &compiled, why);
}

static int write_unit(const struct request *request, const struct tia_scene *scene, char *why)
{
    static struct unit unit;
    struct tia_scene compiled = compiled_scene(scene);
    const struct convert_telltales *all = request->telltales.width ? &request->telltales : NULL;
    uint32_t *crcs = all ? telltales_draw(scene, all, why) : NULL;

    if (all && !crcs)
        return TIA_ERR_MEMORY;
    int status = text_open(&unit.text, request->output, why);
    if (!status) {
        unit.symbol = request->symbol;
        unit.scene = &compiled;
        unit_write(&unit, request->source, all, crcs);
        status = text_close(&unit.text);
    }
    free(crcs);
    return status;
}

int main(int argc, char **argv)
{
    static const struct converter converter = {&command, "scene", write_unit, write_memory, check_telltales};

    return convert(&converter, argc, argv);
}
