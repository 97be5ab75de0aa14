/* misuse.h - calls that no program should make, each in a process of its own. A call must not crash, hang or trip a
 * sanitizer, and must return the value that the headers name.
 *
 *     TEST(misuse_of_views) { GIVES(TIA_ERR_ARGUMENT, tia_view_init(NULL, ...)); HARMLESS(tia_f(NULL)); misuse_end(); }
 */
#ifndef TESTS_MISUSE_H
#define TESTS_MISUSE_H

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"

#define MISUSE_SECONDS 20 /* limit of CPU time in seconds, to end endless loops; no call takes a tenth of it */

static unsigned misuse_count, misuse_wrong;
static char misuse_first[400];

/* Opens a pipe and forks. Returns the child's process id; or 0 in the child, whose CPU time is limited. */
static inline pid_t misuse_begin(int pipes[2])
{
    const struct rlimit none = {0, 0}, seconds = {MISUSE_SECONDS, MISUSE_SECONDS};

    (void)fflush(NULL);
    if (pipe(pipes))
        exit(2);
    pid_t pid = fork();
    if (pid < 0)
        exit(2);
    if (!pid) {
        (void)setrlimit(RLIMIT_CORE, &none);
        (void)setrlimit(RLIMIT_CPU, &seconds);
    }
    return pid;
}

static inline void misuse_say(const int pipes[2], intmax_t result)
{
    _exit(write(pipes[1], &result, sizeof result) != (ssize_t)sizeof result);
}

static inline void misuse_judge(pid_t pid, const int pipes[2], intmax_t want, const char *call, int line)
{
    intmax_t got = 0;
    int status = 0;

    (void)close(pipes[1]);
    bool said = read(pipes[0], &got, sizeof got) == (ssize_t)sizeof got;
    (void)close(pipes[0]);
    (void)waitpid(pid, &status, 0);
    misuse_count++;
    if (said && !status && got == want)
        return;
    if (!misuse_wrong++)
        (void)snprintf(misuse_first, sizeof misuse_first,
                       said && !status       ? "line %d: %.250s gives %jd, not %jd"
                       : WIFSIGNALED(status) ? "line %d: %.250s ends by signal %jd"
                                             : "line %d: %.250s ends with status %jd",
                       line, call,
                       said && !status       ? got
                       : WIFSIGNALED(status) ? WTERMSIG(status)
                                             : WEXITSTATUS(status),
                       want);
}

/* Checks that a call returns `want`. */
#define GIVES(want, ...)                                                                                               \
    do {                                                                                                               \
        int misuse_pipes[2];                                                                                           \
        pid_t misuse_pid = misuse_begin(misuse_pipes);                                                                 \
        if (!misuse_pid)                                                                                               \
            misuse_say(misuse_pipes, (intmax_t)(__VA_ARGS__));                                                         \
        misuse_judge(misuse_pid, misuse_pipes, (intmax_t)(want), #__VA_ARGS__, __LINE__);                              \
    } while (0)

#define REFUSES(...) GIVES(TIA_ERR_ARGUMENT, __VA_ARGS__)

/* Checks a call that returns nothing. */
#define HARMLESS(...) GIVES(0, (__VA_ARGS__, 0))

static inline void misuse_end(void)
{
    CHECK_MSG(!misuse_wrong, "%u of %u misuses: %s", misuse_wrong, misuse_count, misuse_first);
    misuse_count = misuse_wrong = 0;
}

/* Returns memory that is not aligned for uint64_t, if that type needs an alignment. */
#define MISALIGNED(memory) ((void *)((char *)(memory) + 1))

#endif
