#include "guardian.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

enum kind { NOTHING, VT, TERMINAL, SCREEN, FB };

/* A thing that is kept: how to find it, and how it was. Also the message that says so. */
struct thing {
    enum kind kind;
    bool forget; /* of a message: it is kept no longer */
    char path[64];
    struct timespec made; /* TERMINAL, SCREEN: the node's change time, which another terminal's differs in */
    union {
        struct {
            int kd_mode;
            struct vt_mode mode;
            unsigned back_to;
        } vt;
        struct termios terminal;
        char screen[64];
        struct fb_var_screeninfo fb;
    } was;
};

/* Both processes have this table: the guardian's is the parent's at the fork and follows it. */
#define THINGS 8
static struct thing kept[THINGS];
static int line = -1; /* to the guardian */
static pid_t guardian;

/* ---- the guardian's side: nothing here may need a lock that another thread held at the fork ---- */

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

    /* Text first: a console in graphics mode whose owner is dead is not redrawn by a switch. */
    if (ioctl(fd, KDSETMODE, (long)t->was.vt.kd_mode) != 0 && errno == EPERM && claim_terminal(fd))
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

/* Names of pseudo-terminals are given again: is this one still the one that was kept? */
static bool is_same_node(const struct thing *t, int fd)
{
    struct stat s;

    return fstat(fd, &s) == 0 && s.st_ctim.tv_sec == t->made.tv_sec && s.st_ctim.tv_nsec == t->made.tv_nsec;
}

/* A shell that has taken its terminal back already has set the modes that it wants. */
static void restore_terminal(const struct thing *t, int fd, pid_t group)
{
    pid_t front = tcgetpgrp(fd);

    if (front > 0 && front != group)
        return;
    (void)tcsetattr(fd, TCSANOW, &t->was.terminal);
    (void)tcflush(fd, TCIFLUSH);
}

/* Whatever the shell may have written already: it did not know that the screen was not its own. */
static void restore_screen(const struct thing *t, int fd)
{
    ssize_t n = write(fd, t->was.screen, strlen(t->was.screen));
    (void)n;
}

static void restore(const struct thing *t, pid_t group)
{
    int fd = open(t->path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);

    if (fd < 0)
        return;
    if (t->kind == VT)
        restore_vt(t, fd);
    else if (t->kind == FB)
        restore_fb(t, fd);
    else if (is_same_node(t, fd) && t->kind == SCREEN)
        restore_screen(t, fd);
    else if (is_same_node(t, fd))
        restore_terminal(t, fd, group);
    (void)close(fd);
}

static struct thing *find(enum kind kind, const char *path)
{
    for (int i = 0; i < THINGS; i++)
        if (kept[i].kind == kind && (path == NULL || strcmp(kept[i].path, path) == 0))
            return &kept[i];
    return NULL;
}

/* Follows a message, in either process. */
static int note(const struct thing *t)
{
    struct thing *place = find(t->kind, t->path);

    if (place == NULL)
        place = t->forget ? NULL : find(NOTHING, NULL);
    if (place == NULL)
        return -1;
    *place = *t;
    if (t->forget)
        place->kind = NOTHING;
    return 0;
}

static void restore_all(pid_t group, bool terminals)
{
    for (int i = THINGS - 1; i >= 0; i--)
        if (kept[i].kind != NOTHING && (kept[i].kind == TERMINAL || kept[i].kind == SCREEN) == terminals)
            restore(&kept[i], group);
}

/* Not to be found by the command's name, and nobody's reader or writer. It stays in its session: a user who is not root
 * may set the mode of a VT only while that is the controlling terminal. */
static void go_away(int keep)
{
    long limit = sysconf(_SC_OPEN_MAX);

    (void)prctl(PR_SET_NAME, "console-guard");
    if (chdir("/") != 0 || dup2(keep, 0) != 0)
        _exit(1);
    if (syscall(SYS_close_range, 1u, ~0u, 0u) != 0)
        for (int fd = 1; fd < (limit > 0 && limit < 65536 ? limit : 65536); fd++)
            (void)close(fd);
}

