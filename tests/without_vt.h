/* without_vt.h - runs tests of the console in a process that has no VT. */
#ifndef TESTS_WITHOUT_VT_H
#define TESTS_WITHOUT_VT_H

#include "check.h"
#include "console/console.h"

#include <grp.h>
#include <stdbool.h>
#include <sys/wait.h>
#include <unistd.h>

/* Runs a test in a new session and without privileges, so that its process has no VT: a test must not take over a
 * console that is in use. */
static inline int in_process_without_vt(int (*run)(void))
{
    pid_t child;
    int status = 1;

    (void)fflush(stdout);
    child = fork();
    if (child == 0) {
        (void)setsid();
        if (geteuid() == 0 && (setgroups(0, NULL) != 0 || setgid(65534) != 0 || setuid(65534) != 0))
            _exit(1);
        _exit(run());
    }
    (void)waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

static inline bool no_vt(void)
{
    char name[PORT_WHY];

    if (strncmp(console_name(name), "none: ", 6) == 0)
        return true;
    SKIP("it would take %s", name);
    return false;
}

#endif
