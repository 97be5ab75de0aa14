/* tia - draws a scene on a screen or into a file; see tia(1). */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <tia/tia.h>

#include "arguments.h"
#include "common/signals.h"
#include "draw.h"
#include "fail.h"
#include "sample_picture.h"
#include "show.h"

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
    case ACTION_DRAW:
        if (options->gazes)
            return show_into_file(options);
        return options->depth_bits && options->scene.integration.integrator ? estimate(options) : draw(options);
    default:
        return show(options);
    }
}

static int run(struct options *options)
{
    bool draws = options->action == ACTION_DRAW || options->action == ACTION_SHOW;
    int status = draws ? arguments_load(options) : EXIT_FINE;

    return status == EXIT_FINE ? act(options) : status;
}

int main(int argc, char **argv)
{
    struct options options;
    fill_descriptors();
    signals_prepare();
    int status = arguments_parse(&options, argc, argv);
    if (status == COMMAND_RUN)
        status = run(&options);
    arguments_free(&options);
    return status;
}
