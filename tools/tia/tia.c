/* tia - draws a scene on a screen or into a file; see tia(1). */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <tia/tia.h>

#include "arguments.h"
#include "benchmark.h"
#include "check_only.h"
#include "common/signals.h"
#include "draw.h"
#include "fail.h"
#include "notify.h"
#include "recording.h"
#include "show.h"
#include "thumbnail.h"
#include "write.h"

/* Opens the standard descriptors that are closed when the program starts: a file opened later would get one of their
 * numbers, and messages would go into the picture. */
static void fill_descriptors(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF)
            (void)open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

static int act(struct options *options)
{
    switch (options->action) {
    case ACTION_LIST:
        return show_list(NULL);
    case ACTION_MODES:
        return show_list(options->display.name);
    case ACTION_WRITE:
        return write_scene(options);
    case ACTION_DRAW:
        if (options->gazes)
            return show_into_file(options);
        return draw_file(options);
    default:
        return show(options);
    }
}

/* Loads the scene with --watch. If it cannot be loaded, an empty one is shown, with the reason. */
static int load_watched(struct options *options, struct file_watch *watch)
{
    if (!file_watch_open(watch))
        return fail(EXIT_RUNNING, "--watch: %s", strerror(errno));
    options->watch = watch;
    fail_into(options->broken, sizeof options->broken);
    int status = arguments_load(options);
    fail_into(NULL, 0);
    if (!status) {
        if (options->broken[0] != '\0')
            note("%s", options->broken); /* a warning */
        options->broken[0] = '\0';
        return EXIT_FINE;
    }
    scene_close(&options->file);
    options->file = (struct scene_file){.path = NULL};
    options->plain_scene = options->scene = (struct tia_scene){
        .camera = tia_thesis_scene.camera, .background = {TIA_Q30_ONE / 8, TIA_Q30_ONE / 8, TIA_Q30_ONE / 8}};
    return EXIT_FINE;
}

static int run(struct options *options)
{
    bool draws = options->action != ACTION_LIST && options->action != ACTION_MODES;
    struct file_watch watch = {.is_open = false};
    if (options->checks)
        return check_only(options);
    if (options->benchmark)
        return benchmark(options);
    if (draws && options->watches) {
        int status = load_watched(options, &watch);
        status = status ? status : act(options);
        file_watch_close(&watch);
        return status;
    }
    if (draws && options->thumbnail)
        return thumbnail(options);
    if (options->record)
        return recording_draw(options);
    int status = draws ? arguments_load(options) : EXIT_FINE;

    return status == EXIT_FINE ? act(options) : status;
}

int main(int argc, char **argv)
{
    struct options options;
    fill_descriptors();
    signals_prepare();
    int status = arguments_parse(&options, argc, argv);
    if (status == COMMAND_RUN) {
        notify_begin(&options);
        status = run(&options);
        notify_end(status);
    }
    arguments_free(&options);
    return status;
}
