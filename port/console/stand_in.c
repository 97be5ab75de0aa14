#include "stand_in.h"

#include <fcntl.h>
#include <linux/input.h>
#include <signal.h>
#include <stdio.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "restore_table.h"
#include "vt_mark.h"

/* Requests as in drm.h, without libdrm's headers. */
#define DRM_SET_MASTER _IO('d', 0x1e)
#define DRM_DROP_MASTER _IO('d', 0x1f)

static int keys = -1;

/* ---- consoles ---- */

static void own_consoles(char mark)
{
    struct vt_mode mode = {.mode = VT_PROCESS, .waitv = mark, .relsig = SIGUSR1, .acqsig = SIGUSR2};

    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == VT && kept[i].fd >= 0)
            (void)ioctl(kept[i].fd, VT_SETMODE, &mode);
}

/* Makes an ioctl request on all entries of a kind; true if it succeeded on one of them. */
static bool ioctl_all(enum kind kind, unsigned long request, long value)
{
    bool done = false;

    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == kind && kept[i].fd >= 0 && ioctl(kept[i].fd, request, value) == 0)
            done = true;
    return done;
}

/* Releases the screen, then the keyboards, if the kernel has requested the console. DRM devices come before the
 * console, since the kernel draws the other console's text when this one is released. */
void stand_in_leave(void)
{
    bool was_master = ioctl_all(CARD, DRM_DROP_MASTER, 0);

    if (!ioctl_all(VT, VT_RELDISP, 1)) { /* there was no request */
        if (was_master)
            (void)ioctl_all(CARD, DRM_SET_MASTER, 0);
        return;
    }
    own_consoles(VT_MARK_LEFT);
    (void)ioctl_all(KEYBOARD, EVIOCGRAB, 0);
}

void stand_in_enter(void)
{
    (void)ioctl_all(VT, VT_RELDISP, VT_ACKACQ);
}

/* ---- keys ---- */

static bool is_down(const unsigned char *down, unsigned code)
{
    return (down[code / 8] >> code % 8 & 1) != 0;
}

/* Adds the keys that are down on a keyboard. Opens it anew: a query through the descriptor shared with the stopped
 * process would remove events from its queue. */
static void add_down(int fd, unsigned char down[KEY_CNT / 8])
{
    unsigned char here[KEY_CNT / 8] = {0};
    char path[32];

    (void)snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    int own = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (own >= 0 && ioctl(own, EVIOCGKEY(sizeof here), here) >= 0)
        for (unsigned i = 0; i < sizeof here; i++)
            down[i] |= here[i];
    if (own >= 0)
        (void)close(own);
}

void stand_in_look(void)
{
    unsigned char down[KEY_CNT / 8] = {0};
    struct epoll_event event;

    while (epoll_wait(keys, &event, 1, 0) > 0)
        ;
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == KEYBOARD && kept[i].fd >= 0)
            add_down(kept[i].fd, down);
    if (!(is_down(down, KEY_LEFTCTRL) || is_down(down, KEY_RIGHTCTRL)) || !is_down(down, KEY_LEFTALT))
        return;
    for (unsigned n = 1; n <= 12; n++)
        if (is_down(down, n <= 10 ? KEY_F1 + n - 1 : KEY_F11 + n - 11))
            (void)ioctl_all(VT, VT_ACTIVATE, (long)n);
}

int stand_in_keys(void)
{
    return keys;
}

/* Watches the keyboards, edge-triggered, since their events stay unread until the process continues. */
static void watch_keys(void)
{
    struct epoll_event event = {.events = EPOLLIN | EPOLLET};

    keys = epoll_create1(EPOLL_CLOEXEC);
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == KEYBOARD && kept[i].fd >= 0)
            (void)epoll_ctl(keys, EPOLL_CTL_ADD, kept[i].fd, &event);
}

/* ---- the process ---- */

/* Begins to answer; calls stand_in_leave, as the kernel may have requested the console just before the stop. */
void stand_in_begin(void)
{
    stand_in_end();
    own_consoles(VT_MARK_ANSWERS);
    stand_in_leave();
    watch_keys();
}

void stand_in_end(void)
{
    if (keys >= 0)
        (void)close(keys);
    keys = -1;
}
