/* tia-pov - converts a scene file to POV-Ray's language, so that an independent renderer can draw it. */
#include "common/convert.h"
#include "pov.h"

static const struct option_row rows[] = {{"output", 'o', OPTION_TEXT, "FILE.pov",
                                          "the file to write; - is standard output, without images",
                                          CONVERT_TO(output)},
                                         CONVERT_END};

static const struct command command = {"tia-pov",
                                       "Usage: tia-pov SCENE -o FILE.pov\n"
                                       "Writes a scene in POV-Ray's language, version 3.7. Whatever POV-Ray cannot\n"
                                       "express is a comment in the file and a line on standard error. Images become\n"
                                       "FILE-N.ppm or .pgm beside it.\n"
                                       "\n",
                                       rows, CONVERT_NOTES};

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
    static const struct converter converter = {&command, NULL, write_pov, NULL, NULL};

    return convert(&converter, argc, argv);
}
