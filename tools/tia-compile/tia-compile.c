/* tia-compile - converts a scene file to const tables in C, for programs without a file system. */
#include "common/convert.h"
#include "unit.h"

static const char usage[] = "Usage: tia-compile SCENE -o FILE.c [--name SYMBOL]\n"
                            "Writes a scene as C: const tables, all that is in it and its hierarchy of boxes, as\n"
                            "`const struct tia_scene SYMBOL`. It needs nothing but tia's public headers.\n"
                            "\n"
                            "  -o, --output FILE.c      - is standard output\n"
                            "      --name SYMBOL        default: scene\n"
                            "      --scene-format tia|nff|obj   when the scene's name does not say\n"
                            "      --strict             refuse what is only warned of otherwise\n"
                            "  -h, --help, -V, --version\n"
                            "\n"
                            "Exit status: 0 fine, 1 failed, 2 wrong usage or no scene.\n";

/* A hierarchy of so few objects is a single box around them all: a waste of flash. */
#define FEW 4

static int write_unit(const struct request *request, const struct tia_scene *scene, char *why)
{
    static struct unit unit;
    struct tia_scene compiled = *scene;
    int status = text_open(&unit.text, request->output, why);

    if (status)
        return status;
    if (scene->sphere_count + scene->shape_count <= FEW && scene->mesh_count == 0)
        compiled.bvh = NULL;
    unit.symbol = request->symbol;
    unit.scene = &compiled;
    unit_write(&unit, request->source);
    return text_close(&unit.text);
}

int main(int argc, char **argv)
{
    static const struct converter converter = {"tia-compile", usage, "scene", write_unit};

    return convert(&converter, argc, argv);
}
