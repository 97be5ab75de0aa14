#include "piped.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

struct piped {
    FILE *to, *from;
    pid_t program;
    char driver[256];
};

/* Runs the command with pipes as its standard input and output; does not return. */
static void run(const char *command, int input, int output)
{
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0)
        (void)execl("/bin/sh", "sh", "-c", command, (char *)NULL);
    _exit(127);
}

static bool start(struct piped *p, const char *command)
{
    int there[2], back[2];

    if (pipe2(there, O_CLOEXEC))
        return false;
    if (pipe2(back, O_CLOEXEC))
        return false;
    p->program = fork();
    if (p->program == 0)
        run(command, there[0], back[1]);
    (void)close(there[0]);
    (void)close(back[1]);
    p->to = fdopen(there[1], "w");
    p->from = fdopen(back[0], "r");
    return p->program > 0 && p->to && p->from;
}

struct piped *piped_open(const char *command)
{
    struct piped *p = calloc(1, sizeof *p);

    (void)signal(SIGPIPE, SIG_IGN);
    if (p && start(p, command) && fgets(p->driver, sizeof p->driver, p->from)) {
        p->driver[strcspn(p->driver, "\n")] = '\0';
        return p;
    }
    if (p)
        piped_close(p);
    return NULL;
}

const char *piped_driver(const struct piped *piped)
{
    return piped->driver;
}

bool piped_draw(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    struct piped *p = ctx;
    int32_t numbers[TRIAL_NUMBERS];
    uint8_t bytes[2 * PIXELS];
    unsigned count = trial_numbers(trial, numbers);

    for (unsigned i = 0; i < count; i++)
        (void)fprintf(p->to, "%d ", (int)numbers[i]);
    (void)fputc('\n', p->to);
    if (fflush(p->to) != 0 || fread(bytes, 1, sizeof bytes, p->from) != sizeof bytes)
        return false;
    trial_take(pixels, bytes);
    return true;
}

void piped_close(struct piped *piped)
{
    if (piped->to)
        (void)fclose(piped->to);
    if (piped->from)
        (void)fclose(piped->from);
    if (piped->program > 0)
        (void)waitpid(piped->program, NULL, 0);
    free(piped);
}