static void guard(int listen, pid_t parent, pid_t group)
{
    struct thing message;

    go_away(listen);
    struct pollfd end = {.fd = (int)syscall(SYS_pidfd_open, parent, 0u), .events = POLLIN};
    while (recv(0, &message, sizeof message, 0) == (ssize_t)sizeof message)
        (void)note(&message);
    restore_all(group, true);
    /* The kernel puts a DRM device back when the last of its files is closed. The process is
     * gone when that is done; 2 s for one that hangs in its driver, 0.2 s for kernels < 5.3. */
    if (find(VT, NULL) != NULL || find(FB, NULL) != NULL)
        (void)poll(&end, 1, end.fd < 0 ? 200 : 2000);
    restore_all(group, false);
    _exit(0);
}

/* ---- the side of the process that is guarded ---- */

static int start(void)
{
    int ends[2];
    pid_t parent = getpid(), group = getpgrp();
    sigset_t all, old;

    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return -1;
    /* No signal to the group or the session ends it: it blocks all of them from its first moment,
     * and is in a group of its own, where SIGKILL does not find it, before this returns. */
    (void)sigfillset(&all);
    (void)sigprocmask(SIG_BLOCK, &all, &old);
    guardian = fork();
    if (guardian == 0)
        guard(ends[1], parent, group);
    if (guardian > 0)
        (void)setpgid(guardian, guardian);
    (void)sigprocmask(SIG_SETMASK, &old, NULL);
    (void)close(ends[1]);
    if (guardian < 0) {
        (void)close(ends[0]);
        return -1;
    }
    line = ends[0];
    return 0;
}

static void end(void)
{
    for (int i = 0; i < THINGS; i++)
        if (kept[i].kind != NOTHING)
            return;
    (void)close(line);
    line = -1;
    while (waitpid(guardian, NULL, 0) < 0 && errno == EINTR)
        ;
}

static int keep(const struct thing *t)
{
    if (note(t) != 0)
        return -1;
    if (line < 0)
        return start();
    return send(line, t, sizeof *t, MSG_NOSIGNAL) == (ssize_t)sizeof *t ? 0 : -1;
}

static void forget(enum kind kind, const char *path)
{
    struct thing t = {.kind = kind, .forget = true};

    (void)snprintf(t.path, sizeof t.path, "%s", path);
    if (note(&t) != 0 || line < 0)
        return;
    (void)send(line, &t, sizeof t, MSG_NOSIGNAL);
    end();
}

int guardian_keep_vt(const char *path, unsigned back_to)
{
    struct thing t = {.kind = VT, .was.vt.back_to = back_to};
    int fd = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC), bad;

    if (fd < 0)
        return -1;
    bad = ioctl(fd, KDGETMODE, &t.was.vt.kd_mode) != 0 || ioctl(fd, VT_GETMODE, &t.was.vt.mode) != 0;
    (void)close(fd);
    (void)snprintf(t.path, sizeof t.path, "%s", path);
    return bad ? -1 : keep(&t);
}

/* Which terminal `fd` is. */
static bool describe_terminal(int fd, struct thing *t)
{
    struct stat s;

    if (ttyname_r(fd, t->path, sizeof t->path) != 0 || fstat(fd, &s) != 0)
        return false;
    t->made = s.st_ctim;
    return true;
}

int guardian_keep_terminal(int fd)
{
    struct thing t = {.kind = TERMINAL};

    if (!describe_terminal(fd, &t) || tcgetattr(fd, &t.was.terminal) != 0)
        return -1;
    return keep(&t);
}

int guardian_keep_screen(int fd, const char *text)
{
    struct thing t = {.kind = SCREEN};

    if (!describe_terminal(fd, &t) || strlen(text) >= sizeof t.was.screen)
        return -1;
    (void)snprintf(t.was.screen, sizeof t.was.screen, "%s", text);
    return keep(&t);
}

int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var)
{
    struct thing t = {.kind = FB, .was.fb = *var};

    (void)snprintf(t.path, sizeof t.path, "%s", path);
    return keep(&t);
}

void guardian_forget_vt(const char *path)
{
    forget(VT, path);
}
void guardian_forget_fb(const char *path)
{
    forget(FB, path);
}

static void forget_by_descriptor(enum kind kind, int fd)
{
    char path[sizeof kept->path];

    if (ttyname_r(fd, path, sizeof path) == 0)
        forget(kind, path);
}

void guardian_forget_terminal(int fd)
{
    forget_by_descriptor(TERMINAL, fd);
}
void guardian_forget_screen(int fd)
{
    forget_by_descriptor(SCREEN, fd);
}
