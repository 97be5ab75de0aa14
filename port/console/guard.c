/* Nothing here may need a lock that another thread of the guarded process held at the fork. */
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

#define LINE 0          /* the descriptor of the line in this process */
#define PATIENCE_MS 200 /* how long the shell waits for a terminal that takes nothing */

static pid_t watcher; /* the thread that is traced, or 0 */

/* ---- consoles and framebuffers ---- */

/* When the process that died was its session's leader, the session has no terminal any more, and
 * its user no right to the VT until it is somebody's terminal again. A child can have it: it leads
 * no group, and so may lead a session. The child goes on as the guardian. */
static bool claim_terminal(int fd)
{
    pid_t child = fork();

    if (child > 0)
        _exit(0);
    return child == 0 && setsid() > 0 && ioctl(fd, TIOCSCTTY, 0L) == 0;
}

static void restore_vt(const struct thing *t, int fd)
{
    struct vt_mode mode = t->was.vt.mode;

    /* Text before the switch: a console in graphics mode whose owner is dead is not redrawn by it.
     * The kernel draws the text when the mode changes, so it has to change. */
    if (ioctl(fd, KDSETMODE, (long)KD_GRAPHICS) != 0 && errno == EPERM && claim_terminal(fd))
        (void)ioctl(fd, KDSETMODE, (long)KD_GRAPHICS);
    (void)ioctl(fd, KDSETMODE, (long)t->was.vt.kd_mode);
    (void)ioctl(fd, VT_SETMODE, &mode);
    if (t->was.vt.back_to != 0)
        (void)ioctl(fd, VT_ACTIVATE, (long)t->was.vt.back_to);
}

