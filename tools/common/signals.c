#include "signals.h"

#include <pthread.h>
#include <signal.h>
#include <stddef.h>

enum { ENDING = 4 };
static const int ending[ENDING] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/* Signal masks, which are global since signals belong to the process. */
static sigset_t set;         /* signals of `ending` that the parent process does not ignore */
static sigset_t mask_before; /* signal mask before signals_hold */
static sigset_t mask_of_all; /* signal mask before signals_catch_waiting */
static unsigned holds;
static struct signals_cleanup *cleanups;
static volatile sig_atomic_t noted;
static bool notes;

/* ---- signals that end the program at once ---- */

static void end(int number)
{
    struct sigaction action = {.sa_handler = SIG_DFL};
    for (const struct signals_cleanup *cleanup = cleanups; cleanup; cleanup = cleanup->next)
        cleanup->undo(cleanup->arg);
    (void)sigaction(number, &action, NULL);
    (void)raise(number); /* takes effect when the handler returns: until then the signal is blocked */
}

/* Installs a handler. While a signal is handled, the others are blocked. SA_RESTART is not set, so that a noted signal
 * interrupts the wait for input. */
static void handle(void (*handler)(int number))
{
    struct sigaction action = {.sa_handler = handler, .sa_mask = set};
    for (size_t i = 0; i < ENDING; i++)
        if (sigismember(&set, ending[i]) == 1)
            (void)sigaction(ending[i], &action, NULL);
}

void signals_prepare(void)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    (void)sigaction(SIGPIPE, &ignore, NULL);
    (void)sigaction(SIGXFSZ, &ignore, NULL);
    (void)sigemptyset(&set);
    for (size_t i = 0; i < ENDING; i++)
        if (sigaction(ending[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            (void)sigaddset(&set, ending[i]);
    handle(end);
}

void signals_hold(void)
{
    if (holds++ == 0)
        (void)pthread_sigmask(SIG_BLOCK, &set, &mask_before);
}

void signals_allow(void)
{
    if (--holds == 0)
        (void)pthread_sigmask(SIG_SETMASK, &mask_before, NULL);
}

void signals_add(struct signals_cleanup *cleanup)
{
    signals_hold();
    cleanup->next = cleanups;
    cleanups = cleanup;
    signals_allow();
}

void signals_remove(struct signals_cleanup *cleanup)
{
    struct signals_cleanup **at = &cleanups;
    signals_hold();
    while (*at && *at != cleanup)
        at = &(*at)->next;
    if (*at)
        *at = cleanup->next;
    signals_allow();
}

/* ---- signals that are only noted ---- */

static void note(int number)
{
    noted = number;
}

void signals_catch_waiting(void)
{
    (void)pthread_sigmask(SIG_BLOCK, &set, &mask_of_all);
    handle(note);
    notes = true;
}

bool signals_asked(void *unused)
{
    sigset_t pending;
    (void)unused;
    if (noted != 0)
        return true;
    bool any = false, known = sigpending(&pending) == 0;
    for (size_t i = 0; known && i < ENDING; i++)
        any = any || (sigismember(&set, ending[i]) == 1 && sigismember(&pending, ending[i]) == 1);
    return any;
}

void signals_release(void)
{
    if (notes) {
        (void)pthread_sigmask(SIG_SETMASK, &mask_of_all, NULL); /* pending signals are noted here */
        handle(end);
    }
    notes = false;
}

int signals_end(int status)
{
    signals_release();
    if (noted != 0)
        (void)raise(noted);
    return status;
}
