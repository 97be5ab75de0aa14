/* tia-compile - converts a scene file to const tables in C, for programs without a file system. */
#include "common/convert.h"
#include "memory.h"
#include "unit.h"

static const char usage[] =
    "Usage: tia-compile SCENE -o FILE.c [--name SYMBOL]\n"
    "       tia-compile SCENE --memory FILE.h [--name SYMBOL] [--lights N] [-s WIDTHxHEIGHT]...\n"
    "Writes a scene as C: const tables, all that is in it and its hierarchy of boxes, as\n"
    "`const struct tia_scene SYMBOL`. It needs nothing but tia's public headers.\n"
    "\n"
    "  -o, --output FILE.c      - is standard output\n"
    "      --name SYMBOL        default: scene\n"
    "      --memory FILE.h      how many bytes it takes to draw the scene, as macros: SYMBOL_VIEW and,\n"
    "                           for each size, SYMBOL_HITS_320x240 and SYMBOL_VIEWER_320x240\n"
    "  -s, --size WIDTHxHEIGHT  of a picture or a tile; again for more\n"
    "      --lights N           at most so many at once; default: the scene's, and one for each key\n"
    "      --scene-format tia|nff|obj   when the scene's name does not say\n"
    "      --strict             refuse what is only warned of otherwise\n"
    "  -h, --help, -V, --version\n"
    "\n"
    "Exit status: 0 fine, 1 failed, 2 wrong usage or no scene.\n";

/* A hierarchy of so few objects is a single box around them all: a waste of flash. */
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
    static const struct converter converter = {"tia-compile", usage, "scene", write_unit, write_memory};

    return convert(&converter, argc, argv);
}
