/* No function here may take a lock, as malloc does: another thread may have held it at the fork. */
#include "guard.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/kd.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "cooked.h"
#include "restore_table.h"
#include "spare.h"
#include "stand_in.h"
#include "traced.h"

#define LINE 0        /* the socket's descriptor in this process */
#define SETTLE_MS 100 /* time limit for the main thread to stop, too: a driver may delay it */

static pid_t process, process_group; /* the guarded process and its group */
static int process_end;              /* pidfd of the guarded process */

/* ---- consoles and framebuffers ---- */

/* Makes the VT the controlling terminal of a new session, led by a child, which continues as the guardian; false on
 * failure. When a session's leader dies, the session loses its terminal, and a user other than root may not change the
 * VT until it is the controlling terminal of a session again. Only a process that leads no group can start a session,
 * hence the child. */
static bool claim_terminal(int fd)
{
    pid_t child = fork();

    if (child > 0)
        _exit(0);
    return child == 0 && setsid() > 0 && ioctl(fd, TIOCSCTTY, 0L) == 0;
}

static void restore_vt(const struct saved *saved, int fd)
{
    struct vt_mode mode = saved->was.vt.mode;

    /* Text mode must be set before the switch, since a switch does not redraw a console in graphics mode. The kernel
     * draws the text only when the mode changes, so graphics mode is set first. */
    if (ioctl(fd, KDSETMODE, (long)KD_GRAPHICS) != 0 && errno == EPERM && claim_terminal(fd))
        (void)ioctl(fd, KDSETMODE, (long)KD_GRAPHICS);
    (void)ioctl(fd, KDSETMODE, (long)saved->was.vt.kd_mode);
    /* Completes a switch that waits for an answer: VT_SETMODE would drop it, and chvt would wait for ever. */
    bool switched = ioctl(fd, VT_RELDISP, 1L) == 0;
    (void)ioctl(fd, VT_SETMODE, &mode);
    if (saved->was.vt.back_to != 0 && !switched)
        (void)ioctl(fd, VT_ACTIVATE, (long)saved->was.vt.back_to);
}

static void restore_fb(const struct saved *saved, int fd)
{
    struct fb_var_screeninfo var = saved->was.fb;

    var.activate = FB_ACTIVATE_NOW;
    (void)ioctl(fd, FBIOPUT_VSCREENINFO, &var);
    (void)ioctl(fd, FBIOPAN_DISPLAY, &var);
}

static void restore_screens(void)
{
    for (int i = KEPT_MOST - 1; i >= 0; i--) {
        int fd = kept[i].kind == VT || kept[i].kind == FB ? cooked_open(kept[i].path) : -1;
        if (fd < 0)
            continue;
        if (kept[i].kind == VT)
            restore_vt(&kept[i], fd);
        else
            restore_fb(&kept[i], fd);
        (void)close(fd);
    }
}

/* ---- operations that may take a while ---- */

/* True if a key with a code below BTN_MISC is down; the codes above are buttons of mice and joysticks. */
static bool is_any_key_down(int fd)
{
    unsigned char down[KEY_CNT / 8] = {0};

    if (ioctl(fd, EVIOCGKEY(sizeof down), down) < 0)
        return false;
    for (int i = 0; i < BTN_MISC / 8; i++)
        if (down[i] != 0)
            return true;
    return false;
}

/* True if all keys are up. Reads all events, since EVIOCGKEY removes only key events from the queue, and the others
 * would end the next wait at once. */
static bool is_released(int fd)
{
    struct input_event events[64];

    while (read(fd, events, sizeof events) > 0)
        ;
    return !is_any_key_down(fd);
}

/* Completes an entry's operation as far as possible without waiting; true when nothing is left to do. */
static bool finish_one(struct saved *saved)
{
    bool done = saved->fd < 0 || (saved->kind != TEXT && saved->kind != KEYBOARD);

    if (!done)
        done = saved->kind == TEXT ? cooked_write(saved, 0) : is_released(saved->fd);
    if (done && saved->fd >= 0) {
        (void)close(saved->fd);
        saved->fd = -1;
    }
    return done;
}

