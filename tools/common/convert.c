#include "convert.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "common/message.h"
#include "common/scene/scene_load.h"
#include "common/scene/scene_report.h"
#include "common/signals.h"
#include "common/sink.h"
#include "ports.h"

static int fail(const struct converter *converter, int status, const char *what, const char *why)
{
    return message_why(converter->command->name, status, what, why);
}

static int check(const struct converter *converter, struct request *request, int argc, char **argv)
{
    if (argc == 0)
        return fail(converter, 2, "SCENE", "no scene is named (see --help)");
    request->scene = argv[0];
    if (argc > 1)
        return fail(converter, 2, argv[1], "unexpected argument (see --help)");
    const char *why = "", *option = converter->check ? converter->check(request, &why) : NULL;
    if (option)
        return fail(converter, 2, option, why);
    if (sink_is_same(request->output, request->memory))
        return fail(converter, 2, "--memory", "needs a file of its own");
    return request->output || request->memory ? 0 : fail(converter, 2, "--output", "no file is named (see --help)");
}

static void name_source(struct request *request)
{
    const char *slash = strrchr(request->scene, '/');

    (void)snprintf(request->source, sizeof request->source, "%s",
                   strcmp(request->scene, "-") == 0 ? "a scene from standard input"
                   : slash                          ? slash + 1
                                                    : request->scene);
    for (char *at = request->source; *at != '\0'; at++)
        if (!isalnum((unsigned char)*at) && !strchr(" .-_", *at))
            *at = '_';
}

static void warn(const struct converter *converter, const struct scene_file *file)
{
    char line[SCENE_WHY];

    for (unsigned at = 0; scene_warning(file, &at, line);)
        (void)fail(converter, 0, line, "");
}

static int open_scene(const struct converter *converter, struct request *request, struct scene_file *file)
{
    if (request->format == SCENE_UNKNOWN)
        request->format = scene_format_of(request->scene);
    if (request->format == SCENE_UNKNOWN)
        return fail(converter, 2, request->scene, "its name does not tell its format (use --scene-format)");
    int status = scene_open(file, request->scene, request->format, request->strict);
    if (!status) {
        warn(converter, file);
        return 0;
    }
    return scene_report_print(file, converter->command->name, status == TIA_ERR_RANGE ? 2 : 1);
}

int convert(const struct converter *converter, int argc, char **argv)
{
    struct request request = {.format = SCENE_UNKNOWN, .symbol = converter->symbol};
    static struct scene_file file;
    char why[PORT_WHY] = "out of memory";
    int result = command_parse(converter->command, &request, &argc, &argv);

    if (result == COMMAND_RUN)
        result = check(converter, &request, argc, argv);
    else
        return result;
    if (result != 0)
        return result;
    signals_prepare();
    name_source(&request);
    result = open_scene(converter, &request, &file);
    if (result != 0)
        return result;
    if ((request.output && converter->write(&request, &file.scene, why)) ||
        (request.memory && converter->write_memory(&request, &file.scene, why)))
        result = fail(converter, 1, why, "");
    scene_close(&file);
    return result;
}
