/* tia-compile - converts a scene file to const tables in C, for programs without a file system. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include <tia/render.h>

#include "common/convert.h"
#include "common/parse.h"
#include "scene_memory.h"
#include "unit.h"

#define LIGHTS_MOST 65535

static const char *set_name(void *symbol, char *value)
{
    static const char keywords[] =
        " auto break case char const continue default do double else enum extern float for goto if inline int long "
        "register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while ";
    char word[68];
    size_t length = strlen(value);
    bool fine = length > 0 && length < 64;

    for (size_t i = 0; i < length; i++)
        fine = fine &&
               (isalpha((unsigned char)value[i]) || value[i] == '_' || (i > 0 && isdigit((unsigned char)value[i])));
    (void)snprintf(word, sizeof word, " %.64s ", value);
    *(const char **)symbol = value;
    return fine && !strstr(keywords, word) ? NULL : "";
}

static const char *add_size(void *member, char *value)
{
    struct convert_tiles *tiles = member;
    uint16_t *size = tiles->count < CONVERT_TILES ? tiles->size[tiles->count++] : NULL;

    return size && parse_size(value, NULL, TIA_SIZE_MAX, &size[0], &size[1]) ? NULL : "";
}

static const struct option_row rows[] = {
    {"output", 'o', OPTION_TEXT, "FILE.c", "the file to write; - is standard output", CONVERT_TO(output)},
    {"memory", 0, OPTION_TEXT, "FILE.h",
     "write the memory sizes of the scene as macros: SYMBOL_VIEW, SYMBOL_STACK and, for each size, "
     "SYMBOL_ROWS_320, SYMBOL_HITS_320x240 and SYMBOL_VIEWER_320x240",
     CONVERT_TO(memory)},
    {"size", 's', OPTION_PARSED, "WIDTHxHEIGHT", "the size of a picture or a tile; up to 16 times", CONVERT_TO(tiles),
     .parse = add_size, .rule = "not a size (1x1 to 8192x8192, like 320x240), or one of more than 16"},
    {"lights", 0, OPTION_NUMBER, "N", "the maximum number of lights; default: the scene's, plus one for each key line",
     CONVERT_TO(lights), .min = 1, .max = LIGHTS_MOST},
    {"name", 0, OPTION_PARSED, "SYMBOL", "default: scene", CONVERT_TO(symbol), .parse = set_name,
     .rule = "not a name in C, of less than 64 letters"},
    CONVERT_END};

static const struct command command = {
    "tia-compile",
    "Usage: tia-compile SCENE -o FILE.c [--name SYMBOL]\n"
    "       tia-compile SCENE --memory FILE.h [--name SYMBOL] [--lights N] [-s WIDTHxHEIGHT]...\n"
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
    int status = text_open(&unit.text, request->output, why);

    if (status)
        return status;
    unit.symbol = request->symbol;
    unit.scene = &compiled;
    unit_write(&unit, request->source);
    return text_close(&unit.text);
}

int main(int argc, char **argv)
{
    static const struct converter converter = {&command, "scene", write_unit, write_memory};

    return convert(&converter, argc, argv);
}
