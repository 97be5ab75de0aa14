#include "check_only.h"

#include "arguments.h"
#include "fail.h"

/* Checks one scene: its format is that of --scene-format, or by its name. */
static int check_file(const struct options *options, const char *path)
{
    int format = options->format_of_scenes != SCENE_UNKNOWN ? options->format_of_scenes : scene_format_of(path);
    struct scene_file file;

    if (format == SCENE_UNKNOWN) /* standard input */
        format = TIA_FORMAT_TIA;
    if (scene_open_for(&file, path, format, options->strict, &(struct scene_wish){.threads = options->threads}))
        return fail_scene(EXIT_RUNNING, &file);
    arguments_warn(&file);
    scene_close(&file);
    return EXIT_FINE;
}

int check_only(const struct options *options)
{
    int result = EXIT_FINE;

    for (uint32_t i = 0; i < options->scene_count; i++) {
        int status = check_file(options, options->scene_paths[i]);
        result = status ? status : result;
    }
    return result;
}
