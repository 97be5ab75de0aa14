/* tia-pov - converts a scene file to POV-Ray's language, so that an independent renderer can draw it. */
#include "common/convert.h"
#include "pov.h"

static const char usage[] = "Usage: tia-pov SCENE -o FILE.pov\n"
                            "Writes a scene in POV-Ray's language, version 3.7. What that cannot say is a comment\n"
                            "there and a line on standard error. Pictures become FILE-N.ppm or .pgm beside it.\n"
                            "\n"
                            "  -o, --output FILE.pov    - is standard output, without pictures\n"
                            "      --scene-format tia|nff|obj   when the scene's name does not say\n"
                            "      --strict             refuse what is only warned of otherwise\n"
                            "  -h, --help, -V, --version\n"
                            "\n"
                            "Exit status: 0 fine, 1 failed, 2 wrong usage or no scene.\n";

static int write_pov(const struct request *request, const struct tia_scene *scene, char *why)
{
    static struct pov pov;
    int status = text_open(&pov.text, request->output, why);

    if (status)
        return status;
    pov.path = request->output;
    pov.why = why;
    pov.scene = scene;
    pov_write(&pov, request->source);
    if (!pov.failed)
        return text_close(&pov.text);
    sink_discard(&pov.text.sink);
    return TIA_ERR_DEVICE;
}

int main(int argc, char **argv)
{
    static const struct converter converter = {"tia-pov", usage, NULL, write_pov, NULL};

    return convert(&converter, argc, argv);
}
