#include "signals.h"

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

enum { CAUGHT = 4 };
static const int caught[CAUGHT] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/* Global, since signals belong to the process. */
volatile int signals_caught;
static struct sigaction before[CAUGHT];
static sigset_t mask_before;
static bool active, blocked;

static void stop(int number)
{
    signals_caught = number;
}

void signals_prepare(void)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    (void)sigaction(SIGPIPE, &ignore, NULL);
    (void)sigaction(SIGXFSZ, &ignore, NULL);
}

/* Without SA_RESTART, so that a signal interrupts waiting calls. */
void signals_catch(void)
{
    for (size_t i = 0; i < CAUGHT; i++) {
        struct sigaction action = {.sa_handler = stop};
        (void)sigaction(caught[i], NULL, &before[i]);
        if (before[i].sa_handler != SIG_IGN) {
            (void)sigaction(caught[i], &action, NULL);
        }
    }
    active = true;
}

void signals_catch_waiting(void)
{
    sigset_t set;
    (void)sigemptyset(&set);
    for (size_t i = 0; i < CAUGHT; i++) {
        (void)sigaddset(&set, caught[i]);
    }
    (void)pthread_sigmask(SIG_BLOCK, &set, &mask_before);
    blocked = true;
    signals_catch();
}

void signals_release(void)
{
    if (blocked) { /* while the handlers are still installed, so that pending signals are noted */
        (void)pthread_sigmask(SIG_SETMASK, &mask_before, NULL);
        blocked = false;
    }
    for (size_t i = 0; active && i < CAUGHT; i++) {
        (void)sigaction(caught[i], &before[i], NULL);
    }
    active = false;
}

int signals_end(int status)
{
    signals_release();
    if (signals_caught != 0) {
        (void)raise(signals_caught);
    }
    return status;
}