/* Completes all operations. A key that is down when its grab ends would repeat on the console, so a keyboard's
 * descriptor, and with it the grab, stays open until all keys are up. */
static void finish(void)
{
    struct pollfd fds[KEPT_MOST];
    nfds_t waiting;

    do {
        waiting = 0;
        for (int i = 0; i < KEPT_MOST; i++)
            if (!finish_one(&kept[i]))
                fds[waiting++] = (struct pollfd){.fd = kept[i].fd, .events = kept[i].kind == TEXT ? POLLOUT : POLLIN};
    } while (waiting > 0 && poll(fds, waiting, -1) >= 0);
}

/* ---- messages ---- */

/* Returns the descriptor that came with the message, or -1. */
static int descriptor_of(struct msghdr *message)
{
    struct cmsghdr *part = CMSG_FIRSTHDR(message);
    int fd = -1;

    if (part && part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_RIGHTS)
        (void)memcpy(&fd, CMSG_DATA(part), sizeof fd);
    return fd;
}

static void follow(struct saved *saved)
{
    const struct saved *old = kept_find(saved);
    const char ready = GUARD_READY;

    if (saved->kind == THREADS) {
        traced_begin(saved->was.threads.reports, saved->was.threads.holds);
        (void)send(LINE, &ready, 1, MSG_NOSIGNAL);
        return;
    }
    if (saved->kind == SYNC) {
        traced_settle();
        kept_answer();
        return;
    }
    if (old && old->fd >= 0)
        (void)close(old->fd);
    (void)kept_note(saved);
}

/* Receives a message and handles it; false when the other end is closed. */
static bool take_message(void)
{
    struct saved saved;
    _Alignas(struct cmsghdr) char control[CMSG_SPACE(sizeof(int))];
    struct iovec bytes = {&saved, sizeof saved};
    struct msghdr message = {
        .msg_iov = &bytes, .msg_iovlen = 1, .msg_control = control, .msg_controllen = sizeof control};

    if (recvmsg(LINE, &message, MSG_CMSG_CLOEXEC) != (ssize_t)sizeof saved)
        return false;
    saved.fd = descriptor_of(&message);
    follow(&saved);
    return true;
}

/* ---- signals ---- */

/* True if the main thread, which uses the terminals, is stopped with the process or by its tracer, such as strace. */
static bool is_main_stopped(void)
{
    char path[32], line[64] = "";

    (void)snprintf(path, sizeof path, "/proc/%d/stat", (int)process);
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    ssize_t n = fd >= 0 ? read(fd, line, sizeof line - 1) : 0;
    (void)close(fd);
    line[n > 0 ? n : 0] = '\0';
    const char *state = strrchr(line, ')'); /* end of the name; a space and the state follow */
    return state && strlen(state) > 2 && (state[2] == 'T' || state[2] == 't');
}

/* Handles all messages that have arrived. The process sends one before it changes a terminal; the message must be
 * handled before the terminal is restored. */
static void take_all_messages(void)
{
    struct pollfd line = {.fd = LINE, .events = POLLIN};

    while (poll(&line, 1, 0) > 0 && take_message())
        ;
}

/* If `held`, restores terminals before the shell is notified of the stop, since the shell adopts the modes that it then
 * finds. Restores none if SIGCONT has come already. If SIGCONT comes meanwhile, sends it again, so that the program
 * checks its terminal once more. */
static void on_stop(bool held)
{
    stand_in_begin();
    if (!held)
        return;
    for (int ms = 0; ms < SETTLE_MS && !is_main_stopped(); ms++)
        (void)poll(NULL, 0, 1);
    take_all_messages();
    if (!is_main_stopped() || !cooked_at_a_stop(process_group))
        return;
    kept_count_put_back();
    if (!is_main_stopped())
        (void)kill(process, SIGCONT);
}

