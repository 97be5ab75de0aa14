#include "guardian.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "console/guard.h"
#include "console/kept.h"

#define RETRY_MS 100               /* after a fork that failed */
#define WATCHER_STACK (256 * 1024) /* of a thread that waits, and forks */

/* The lock holds this and the table: the watcher (guard.h), which starts a new guardian when the
 * one that there was has died, uses both. */
static struct {
    pthread_mutex_t lock;
    pthread_t watcher;
    sem_t traced; /* the watcher's guardian has answered */
    int line;     /* to the guardian; -1: there is none */
    pid_t process;
    bool watched; /* there is a watcher */
    bool ending;
} guardian = {.lock = PTHREAD_MUTEX_INITIALIZER, .line = -1};

/* ---- messages ---- */

static int send_message(const struct thing *t)
{
    _Alignas(struct cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {0};
    struct iovec bytes = {(void *)(uintptr_t)t, sizeof *t};
    struct msghdr message = {.msg_iov = &bytes, .msg_iovlen = 1};

    if (!t->forget && t->fd >= 0) {
        message.msg_control = control;
        message.msg_controllen = sizeof control;
        struct cmsghdr *part = CMSG_FIRSTHDR(&message);
        *part = (struct cmsghdr){.cmsg_level = SOL_SOCKET, .cmsg_type = SCM_RIGHTS, .cmsg_len = CMSG_LEN(sizeof(int))};
        (void)memcpy(CMSG_DATA(part), &t->fd, sizeof t->fd);
    }
    return sendmsg(guardian.line, &message, MSG_NOSIGNAL) == (ssize_t)sizeof *t ? 0 : -1;
}

/* The guardian has the table from the fork, but not the descriptors. */
static void send_descriptors(void)
{
    for (int i = 0; i < THINGS; i++)
        if (kept[i].kind != NOTHING && kept[i].fd >= 0)
            (void)send_message(&kept[i]);
}

/* ---- the process ---- */

/* No signal to the group or the session ends it: it has all of them blocked from its first moment,
 * and is in a group of its own, where SIGKILL does not find it, before this returns. */
static int start_process(void)
{
    int ends[2];
    pid_t parent = getpid(), group = getpgrp();
    sigset_t all, old;

    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return -1;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, &old);
    guardian.process = fork();
    if (guardian.process == 0)
        guard(ends[1], parent, group);
    if (guardian.process > 0)
        (void)setpgid(guardian.process, guardian.process);
    (void)pthread_sigmask(SIG_SETMASK, &old, NULL);
    (void)close(ends[1]);
    if (guardian.process < 0) {
        (void)close(ends[0]);
        return -1;
    }
    guardian.line = ends[0];
    send_descriptors();
    return 0;
}

/* It has ended, or will now that it has nothing to listen to: even one that somebody has stopped. */
static void reap_process(void)
{
    if (guardian.line < 0)
        return;
    (void)close(guardian.line);
    guardian.line = -1;
    (void)kill(guardian.process, SIGCONT);
    while (waitpid(guardian.process, NULL, 0) < 0 && errno == EINTR)
        ;
}

/* ---- the watcher ---- */

/* Asks the guardian to trace this thread. Yama, where it is there, wants to know whom we allow. */
static void be_traced(void)
{
    const struct thing t = {.kind = WATCHER, .fd = -1, .was.watcher = (pid_t)syscall(SYS_gettid)};
    char answer;

    (void)prctl(PR_SET_PTRACER, (unsigned long)guardian.process, 0, 0, 0);
    if (send_message(&t) == 0)
        (void)!recv(guardian.line, &answer, 1, 0);
}

/* Returns when the guardian has died, or is meant to end. */
static void await_death(int line)
{
    struct pollfd end = {.fd = line, .events = POLLIN};

    while (poll(&end, 1, -1) <= 0)
        ;
}

static void *watch(void *arg)
{
    (void)arg;
    be_traced();
    (void)sem_post(&guardian.traced);
    for (;;) {
        await_death(guardian.line);
        (void)pthread_mutex_lock(&guardian.lock);
        if (guardian.ending)
            break;
        reap_process();
        while (start_process() != 0)
            (void)poll(NULL, 0, RETRY_MS);
        be_traced();
        (void)pthread_mutex_unlock(&guardian.lock);
    }
    (void)pthread_mutex_unlock(&guardian.lock);
    return NULL;
}

/* With every signal blocked: they are for the other threads, and a traced thread would stop at each. */
static void start_watcher(void)
{
    pthread_attr_t small;
    sigset_t all, old;

    (void)pthread_attr_init(&small);
    (void)pthread_attr_setstacksize(&small, WATCHER_STACK);
    (void)sem_init(&guardian.traced, 0, 0);
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, &old);
    guardian.ending = false;
    guardian.watched = pthread_create(&guardian.watcher, &small, watch, NULL) == 0;
    (void)pthread_attr_destroy(&small);
    (void)pthread_sigmask(SIG_SETMASK, &old, NULL);
    while (guardian.watched && sem_wait(&guardian.traced) != 0)
        ;
}

