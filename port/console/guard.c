/* Nothing here may take a lock, as malloc does: another thread may have held it at the fork. */
#include "guard.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/kd.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "kept.h"
#include "stand_in.h"

#define LINE 0          /* the socket's descriptor in this process */
#define PATIENCE_MS 200 /* how long a terminal that accepts nothing delays the shell */

static pid_t watcher; /* the thread that is traced, or 0 */

/* ---- consoles and framebuffers ---- */

/* When a session's leader dies, the session loses its terminal, and the user may not change the VT until it is
 * somebody's controlling terminal again. Only a process that leads no group can start a session to claim it, so a child
 * does, and goes on as the guardian. */
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

    /* Text mode comes before the switch, which does not redraw a console in graphics mode. The kernel draws the text
     * only when the mode changes, so it is set to graphics first. */
    if (ioctl(fd, KDSETMODE, (long)KD_GRAPHICS) != 0 && errno == EPERM && claim_terminal(fd))
        (void)ioctl(fd, KDSETMODE, (long)KD_GRAPHICS);
    (void)ioctl(fd, KDSETMODE, (long)saved->was.vt.kd_mode);
    /* A switch that waits for an answer is completed: VT_SETMODE would forget it, and chvt would wait for ever. */
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

static int open_node(const char *path)
{
    return open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

static void restore_screens(void)
{
    for (int i = KEPT_MOST - 1; i >= 0; i--) {
        int fd = kept[i].kind == VT || kept[i].kind == FB ? open_node(kept[i].path) : -1;
        if (fd < 0)
            continue;
        if (kept[i].kind == VT)
            restore_vt(&kept[i], fd);
        else
            restore_fb(&kept[i], fd);
        (void)close(fd);
    }
}

/* ---- terminals ---- */

/* Names of pseudo-terminals are reused: is this still the terminal that was kept? */
static bool is_same_node(const struct saved *saved, int fd)
{
    struct stat s;

    return fstat(fd, &s) == 0 && s.st_ctim.tv_sec == saved->made.tv_sec && s.st_ctim.tv_nsec == saved->made.tv_nsec;
}

/* Are the modes still those of the program that died? */
static bool is_untouched(int fd, const struct termios *raw)
{
    struct termios now;

    return tcgetattr(fd, &now) == 0 && now.c_iflag == raw->c_iflag && now.c_lflag == raw->c_lflag &&
           now.c_cc[VMIN] == raw->c_cc[VMIN] && now.c_cc[VTIME] == raw->c_cc[VTIME];
}

/* A shell that has its terminal back, because tia was stopped or could not be traced, may have set its own modes: they
 * stay. */
static void restore_modes(const struct saved *saved, int fd, pid_t group)
{
    pid_t front = tcgetpgrp(fd);

    if (front > 0 && front != group && !is_untouched(fd, &saved->was.terminal.raw))
        return;
    (void)tcsetattr(fd, TCSANOW, &saved->was.terminal.before);
    (void)tcflush(fd, TCIFLUSH);
}

/* Writes the text, and removes from it what the terminal accepted. False: some is left after timeout_ms. */
static bool write_text(struct saved *saved, int timeout_ms)
{
    struct pollfd ready = {.fd = saved->fd, .events = POLLOUT};
    char *text = saved->was.text;

    while (*text != '\0') {
        ssize_t n = write(saved->fd, text, strlen(text));
        if (n > 0)
            (void)memmove(text, text + n, strlen(text + n) + 1);
        else if (n < 0 && errno != EAGAIN)
            return true;
        else if (poll(&ready, 1, timeout_ms) <= 0)
            return false;
    }
    return true;
}

static void restore_terminal(struct saved *saved, pid_t group)
{
    int fd = open_node(saved->path);

    if (fd < 0 || !is_same_node(saved, fd)) {
        (void)close(fd);
        return;
    }
    saved->fd = fd;
    if (saved->kind == TERMINAL)
        restore_modes(saved, fd, group);
    if (saved->kind == TEXT && !write_text(saved, PATIENCE_MS))
        return; /* finish() waits for this terminal */
    saved->fd = -1;
    (void)close(fd);
}

static void restore_terminals(pid_t group)
{
    for (int i = KEPT_MOST - 1; i >= 0; i--)
        if (kept[i].kind == TERMINAL || kept[i].kind == TEXT)
            restore_terminal(&kept[i], group);
}

/* ---- what may take long ---- */

/* Codes from BTN_MISC on are buttons of mice and joysticks. */
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

/* Reads all events: asking for the keys removes only key events from the queue, and the rest would wake us again. */
static bool is_released(int fd)
{
    struct input_event events[64];

    while (read(fd, events, sizeof events) > 0)
        ;
    return !is_any_key_down(fd);
}

/* Does what can be done now; true when nothing is left to do. */
static bool finish_one(struct saved *saved)
{
    bool done = saved->fd < 0 || (saved->kind != TEXT && saved->kind != KEYBOARD);

    if (!done)
        done = saved->kind == TEXT ? write_text(saved, 0) : is_released(saved->fd);
    if (done && saved->fd >= 0) {
        (void)close(saved->fd);
        saved->fd = -1;
    }
    return done;
}

/* A key that is down when its grab ends would repeat on the console, so a keyboard's descriptor, and with it the grab,
 * is kept until its keys are up. */
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

/* ---- signals ---- */

/* The watcher stops and continues with its process. Its death is not reaped here: see guard(). */
static void follow_watcher(void)
{
    siginfo_t what = {0};

    while (watcher != 0 && waitid(P_PID, (id_t)watcher, &what, WSTOPPED | WNOHANG | __WALL) == 0 && what.si_pid != 0) {
        int number = what.si_status & 0xff;
        bool stop = what.si_status >> 8 == PTRACE_EVENT_STOP && number != SIGTRAP;
        if (stop)
            stand_in_begin();
        else
            stand_in_end();
        (void)ptrace(stop ? PTRACE_LISTEN : PTRACE_CONT, watcher, NULL, NULL);
        what.si_pid = 0;
    }
}

static void take_signals(int signals)
{
    struct signalfd_siginfo signal;

    while (read(signals, &signal, sizeof signal) == (ssize_t)sizeof signal)
        if (signal.ssi_signo == SIGCHLD)
            follow_watcher();
        else if (signal.ssi_signo == SIGUSR1)
            stand_in_leave();
        else
            stand_in_enter();
}

/* ---- messages ---- */

/* The descriptor that came with the message, or -1. */
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

    if (saved->kind == WATCHER) {
        watcher = ptrace(PTRACE_SEIZE, saved->was.watcher, NULL, NULL) == 0 ? saved->was.watcher : 0;
        (void)send(LINE, &ready, 1, MSG_NOSIGNAL);
        return;
    }
    if (old && old->fd >= 0)
        (void)close(old->fd);
    (void)kept_note(saved);
}

