#include "thumbnail.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "clock.h"
#include "common/image/image.h"
#include "fail.h"
#include "file_door.h"
#include "thumbnail_page.h"

enum { LIMIT_S = 5 }; /* without --time-limit */

/* ---- the process that draws ---- */

struct painter {
    struct options *options;
    struct thumbnail_page *page;
    pid_t process;
    int ended; /* status of waitpid */
    bool timed_out;
    char why[PORT_WHY];
};

/* Starts the process. Returns this process's end of the socket; -1 on failure. */
static int start(struct painter *p, uint64_t end_us)
{
    int ends[2];

    p->page = mmap(NULL, sizeof *p->page, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (p->page == MAP_FAILED || socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return -1;
    (void)fflush(NULL);
    p->process = fork();
    if (p->process == 0)
        thumbnail_draw(p->options, p->page, ends[1], end_us);
    (void)close(ends[1]);
    if (p->process > 0)
        return ends[0];
    (void)close(ends[0]);
    return -1;
}

/* Hands out files until the process ends or the time is over, then ends the process. */
static void attend(struct painter *p, int socket, uint64_t end_us)
{
    struct file_door door = {.socket = socket, .model = p->options->scene_path};
    bool goes_on = true;

    while (goes_on) {
        uint64_t now = clock_now_us();
        int ready = poll(&(struct pollfd){.fd = socket, .events = POLLIN}, 1,
                         now < end_us ? (int)((end_us - now + 999) / 1000) : 0);
        p->timed_out = ready == 0;
        goes_on = ready < 0 ? errno == EINTR : ready > 0 && file_door_serve(&door);
    }
    if (p->timed_out)
        (void)kill(p->process, SIGKILL);
    (void)close(socket);
    while (waitpid(p->process, &p->ended, 0) < 0 && errno == EINTR)
        continue;
}

/* Returns the exit status for what the process has left, after a message if there is no picture. */
static int judge(struct painter *p)
{
    const struct thumbnail_page *page = p->page;
    const char *path = p->options->scene_path;
    bool ended = atomic_load(&page->ended),
         late = p->timed_out || (WIFSIGNALED(p->ended) && WTERMSIG(p->ended) == SIGXCPU);

    if (ended && page->status)
        return fail(page->status == EXIT_RUNNING ? EXIT_RUNNING : EXIT_USAGE, "%.*s", PORT_WHY - 1, page->why);
    if (!ended && !late)
        return fail(EXIT_USAGE, "%.200s: drawing it fails%s%s", path, WIFSIGNALED(p->ended) ? ": " : "",
                    WIFSIGNALED(p->ended) ? strsignal(WTERMSIG(p->ended)) : "");
    if (!atomic_load(&page->drawn))
        return fail(EXIT_RUNNING, "%.200s: no picture in time (--time-limit)", path);
    return EXIT_FINE;
}

static int save(struct painter *p)
{
    const struct options *options = p->options;
    const struct thumbnail_page *page = p->page;
    unsigned drawn = atomic_load(&page->drawn), width = page->width, height = page->height;

    if (!width || !height || width > options->thumbnail || height > options->thumbnail)
        return fail(EXIT_RUNNING, "%.200s: drawing it fails", options->scene_path);
    const struct image_film film = {
        .width = width, .height = height, .rows = height, .frames = 1, .all_frames = 1, .rate = {1, 1}, .depth = 8};
    struct image *image = image_create_film(options->output, options->format, &film, p->why);
    if (image)
        (void)image_rows(image, page->rgb[(drawn - 1) % 2], height);
    return image && !image_finish(image) ? EXIT_FINE : fail(EXIT_RUNNING, "%s", p->why);
}

int thumbnail(struct options *options)
{
    struct painter p = {.options = options};
    uint64_t limit_us =
        options->time_limit ? (uint64_t)options->time_limit * 1000000 / TIA_Q16_ONE : LIMIT_S * 1000000u;
    uint64_t end_us = clock_now_us() + limit_us;
    int socket = start(&p, end_us);

    if (socket < 0)
        return fail(EXIT_RUNNING, "--thumbnail: %s", strerror(errno));
    attend(&p, socket, end_us);
    int status = judge(&p);
    return status ? status : save(&p);
}
