#include "import.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/sanitized.h"
#include "convert_model.h"
#include "library.h"

/* ---- in the importing process ---- */

/* Lowers a limit to `most`, and keeps it where it is lower. */
static void limit(int resource, rlim_t most)
{
    struct rlimit now;

    if (getrlimit((__rlimit_resource_t)resource, &now) == 0 && (now.rlim_cur == RLIM_INFINITY || now.rlim_cur > most)) {
        now.rlim_cur = most;
        (void)setrlimit((__rlimit_resource_t)resource, &now);
    }
}

/* Leaves the process nothing of the terminal, the signal handlers and the memory of the program. */
static void confine(void)
{
    int null = open("/dev/null", O_RDWR | O_CLOEXEC);

    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (int number = 1; number < NSIG; number++)
        (void)signal(number, SIG_DFL);
    for (int fd = 0; null >= 0 && fd < 3; fd++)
        (void)dup2(null, fd);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, IMPORT_SECONDS);
    if (!IS_SANITIZED && sizeof(void *) > 4)
        limit(RLIMIT_AS, (rlim_t)IMPORT_MEMORY);
}

static void work(int fd, const struct scene_file *file)
{
    confine();
    _exit(convert_model(fd, file) ? EXIT_FAILURE : EXIT_SUCCESS);
}

/* ---- in the program ---- */

static int fail(struct import_result *result, int status, const char *why)
{
    (void)snprintf(result->why, sizeof result->why, "%s", why);
    return status;
}

/* Returns the reason why a process ended before it was finished. */
static int explain_end(struct import_result *result, int ended)
{
    if (WIFSIGNALED(ended) && WTERMSIG(ended) == SIGXCPU)
        (void)snprintf(result->why, sizeof result->why, "libassimp takes longer than %d s", IMPORT_SECONDS);
    else if (WIFSIGNALED(ended))
        (void)snprintf(result->why, sizeof result->why, "libassimp fails on this file (%s)",
                       strsignal(WTERMSIG(ended)));
    else
        (void)snprintf(result->why, sizeof result->why, "libassimp fails on this file");
    return TIA_ERR_RANGE;
}

static int read_status(struct import_result *result, int ended)
{
    static struct model_header header;
    size_t size = offsetof(struct model_header, warnings);

    if (pread(result->fd, &header, size, 0) != (ssize_t)size || header.status == MODEL_UNFINISHED)
        return explain_end(result, ended);
    header.why[MODEL_WHY - 1] = '\0';
    return header.status ? fail(result, header.status, header.why) : TIA_OK;
}

static int wait_for(pid_t child)
{
    int ended = 0;

    while (waitpid(child, &ended, 0) < 0)
        if (errno != EINTR)
            return 0;
    return ended;
}

static bool is_here; /* see import_here */

void import_here(void)
{
    static struct assimp_library library;
    const char *why;

    (void)assimp_load(&library, &why);
    is_here = true;
}

int import_run(struct import_result *result, const struct scene_file *file)
{
    *result = (struct import_result){.fd = memfd_create("model", MFD_CLOEXEC)};
    if (result->fd < 0)
        return fail(result, TIA_ERR_MEMORY, strerror(errno));
    if (is_here) {
        (void)convert_model(result->fd, file);
        return read_status(result, 0);
    }
    (void)fflush(NULL);
    pid_t child = fork();
    if (child < 0)
        return fail(result, TIA_ERR_MEMORY, strerror(errno));
    if (child == 0)
        work(result->fd, file);
    return read_status(result, wait_for(child));
}