static int start(void)
{
    if (start_process() != 0)
        return -1;
    start_watcher();
    return 0;
}

/* The guardian first: a thread that it traces does not end before it. */
static void end(void)
{
    guardian.ending = true;
    (void)shutdown(guardian.line, SHUT_RDWR);
    if (guardian.watched) {
        (void)kill(guardian.process, SIGCONT);
        (void)pthread_mutex_unlock(&guardian.lock);
        (void)pthread_join(guardian.watcher, NULL);
        (void)pthread_mutex_lock(&guardian.lock);
        guardian.watched = false;
        (void)sem_destroy(&guardian.traced);
    }
    reap_process();
}

/* ---- things ---- */

static int keep(const struct thing *t)
{
    int status = -1;

    (void)pthread_mutex_lock(&guardian.lock);
    if (kept_note(t) == 0)
        status = guardian.line < 0 ? start() : 0;
    /* A guardian that has just died is followed by one that has the table. */
    if (status == 0)
        (void)send_message(t);
    (void)pthread_mutex_unlock(&guardian.lock);
    return status;
}

static void forget(struct thing *t)
{
    t->forget = true;
    t->fd = -1;
    (void)pthread_mutex_lock(&guardian.lock);
    if (kept_note(t) == 0 && guardian.line >= 0) {
        (void)send_message(t);
        if (kept_nothing())
            end();
    }
    (void)pthread_mutex_unlock(&guardian.lock);
}

static struct thing named(enum kind kind, const char *path)
{
    struct thing t = {.kind = kind, .fd = -1};

    (void)snprintf(t.path, sizeof t.path, "%s", path);
    return t;
}

/* ---- consoles, framebuffers, keyboards ---- */

int guardian_keep_vt(int fd, const char *path, unsigned back_to)
{
    struct thing t = named(VT, path);

    t.fd = fd;
    t.was.vt.back_to = back_to;
    if (ioctl(fd, KDGETMODE, &t.was.vt.kd_mode) != 0 || ioctl(fd, VT_GETMODE, &t.was.vt.mode) != 0)
        return -1;
    return keep(&t);
}

int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var)
{
    struct thing t = named(FB, path);

    t.was.fb = *var;
    return keep(&t);
}

/* One process has many keyboards, whose names may be long: their descriptors tell them apart. */
static struct thing numbered(enum kind kind, int fd)
{
    struct thing t = {.kind = kind, .fd = fd};

    (void)snprintf(t.path, sizeof t.path, "descriptor %d", fd);
    return t;
}

int guardian_keep_keyboard(int fd)
{
    const struct thing t = numbered(KEYBOARD, fd);

    return keep(&t);
}

int guardian_keep_card(int fd)
{
    const struct thing t = numbered(CARD, fd);

    return keep(&t);
}

void guardian_forget_vt(const char *path)
{
    struct thing t = named(VT, path);

    forget(&t);
}

void guardian_forget_fb(const char *path)
{
    struct thing t = named(FB, path);

    forget(&t);
}

void guardian_forget_keyboard(int fd)
{
    struct thing t = numbered(KEYBOARD, fd);

    forget(&t);
}

void guardian_forget_card(int fd)
{
    struct thing t = numbered(CARD, fd);

    forget(&t);
}

/* ---- terminals ---- */

static bool describe_terminal(enum kind kind, int fd, struct thing *t)
{
    struct stat s;

    *t = (struct thing){.kind = kind, .fd = -1};
    if (ttyname_r(fd, t->path, sizeof t->path) != 0 || fstat(fd, &s) != 0)
        return false;
    t->made = s.st_ctim;
    return true;
}

static bool describe_text(int fd, const char *text, struct thing *t)
{
    if (!describe_terminal(TEXT, fd, t) || strlen(text) >= sizeof t->was.text)
        return false;
    (void)snprintf(t->was.text, sizeof t->was.text, "%s", text);
    return true;
}

int guardian_keep_terminal(int fd, const struct termios *raw)
{
    struct thing t;

    if (!describe_terminal(TERMINAL, fd, &t) || tcgetattr(fd, &t.was.terminal.before) != 0)
        return -1;
    t.was.terminal.raw = *raw;
    return keep(&t);
}

int guardian_keep_text(int fd, const char *text)
{
    struct thing t;

    return describe_text(fd, text, &t) ? keep(&t) : -1;
}

void guardian_forget_terminal(int fd)
{
    struct thing t;

    if (describe_terminal(TERMINAL, fd, &t))
        forget(&t);
}

void guardian_forget_text(int fd, const char *text)
{
    struct thing t;

    if (describe_text(fd, text, &t))
        forget(&t);
}