static void restore_fb(const struct thing *t, int fd)
{
    struct fb_var_screeninfo var = t->was.fb;

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
    for (int i = THINGS - 1; i >= 0; i--) {
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

/* Names of pseudo-terminals are given again: is this one still the one that was kept? */
static bool is_same_node(const struct thing *t, int fd)
{
    struct stat s;

    return fstat(fd, &s) == 0 && s.st_ctim.tv_sec == t->made.tv_sec && s.st_ctim.tv_nsec == t->made.tv_nsec;
}

/* Has nobody set other modes than those of the program that died? */
static bool is_untouched(int fd, const struct termios *raw)
{
    struct termios now;

    return tcgetattr(fd, &now) == 0 && now.c_iflag == raw->c_iflag && now.c_lflag == raw->c_lflag &&
           now.c_cc[VMIN] == raw->c_cc[VMIN] && now.c_cc[VTIME] == raw->c_cc[VTIME];
}

/* A shell that has its terminal back, because tia was stopped or because nothing is traced, may
 * have set the modes that it wants. */
static void restore_modes(const struct thing *t, int fd, pid_t group)
{
    pid_t front = tcgetpgrp(fd);

    if (front > 0 && front != group && !is_untouched(fd, &t->was.terminal.raw))
        return;
    (void)tcsetattr(fd, TCSANOW, &t->was.terminal.before);
    (void)tcflush(fd, TCIFLUSH);
}

/* Writes what the terminal takes of the text within the time; what it took is cut off. */
static bool write_text(struct thing *t, int timeout_ms)
{
    struct pollfd ready = {.fd = t->fd, .events = POLLOUT};
    char *text = t->was.text;

    while (*text != '\0') {
        ssize_t n = write(t->fd, text, strlen(text));
        if (n > 0)
            (void)memmove(text, text + n, strlen(text + n) + 1);
        else if (n < 0 && errno != EAGAIN)
            return true;
        else if (poll(&ready, 1, timeout_ms) <= 0)
            return false;
    }
    return true;
}

static void restore_terminal(struct thing *t, pid_t group)
{
    int fd = open_node(t->path);

    if (fd < 0 || !is_same_node(t, fd)) {
        (void)close(fd);
        return;
    }
    t->fd = fd;
    if (t->kind == TERMINAL)
        restore_modes(t, fd, group);
    if (t->kind == TEXT && !write_text(t, PATIENCE_MS))
        return; /* finish() waits for this terminal */
    t->fd = -1;
    (void)close(fd);
}

static void restore_terminals(pid_t group)
{
    for (int i = THINGS - 1; i >= 0; i--)
        if (kept[i].kind == TERMINAL || kept[i].kind == TEXT)
            restore_terminal(&kept[i], group);
}

/* ---- what takes its time ---- */

/* Mice and joysticks have the codes above. */
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

/* Asking for the keys also takes those events from the queue that had woken us, but not the others. */
static bool is_released(int fd)
{
    struct input_event events[64];

    while (read(fd, events, sizeof events) > 0)
        ;
    return !is_any_key_down(fd);
}

/* Does what can be done now; true when nothing is left to do. */
static bool finish_one(struct thing *t)
{
    bool done = t->fd < 0 || (t->kind != TEXT && t->kind != KEYBOARD);

    if (!done)
        done = t->kind == TEXT ? write_text(t, 0) : is_released(t->fd);
    if (done && t->fd >= 0) {
        (void)close(t->fd);
        t->fd = -1;
    }
    return done;
}

/* A key that is down when its grab ends would repeat on the console below, so a grab, which lasts
 * as long as its descriptor, ends with the key. */
static void finish(void)
{
    struct pollfd fds[THINGS];
    nfds_t waiting;

    do {
        waiting = 0;
        for (int i = 0; i < THINGS; i++)
            if (!finish_one(&kept[i]))
                fds[waiting++] = (struct pollfd){.fd = kept[i].fd, .events = kept[i].kind == TEXT ? POLLOUT : POLLIN};
    } while (waiting > 0 && poll(fds, waiting, -1) >= 0);
}

/* ---- signals ---- */

/* The watcher stops and goes on with its process. A death is not taken here: see guard(). */
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

/* Its descriptor, when it brings one. */
static int descriptor_of(struct msghdr *message)
{
    struct cmsghdr *part = CMSG_FIRSTHDR(message);
    int fd = -1;

    if (part && part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_RIGHTS)
        (void)memcpy(&fd, CMSG_DATA(part), sizeof fd);
    return fd;
}

static void follow(struct thing *t)
{
    const struct thing *old = kept_find(t);
    const char ready = GUARD_READY;

    if (t->kind == WATCHER) {
        watcher = ptrace(PTRACE_SEIZE, t->was.watcher, NULL, NULL) == 0 ? t->was.watcher : 0;
        (void)send(LINE, &ready, 1, MSG_NOSIGNAL);
        return;
    }
    if (old && old->fd >= 0)
        (void)close(old->fd);
    (void)kept_note(t);
}

/* False when the other end is gone. */
static bool take_message(void)
{
    struct thing t;
    _Alignas(struct cmsghdr) char control[CMSG_SPACE(sizeof(int))];
    struct iovec bytes = {&t, sizeof t};
    struct msghdr message = {
        .msg_iov = &bytes, .msg_iovlen = 1, .msg_control = control, .msg_controllen = sizeof control};

    if (recvmsg(LINE, &message, MSG_CMSG_CLOEXEC) != (ssize_t)sizeof t)
        return false;
    t.fd = descriptor_of(&message);
    follow(&t);
    return true;
}

/* ---- the process ---- */

/* Root's guardian is never chosen by the kernel when memory is short, and not killed with its group
 * of processes; another user's is as unlikely a choice as its user may make it. */
static void stay_alive(void)
{
    int fd = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);

    if (fd >= 0 && write(fd, "-1000", 5) < 0 && write(fd, "0", 1) < 0)
        (void)0;
    (void)close(fd);
}

/* Not to be found by the command's name, and nobody's reader or writer. It stays in its session: a user who is not root
 * may set the mode of a VT only while that is the controlling terminal. */
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
    /* Theirs were the other process's numbers. Our own come with messages. */
    for (int i = 0; i < THINGS; i++)
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

/* Then the kernel takes them from the dead process. */
static void close_cards(void)
{
    for (int i = 0; i < THINGS; i++)
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
    /* From here on the parent of the dead process knows that it is dead. */
    if (watcher != 0)
        (void)waitpid(watcher, NULL, __WALL);
    /* The kernel puts a DRM device back when the last of its files is closed. The process is
     * gone when that is done; 2 s for one that hangs in its driver, 0.2 s for kernels < 5.3. */
    if (kept_any(VT) || kept_any(FB))
        (void)poll(&end, 1, end.fd < 0 ? 200 : 2000);
    restore_screens();
    finish();
    _exit(0);
}