/* False when the other end is closed. */
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

/* ---- the process ---- */

/* When memory is short, the kernel never kills root's guardian, not even with its whole cgroup; another user's gets the
 * lowest score that its user may give. */
static void stay_alive(void)
{
    int fd = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);

    if (fd >= 0 && write(fd, "-1000", 5) < 0 && write(fd, "0", 1) < 0)
        (void)0;
    (void)close(fd);
}

/* Takes a name of its own, so that killing tia by name spares it, and closes all files, so that nobody waits for it at
 * a pipe. It stays in its session: a user who is not root may set the mode of a VT only while that is the controlling
 * terminal. */
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
    /* These were descriptors of the other process; ours come with messages. */
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
        if (fds[2].fd >= 0 && fds[2].revents != 0)
            stand_in_look();
    }
}

/* The kernel puts a DRM device back when its last descriptor is closed, so ours must not outlive the dead process's. */
static void close_cards(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == CARD) {
            (void)close(kept[i].fd);
            kept[i].fd = -1;
        }
}

void guard(int line, pid_t parent, pid_t group)
{
    go_away(line);
    struct pollfd end = {.fd = (int)syscall(SYS_pidfd_open, parent, 0u), .events = POLLIN};
    listen_until_the_end();
    if (kept_nothing())
        _exit(0);
    close_cards();
    restore_terminals(group);
    /* Now the parent of the dead process may see its death. */
    if (watcher != 0)
        (void)waitpid(watcher, NULL, __WALL);
    /* The process is gone when the kernel has closed its files, and with them put DRM devices back. At most 2 s, in
     * case it hangs in a driver; 0.2 s on kernels before 5.3, which have no pidfd_open. */
    if (kept_any(VT) || kept_any(FB))
        (void)poll(&end, 1, end.fd < 0 ? 200 : 2000);
    restore_screens();
    finish();
    _exit(0);
}