static void take_signals(int signals)
{
    struct signalfd_siginfo signal;

    while (read(signals, &signal, sizeof signal) == (ssize_t)sizeof signal)
        if (signal.ssi_signo == SIGCHLD)
            traced_follow(on_stop, stand_in_end);
        else if (signal.ssi_signo == SIGUSR1)
            stand_in_leave();
        else
            stand_in_enter();
}

/* ---- the process ---- */

/* Protects the guardian from the kernel's out-of-memory killer. A guardian that runs as root is never killed, not even
 * with its whole cgroup; any other gets the lowest score that its user may set. */
static void stay_alive(void)
{
    int fd = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);

    if (fd >= 0 && write(fd, "-1000", 5) < 0 && write(fd, "0", 1) < 0)
        (void)0;
    (void)close(fd);
}

/* Renames the process, so that `pkill tia` does not match it, and closes all files, so that no reader of a pipe waits
 * for it. The process stays in its session: a user other than root may set the mode of a VT only while the VT is the
 * controlling terminal. */
static void go_away(int line)
{
    long limit = sysconf(_SC_OPEN_MAX);

    (void)prctl(PR_SET_NAME, "console-guard");
    stay_alive();
    if (chdir("/") != 0 || dup2(line, LINE) != LINE)
        _exit(1);
    if (syscall(SYS_close_range, 1u, ~0u, 0u) != 0)
        for (int fd = 1; fd < (limit > 0 && limit < 65536 ? limit : 65536); fd++)
            (void)close(fd);
    /* These numbers are descriptors of the guarded process; the guardian receives its own with messages. */
    for (int i = 0; i < KEPT_MOST; i++)
        kept[i].fd = -1;
}

static int open_signals(void)
{
    sigset_t set;

    (void)sigemptyset(&set);
    (void)sigaddset(&set, SIGCHLD);
    (void)sigaddset(&set, SIGUSR1);
    (void)sigaddset(&set, SIGUSR2);
    return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

static void listen_until_the_end(void)
{
    struct pollfd fds[] = {
        {.fd = LINE, .events = POLLIN}, {.fd = open_signals(), .events = POLLIN}, {.events = POLLIN}};

    for (;;) {
        fds[2].fd = stand_in_keys();
        if (poll(fds, 3, -1) < 0)
            continue;
        if (fds[0].revents != 0 && !take_message())
            return;
        if (fds[1].revents != 0)
            take_signals(fds[1].fd);
        spare_follow();
        if (fds[2].fd >= 0 && fds[2].revents != 0)
            stand_in_look();
    }
}

/* Closes the DRM devices: the kernel restores a device when its last descriptor is closed, so the guardian's must not
 * stay open longer than the process's. */
static void close_cards(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == CARD) {
            (void)close(kept[i].fd);
            kept[i].fd = -1;
        }
}

static void put_all_back(void)
{
    struct pollfd end = {.fd = process_end, .events = POLLIN};

    close_cards();
    cooked_at_the_end(process_group);
    traced_end();
    /* Waits until the process is gone: by then the kernel has closed its files, and thereby restored DRM devices. The
     * limit is 2 s, in case the process hangs in a driver, and 0.2 s on kernels before 5.3, which have no
     * pidfd_open. */
    if (kept_any(VT) || kept_any(FB))
        (void)poll(&end, 1, end.fd < 0 ? 200 : 2000);
    restore_screens();
    finish();
}

void guard(int line, pid_t parent, pid_t group, unsigned before)
{
    process = parent;
    process_group = group;
    go_away(line);
    if (!kept_take_over(before))
        _exit(0);
    process_end = (int)syscall(SYS_pidfd_open, parent, 0u);
    spare_start(process_end, put_all_back);
    listen_until_the_end();
    if (!kept_nothing())
        put_all_back();
    kept_finish();
    _exit(0);
}
