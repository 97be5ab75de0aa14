#include "keeper.h"

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
#include "console/restore_table.h"

#define RETRY_MS 100               /* pause after a fork that failed */
#define SYNC_MS 200                /* time limit for the answer of a guardian, which may be stopped */
#define WATCHER_STACK (256 * 1024) /* bytes; the threads only wait and fork */

/* The guardian, and the two threads that it traces (guard.h): the watcher, which replaces a guardian that died, and the
 * held thread. The watcher also uses this struct and the table, so the lock protects both. */
static struct {
    pthread_mutex_t lock;
    pthread_t watcher, held;
    sem_t traced;   /* the guardian has answered the watcher */
    sem_t holding;  /* the held thread has stored its ID in `holder` */
    sem_t released; /* the held thread may end */
    pid_t holder;   /* thread ID of the held thread */
    int line;       /* socket to the guardian; -1: there is no guardian */
    pid_t process;
    bool watched; /* a watcher exists */
    bool ending;
} guardian = {.lock = PTHREAD_MUTEX_INITIALIZER, .line = -1};

/* ---- messages ---- */

static int send_message(const struct saved *saved)
{
    _Alignas(struct cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {0};
    struct iovec bytes = {(void *)(uintptr_t)saved, sizeof *saved};
    struct msghdr message = {.msg_iov = &bytes, .msg_iovlen = 1};

    if (!saved->forget && saved->fd >= 0) {
        message.msg_control = control;
        message.msg_controllen = sizeof control;
        struct cmsghdr *part = CMSG_FIRSTHDR(&message);
        *part = (struct cmsghdr){.cmsg_level = SOL_SOCKET, .cmsg_type = SCM_RIGHTS, .cmsg_len = CMSG_LEN(sizeof(int))};
        (void)memcpy(CMSG_DATA(part), &saved->fd, sizeof saved->fd);
    }
    return sendmsg(guardian.line, &message, MSG_NOSIGNAL) == (ssize_t)sizeof *saved ? 0 : -1;
}

/* Sends the descriptors to a new guardian, which has the table from the fork, but has closed the descriptors. */
static void send_descriptors(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind != NOTHING && kept[i].fd >= 0)
            (void)send_message(&kept[i]);
}

/* ---- the process ---- */

/* Forks the guardian; returns 0, or -1. Signals to this process's group do not end the guardian: it blocks all signals
 * from the start. Since SIGKILL cannot be blocked, this function also puts it into a group of its own. */
static int start_process(void)
{
    int ends[2];
    pid_t parent = getpid(), group = getpgrp();
    sigset_t all, old;

    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return -1;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, &old);
    unsigned before = kept_guardian();
    guardian.process = fork();
    if (guardian.process == 0)
        guard(ends[1], parent, group, before);
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

/* Ends the guardian by closing the socket, and reaps it. Sends SIGCONT in case the guardian is stopped. */
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

static pid_t own_number(void)
{
    return (pid_t)syscall(SYS_gettid);
}

/* Asks the guardian to trace the calling thread and the held thread. Where the kernel has Yama, this process must
 * permit the tracing. */
static void be_traced(void)
{
    const struct saved saved = {
        .kind = THREADS, .fd = -1, .was.threads = {.reports = own_number(), .holds = guardian.holder}};
    char answer;

    (void)prctl(PR_SET_PTRACER, (unsigned long)guardian.process, 0, 0, 0);
    if (send_message(&saved) == 0)
        (void)!recv(guardian.line, &answer, 1, 0);
}

/* Waits until the guardian has died or end() has shut the socket down. */
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

static void *be_held(void *arg)
{
    (void)arg;
    guardian.holder = own_number();
    (void)sem_post(&guardian.holding);
    while (sem_wait(&guardian.released) != 0)
        ;
    return NULL;
}

/* Starts the held thread; guardian.holder is 0 if that fails. */
static void start_held(const pthread_attr_t *small)
{
    guardian.holder = 0;
    (void)sem_init(&guardian.holding, 0, 0);
    (void)sem_init(&guardian.released, 0, 0);
    if (pthread_create(&guardian.held, small, be_held, NULL) == 0)
        while (sem_wait(&guardian.holding) != 0)
            ;
}

/* Starts both threads with all signals blocked: other threads handle the signals, and a traced thread would stop at
 * each one. */
static void start_threads(void)
{
    pthread_attr_t small;
    sigset_t all, old;

    (void)pthread_attr_init(&small);
    (void)pthread_attr_setstacksize(&small, WATCHER_STACK);
    (void)sem_init(&guardian.traced, 0, 0);
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, &old);
    start_held(&small);
    guardian.ending = false;
    guardian.watched = pthread_create(&guardian.watcher, &small, watch, NULL) == 0;
    (void)pthread_attr_destroy(&small);
    (void)pthread_sigmask(SIG_SETMASK, &old, NULL);
    while (guardian.watched && sem_wait(&guardian.traced) != 0)
        ;
}

static int start(void)
{
    kept_share();
    if (start_process() != 0)
        return -1;
    start_threads();
    return 0;
}

/* Ends the guardian before the watcher and the held thread: a traced thread cannot end before its tracer. */
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
    if (guardian.holder != 0) {
        (void)sem_post(&guardian.released);
        (void)pthread_join(guardian.held, NULL);
    }
    (void)sem_destroy(&guardian.released);
    (void)sem_destroy(&guardian.holding);
}

/* ---- the table ---- */

int keeper_keep(const struct saved *saved)
{
    int status = -1;

    (void)pthread_mutex_lock(&guardian.lock);
    if (kept_note(saved) == 0)
        status = guardian.line < 0 ? start() : 0;
    /* If the message cannot be sent, the guardian has just died; the next one gets the table. */
    if (status == 0)
        (void)send_message(saved);
    (void)pthread_mutex_unlock(&guardian.lock);
    return status;
}

void keeper_forget(struct saved *saved)
{
    saved->forget = true;
    saved->fd = -1;
    (void)pthread_mutex_lock(&guardian.lock);
    if (kept_note(saved) == 0 && guardian.line >= 0) {
        (void)send_message(saved);
        if (kept_nothing())
            end();
    }
    (void)pthread_mutex_unlock(&guardian.lock);
}

void keeper_again(const struct saved *like)
{
    (void)pthread_mutex_lock(&guardian.lock);
    const struct saved *known = kept_find(like);
    if (known && guardian.line >= 0)
        (void)send_message(known);
    (void)pthread_mutex_unlock(&guardian.lock);
}

void keeper_sync(void)
{
    const struct saved saved = {.kind = SYNC, .fd = -1};
    bool sent;

    (void)pthread_mutex_lock(&guardian.lock);
    kept_forget_answers();
    sent = guardian.line >= 0 && send_message(&saved) == 0;
    (void)pthread_mutex_unlock(&guardian.lock);
    if (sent)
        kept_await_answer(SYNC_MS);
}
