/* signals.c - SIGWINCH and SIGCONT, for the display and the keyboard of one terminal. */
#include "signals.h"

#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

static volatile sig_atomic_t resumes, writing;
static sigjmp_buf before_write;
static unsigned users;
static sigset_t mask_before;
static struct sigaction winch_before, cont_before;

static void on_winch(int number)
{
    (void)number;
}

static void on_cont(int number)
{
    (void)number;
    resumes++;
    if (!writing)
        return;
    writing = false;
    siglongjmp(before_write, 1);
}

/* Blocked except in console_wait: otherwise a signal just before the wait would be missed. */
void terminal_signals_begin(void)
{
    struct sigaction winch = {.sa_handler = on_winch}, cont = {.sa_handler = on_cont};
    sigset_t both;

    if (users++ > 0)
        return;
    (void)sigemptyset(&both);
    (void)sigaddset(&both, SIGWINCH);
    (void)sigaddset(&both, SIGCONT);
    (void)pthread_sigmask(SIG_BLOCK, &both, &mask_before);
    (void)sigaction(SIGWINCH, &winch, &winch_before);
    (void)sigaction(SIGCONT, &cont, &cont_before);
}

static void let_in(int number)
{
    sigset_t one;

    (void)sigemptyset(&one);
    (void)sigaddset(&one, number);
    if (!sigismember(&mask_before, number))
        (void)pthread_sigmask(SIG_UNBLOCK, &one, NULL);
}

void terminal_signals_end(void)
{
    if (users == 0 || --users > 0)
        return;
    (void)sigaction(SIGWINCH, &winch_before, NULL);
    (void)sigaction(SIGCONT, &cont_before, NULL);
    let_in(SIGWINCH);
    let_in(SIGCONT);
}

int terminal_resumes(void)
{
    return resumes;
}

static void let_in_resume(sigset_t *before)
{
    sigset_t one;

    (void)sigemptyset(&one);
    (void)sigaddset(&one, SIGCONT);
    (void)pthread_sigmask(SIG_UNBLOCK, &one, before);
}

int terminal_resumes_now(void)
{
    sigset_t before;

    let_in_resume(&before);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return resumes;
}

void terminal_resume_again(void)
{
    (void)raise(SIGCONT);
}

/* Without the jump, the kernel would begin a write anew that a stop has kept from writing. Of one that has written the
 * count is lost. */
ssize_t terminal_write(int fd, const void *bytes, size_t count)
{
    sigset_t before;

    if (sigsetjmp(before_write, 1) != 0) {
        errno = EINTR;
        return -1;
    }
    writing = true;
    let_in_resume(&before);
    ssize_t n = write(fd, bytes, count);
    int error = errno;
    writing = false;
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = error;
    return n;
}
