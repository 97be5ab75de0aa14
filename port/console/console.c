#include "console.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <time.h>

#include "vt.h"

/* Signals by which the kernel requests the console and returns it. */
#define LEAVE SIGUSR1
#define ENTER SIGUSR2

static struct console {
    enum console_state state;
    struct vt vt;
    struct console_listener *listeners; /* in the order in which they were added */
    sigset_t mask;                      /* the caller's signal mask and handlers, which console_open replaces */
    struct sigaction on_leave, on_enter, on_resume;
} console = {.state = CONSOLE_FREE, .vt.fd = -1};

static volatile sig_atomic_t leave_asked, enter_asked, resumed;

/* Sets a signal's flag; for SIGCONT, also calls the previous handler, that of the terminal's input. */
static void note_signal(int number)
{
    if (number == LEAVE)
        leave_asked = 1;
    else if (number == ENTER)
        enter_asked = 1;
    else
        resumed = 1;
    if (number == SIGCONT && console.on_resume.sa_handler != SIG_DFL && console.on_resume.sa_handler != SIG_IGN)
        console.on_resume.sa_handler(number);
}

static void switching_signals(sigset_t *set)
{
    (void)sigemptyset(set);
    (void)sigaddset(set, LEAVE);
    (void)sigaddset(set, ENTER);
    (void)sigaddset(set, SIGCONT);
}

/* ---- listeners ---- */

enum console_state console_state(void)
{
    return console.state;
}

void console_listen(struct console_listener *listener)
{
    struct console_listener **end = &console.listeners;

    console_ignore(listener);
    while (*end)
        end = &(*end)->next;
    listener->next = NULL;
    *end = listener;
}

void console_ignore(struct console_listener *listener)
{
    for (struct console_listener **l = &console.listeners; *l; l = &(*l)->next)
        if (*l == listener) {
            *l = listener->next;
            return;
        }
}

static void enter(void)
{
    console.state = CONSOLE_OURS;
    for (struct console_listener *l = console.listeners; l; l = l->next)
        l->enter(l->arg);
}

static void leave(enum console_state state)
{
    struct console_listener *last = NULL, *l;

    console.state = state;
    while (last != console.listeners) {
        for (l = console.listeners; l->next != last; l = l->next)
            ;
        l->leave(l->arg);
        last = l;
    }
}

/* ---- switching ---- */

/* Answers the signal LEAVE by releasing the console. If the signal did not come from the kernel, no answer is expected,
 * and the console is entered again. */
static void answer_leave(void)
{
    leave_asked = 0;
    if (console.state != CONSOLE_OURS)
        return;
    leave(CONSOLE_AWAY);
    if (!vt_let_go(&console.vt))
        enter();
}

static void answer_enter(void)
{
    enter_asked = 0;
    if (console.state != CONSOLE_AWAY || !vt_in_front(&console.vt))
        return;
    vt_entered(&console.vt);
    enter();
}

/* Takes over again from the guardian after a stop. If the guardian released the console, another program has used the
 * keyboards and the screen, even if the console is in front again. */
static void answer_resume(void)
{
    bool left = false;

    resumed = 0;
    if (console.state == CONSOLE_FREE || !vt_resume(&console.vt, LEAVE, ENTER, &left))
        return;
    leave_asked = enter_asked = 0;
    if (console.state == CONSOLE_OURS && (left || !vt_in_front(&console.vt)))
        leave(CONSOLE_AWAY);
    if (console.state == CONSOLE_AWAY && vt_in_front(&console.vt))
        enter();
}

/* Answers pending requests. The kernel requests the console only from a process that has it, and waits for the answer:
 * when both signals are pending, the state shows which signal came first. */
static void answer(void)
{
    if (resumed)
        answer_resume();
    while (console.vt.fd >= 0 && (leave_asked || enter_asked))
        if (console.state == CONSOLE_AWAY ? enter_asked : !leave_asked)
            answer_enter();
        else
            answer_leave();
}

/* Turns pending signals into flags, since ppoll delivers none when a descriptor is ready. */
static void collect_signals(void)
{
    const struct timespec now = {0};
    sigset_t set;
    int number;

    switching_signals(&set);
    while ((number = sigtimedwait(&set, NULL, &now)) > 0)
        note_signal(number);
}

int console_wait(struct pollfd *fds, nfds_t count, int timeout_ms)
{
    const struct timespec time = {.tv_sec = timeout_ms / 1000, .tv_nsec = timeout_ms % 1000 * 1000000L};
    sigset_t none;
    int ready;

    (void)sigemptyset(&none);
    ready = ppoll(fds, count, timeout_ms < 0 ? NULL : &time, &none);
    if (ready < 0 && errno != EINTR)
        return TIA_ERR_DEVICE;
    if (console.state != CONSOLE_FREE)
        collect_signals();
    answer();
    return ready < 0 ? 0 : ready;
}

void console_switch(unsigned vt)
{
    if (console.state != CONSOLE_FREE && console.vt.fd >= 0 && vt >= 1 && vt <= MAX_NR_CONSOLES)
        (void)ioctl(console.vt.fd, VT_ACTIVATE, (long)vt);
}

/* ---- taking and giving back ---- */

static void take_signals(void)
{
    struct sigaction action = {.sa_handler = note_signal, .sa_flags = SA_RESTART};
    sigset_t set;

    switching_signals(&set);
    (void)sigprocmask(SIG_BLOCK, &set, &console.mask);
    (void)sigaction(LEAVE, &action, &console.on_leave);
    (void)sigaction(ENTER, &action, &console.on_enter);
    (void)sigaction(SIGCONT, &action, &console.on_resume);
    leave_asked = enter_asked = resumed = 0;
}

static void give_signals(void)
{
    collect_signals();
    (void)sigaction(LEAVE, &console.on_leave, NULL);
    (void)sigaction(ENTER, &console.on_enter, NULL);
    (void)sigaction(SIGCONT, &console.on_resume, NULL);
    (void)sigprocmask(SIG_SETMASK, &console.mask, NULL);
}

int console_open(bool graphics, char why[PORT_WHY])
{
    int status;

    if (console.state != CONSOLE_FREE) {
        (void)snprintf(why, PORT_WHY, "console: this program has taken it already");
        return TIA_ERR_DEVICE;
    }
    vt_find(&console.vt);
    take_signals();
    status = vt_take(&console.vt, graphics, LEAVE, ENTER, why);
    if (status) {
        give_signals();
        vt_close(&console.vt);
        return status;
    }
    enter();
    return TIA_OK;
}

void console_close(void)
{
    if (console.state == CONSOLE_FREE)
        return;
    /* a switch to another console may just have been requested */
    collect_signals();
    answer();
    leave(CONSOLE_FREE);
    vt_give(&console.vt);
    give_signals();
    vt_close(&console.vt);
}

const char *console_name(char text[PORT_WHY])
{
    struct vt vt;

    if (console.state != CONSOLE_FREE) {
        (void)snprintf(text, PORT_WHY, "%s", console.vt.name);
        return text;
    }
    vt_find(&vt);
    vt_close(&vt);
    (void)snprintf(text, PORT_WHY, "%s", vt.name);
    return text;
}

void console_list(port_line *line, void *arg)
{
    char text[PORT_WHY + 16], name[PORT_WHY];

    (void)snprintf(text, sizeof text, "console: %s", console_name(name));
    line(arg, text);
}
