#include "notify.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "clock.h"
#include "common/signals.h"
#include "scenes.h"

enum { LONG_US = 1000000, NAME_SIZE = 64, TEXT_SIZE = 160 };

/* What terminals know: a bell; a notification by OSC 9 of iTerm2, 99 of kitty or 777 of urxvt, and the bell. */
enum way { WAY_NONE, WAY_BELL, WAY_9, WAY_99, WAY_777 };

/* The texts are complete before the work begins, since a signal's handler can only write. */
static char done[TEXT_SIZE], failed[TEXT_SIZE], stopped[TEXT_SIZE];
static uint64_t begun_us; /* 0: no notification */

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

static const char *variable(const char *name)
{
    const char *value = getenv(name);

    return value ? value : "";
}

/* Chooses by the environment: terminals do not answer what they know. A multiplexer has only the bell. */
static enum way find_way(void)
{
    const char *term = variable("TERM"), *program = variable("TERM_PROGRAM");

    if (!*term || strcmp(term, "dumb") == 0)
        return WAY_NONE;
    if (*variable("TMUX") || begins(term, "tmux") || begins(term, "screen"))
        return WAY_BELL;
    if (begins(term, "xterm-kitty"))
        return WAY_99;
    if (strcmp(program, "iTerm.app") == 0)
        return WAY_9;
    if (begins(term, "foot") || begins(term, "rxvt-unicode") || begins(term, "xterm-ghostty") ||
        strcmp(program, "WezTerm") == 0 || strcmp(program, "ghostty") == 0 || *variable("WT_SESSION"))
        return WAY_777;
    return WAY_BELL;
}

/* Writes the control sequence of a message. A semicolon would end a part of OSC 777. */
static void compose(char text[TEXT_SIZE], enum way way, const char *name, const char *what)
{
    static const char *const formats[] = {"", "\a", "\033]9;tia: %s %s\033\\\a", "\033]99;;tia: %s %s\033\\\a",
                                          "\033]777;notify;tia;%s %s\033\\\a"};

    if (way <= WAY_BELL)
        (void)snprintf(text, TEXT_SIZE, "%s", formats[way]);
    else
        (void)snprintf(text, TEXT_SIZE, formats[way], name, what);
}

/* Writes a text to the controlling terminal, from the background too. Only calls async-signal-safe functions. */
static void tell(const char *text)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    int error = errno, fd = open("/dev/tty", O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);

    if (fd < 0 || !begun_us || clock_now_us() - begun_us < LONG_US)
        text = "";
    (void)sigaction(SIGTTOU, &ignore, &before);
    if (*text != '\0' && write(fd, text, strlen(text)) < 0)
        errno = error; /* a terminal that accepts nothing shows nothing */
    (void)sigaction(SIGTTOU, &before, NULL);
    if (fd >= 0)
        (void)close(fd);
    begun_us = 0;
    errno = error;
}

static void tell_stopped(void *unused)
{
    (void)unused;
    tell(stopped);
}

static struct signals_cleanup cleanup = {.undo = tell_stopped};

void notify_begin(const struct options *options)
{
    enum way way = options->notify ? find_way() : WAY_NONE;
    char name[NAME_SIZE];

    if (way == WAY_NONE)
        return;
    scenes_name(options, name, sizeof name);
    for (char *at = name; *at != '\0'; at++)
        *at = *at == ';' ? ',' : *at;
    compose(done, way, name[0] ? name : "the picture", "is finished");
    compose(failed, way, name[0] ? name : "the picture", "has failed");
    compose(stopped, way, name[0] ? name : "the picture", "was stopped");
    begun_us = clock_now_us();
    signals_add(&cleanup);
}

void notify_end(int status)
{
    signals_remove(&cleanup);
    if (begun_us)
        tell(status == 0 ? done : failed);
}
