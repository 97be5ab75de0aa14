/* tia-pov - converts a scene file to POV-Ray's language, so that an independent renderer can draw it. */
#include "common/choices.h"
#include "common/convert.h"
#include "pov.h"

#define TO(member) OPTION_TO(struct request, member)

static const struct option_row rows[] = {
    {"output", 'o', OPTION_TEXT, "FILE.pov", "the file to write; - is standard output, without images", TO(output)},
    {"scene-format", 0, OPTION_CHOICE, SCENE_FORMATS, "the format of SCENE, if its name has no such extension",
     TO(format)},
    {"strict", 0, OPTION_FLAG, NULL, "treat warnings about the scene as errors", TO(strict)},
    OPTION_END};

static const struct command command = {
    "tia-pov",
    "Usage: tia-pov SCENE -o FILE.pov\n"
    "Writes a scene in POV-Ray's language, version 3.7. Whatever POV-Ray cannot express is a comment\n"
    "in the file and a line on standard error. Images become FILE-N.ppm or .pgm beside it.\n"
    "\n",
    rows,
    "\n"
    "Exit status: 0 success, 1 failure, 2 usage error or invalid scene.\n"};

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
    static const struct converter converter = {&command, NULL, write_pov, NULL};

    return convert(&converter, argc, argv);
}
