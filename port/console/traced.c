#include "traced.h"

#include <signal.h>
#include <stdint.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

static pid_t reporter, holder; /* 0: not traced */
static bool listens;           /* the held thread takes part in a stop of the process, and will report its end */

/* The kinds of reports of a traced thread. */
enum cause { NOTHING_NEW, STOP, CONTINUED, SIGNAL };

static pid_t seize(pid_t thread)
{
    return thread > 0 && ptrace(PTRACE_SEIZE, thread, NULL, NULL) == 0 ? thread : 0;
}

/* Seizes a thread and stops it; the report of the stop is left for traced_follow. Returns the thread, or 0. */
static pid_t seize_and_hold(pid_t thread)
{
    siginfo_t what;

    if (seize(thread) == 0)
        return 0;
    (void)ptrace(PTRACE_INTERRUPT, thread, NULL, NULL);
    (void)waitid(P_PID, (id_t)thread, &what, WSTOPPED | WEXITED | WNOWAIT | __WALL);
    return thread;
}

void traced_begin(pid_t reports, pid_t holds)
{
    reporter = seize(reports);
    holder = seize_and_hold(holds);
}

static enum cause cause_of(pid_t thread, uintptr_t *number)
{
    siginfo_t what = {0};

    if (thread == 0 || waitid(P_PID, (id_t)thread, &what, WSTOPPED | WNOHANG | __WALL) != 0 || what.si_pid == 0)
        return NOTHING_NEW;
    *number = (uintptr_t)(what.si_status & 0xff);
    if (what.si_status >> 8 != PTRACE_EVENT_STOP)
        return SIGNAL;
    return *number == SIGTRAP ? CONTINUED : STOP;
}

/* Continues a thread and delivers a signal to it: SIGSTOP, which no thread can block, may arrive at any thread. */
static void deliver(pid_t thread, uintptr_t number)
{
    (void)ptrace(PTRACE_CONT, thread, NULL, (void *)number);
}

/* Lets the held thread report the present state, also when it listens. Without this, it may miss a change: Linux does
 * not wake a thread on a SIGCONT that comes during the call of PTRACE_LISTEN. */
static void ask_holder(void)
{
    (void)ptrace(PTRACE_INTERRUPT, holder, NULL, NULL);
}

static void listen_too(void)
{
    if (holder == 0)
        return;
    listens = ptrace(PTRACE_LISTEN, holder, NULL, NULL) == 0;
    if (!listens) /* it listens already */
        ask_holder();
}

/* Handles the reports of the held thread. After PTRACE_LISTEN in a stop of its own, the thread reports the present
 * state at once: STOP, or CONTINUED if SIGCONT has come in between. After STOP it listens again; after CONTINUED it
 * stays in its own stop, as in the beginning. */
static void follow_holder(void)
{
    uintptr_t number;
    enum cause cause;

    while ((cause = cause_of(holder, &number)) != NOTHING_NEW)
        if (cause == STOP) {
            listen_too();
        } else if (cause == SIGNAL) {
            deliver(holder, number);
            ask_holder();
        } else {
            listens = false;
        }
}

void traced_follow(void (*stops)(bool held), void (*goes_on)(void))
{
    uintptr_t number;
    enum cause cause;

    while ((cause = cause_of(reporter, &number)) != NOTHING_NEW)
        if (cause == STOP) {
            stops(holder != 0);
            (void)ptrace(PTRACE_LISTEN, reporter, NULL, NULL);
            listen_too();
        } else {
            goes_on();
            deliver(reporter, cause == SIGNAL ? number : 0);
        }
    follow_holder();
}

/* Waits until the held thread is in its stop again; the process's next stop ends the wait, too. */
void traced_settle(void)
{
    siginfo_t what;

    follow_holder();
    if (!listens)
        return;
    ask_holder();
    if (waitid(P_PID, (id_t)holder, &what, WSTOPPED | WEXITED | WNOWAIT | __WALL) == 0)
        follow_holder();
}

void traced_end(void)
{
    while (reporter != 0 && waitpid(reporter, NULL, __WALL) > 0)
        ;
    while (holder != 0 && waitpid(holder, NULL, __WALL) > 0)
        ;
}
