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

static void write_side(FILE *to, const struct tia_stencil *s)
{
    (void)fprintf(to, " %d %u %u %u %d %d %d", (int)s->test, (unsigned)s->reference, (unsigned)s->mask,
                  (unsigned)s->write, (int)s->fail, (int)s->zfail, (int)s->zpass);
}

static void write_triangle(FILE *to, const struct triangle *t)
{
    for (int i = 0; i < 3; i++)
        (void)fprintf(to, " %d %d", (int)t->x[i], (int)t->y[i]);
    (void)fprintf(to, " %d %d %d %d %d %d", (int)t->level, (int)t->state.depth, t->state.depth_write,
                  t->state.colour_write[0], t->state.skip_front, t->state.skip_back);
    write_side(to, &t->state.front);
    write_side(to, &t->state.back);
}

bool piped_draw(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    struct piped *p = ctx;
    unsigned char bytes[2 * PIXELS];

    (void)fprintf(p->to, "%u %u", trial->count, (unsigned)trial->clear);
    for (unsigned i = 0; i < trial->count; i++)
        write_triangle(p->to, &trial->triangles[i]);
    (void)fputc('\n', p->to);
    if (fflush(p->to) != 0 || fread(bytes, 1, sizeof bytes, p->from) != sizeof bytes)
        return false;
    for (unsigned i = 0; i < PIXELS; i++) {
        pixels->face[i] = bytes[i] == 255 ? TIA_NO_FACE : bytes[i];
        pixels->stencil[i] = bytes[PIXELS + i];
    }
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
