#include "vt.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <linux/major.h>
#include <signal.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/sysmacros.h>
#include <time.h>
#include <unistd.h>

#include "guardian.h"
#include "node.h"
#include "vt_mark.h"

#define OPEN_FLAGS (O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)

/* Returns the controlling terminal's number, or 0 when it is not a VT (serial lines share the major number). */
static unsigned controlling(int fd)
{
    unsigned device = 0;

    if (fd < 0 || ioctl(fd, TIOCGDEV, &device) != 0)
        return 0;
    return major(device) == TTY_MAJOR && minor(device) <= MAX_NR_CONSOLES ? minor(device) : 0;
}

static unsigned in_front(int fd)
{
    struct vt_stat state;

    return ioctl(fd, VT_GETSTATE, &state) == 0 ? state.v_active : 0;
}

static void found(struct vt *vt, int fd, unsigned number, const char *which)
{
    vt->fd = fd;
    vt->number = number;
    (void)snprintf(vt->path, sizeof vt->path, "/dev/tty%u", number & 63u);
    (void)snprintf(vt->name, sizeof vt->name, "tty%u, %s", number, which);
}

static void none(struct vt *vt, const char *path)
{
    const char *fix = errno == EACCES || errno == EPERM ? " (run it on that console or as root)" : "";
    char reason[PORT_WHY];

    (void)snprintf(vt->name, sizeof vt->name, "none: %s: %.100s%s", path, node_error(errno, reason), fix);
    vt_close(vt);
}

void vt_find(struct vt *vt)
{
    unsigned number;
    int fd = open("/dev/tty", OPEN_FLAGS);

    *vt = (struct vt){.fd = -1};
    number = controlling(fd);
    if (number != 0) {
        found(vt, fd, number, "the controlling terminal");
        return;
    }
    if (fd >= 0)
        (void)close(fd);
    fd = open("/dev/tty0", OPEN_FLAGS);
    if (fd < 0) {
        none(vt, "/dev/tty0");
        return;
    }
    /* /dev/tty0 is always the console in front, so the present one is opened by its number */
    number = in_front(fd);
    (void)close(fd);
    found(vt, -1, number, "the console in front");
    vt->fd = open(vt->path, OPEN_FLAGS);
    if (vt->fd < 0)
        none(vt, vt->path);
}

void vt_close(struct vt *vt)
{
    if (vt->fd >= 0)
        (void)close(vt->fd);
    vt->fd = -1;
}

/* Switches to the console and waits, 3 s at most: the program on the console in front may refuse to release it. Returns
 * 0, or -1. */
static int bring_in_front(struct vt *vt, int enter)
{
    const struct timespec limit = {.tv_sec = 3};
    sigset_t set;

    if (vt->back_to == 0)
        return 0;
    (void)sigemptyset(&set);
    (void)sigaddset(&set, enter);
    if (ioctl(vt->fd, VT_ACTIVATE, (long)vt->number) != 0 || sigtimedwait(&set, NULL, &limit) < 0)
        return -1;
    vt_entered(vt);
    return 0;
}

static int own(const struct vt *vt, int leave, int enter)
{
    struct vt_mode mode = {.mode = VT_PROCESS, .waitv = VT_MARK_TAKEN, .relsig = (short)leave, .acqsig = (short)enter};

    return ioctl(vt->fd, VT_SETMODE, &mode);
}

static int take_modes(struct vt *vt, int leave, int enter)
{
    if (!vt_in_front(vt))
        vt->back_to = in_front(vt->fd);
    (void)guardian_keep_vt(vt->fd, vt->path, vt->back_to);
    if (own(vt, leave, enter) != 0) {
        guardian_forget_vt(vt->path);
        return -1;
    }
    return 0;
}

static bool is_marked(char mark)
{
    return mark == VT_MARK_TAKEN || mark == VT_MARK_ANSWERS || mark == VT_MARK_LEFT;
}

static int read_modes(struct vt *vt)
{
    return ioctl(vt->fd, KDGETMODE, &vt->kd_mode) != 0 || ioctl(vt->fd, VT_GETMODE, &vt->mode) != 0 ? -1 : 0;
}

/* Locks the node: this process and its guardian hold the lock while they have the console. A mark without a lock was
 * left by a process that was killed together with its guardian; the console is then restored here. Returns 0, or -1 on
 * failure. */
static int lock(struct vt *vt)
{
    struct vt_mode plain = {.mode = VT_AUTO};

    if (flock(vt->fd, LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK ? -1 : 0;
    if (vt->mode.mode == VT_AUTO || !is_marked(vt->mode.waitv))
        return 0;
    (void)ioctl(vt->fd, KDSETMODE, (long)KD_TEXT);
    (void)ioctl(vt->fd, VT_SETMODE, &plain);
    return read_modes(vt);
}

/* Sets graphics mode; without `graphics`, returns to the former mode at once. A display that the kernel's text does not
 * cover leaves the console in text mode, which need not be restored. The change of modes makes the kernel draw text
 * again where a process died with its guardian. */
static int set_graphics(const struct vt *vt, bool graphics)
{
    if (ioctl(vt->fd, KDSETMODE, (long)KD_GRAPHICS) != 0)
        return -1;
    return graphics ? 0 : ioctl(vt->fd, KDSETMODE, (long)vt->kd_mode);
}

static int in_use(const struct vt *vt, char why[PORT_WHY])
{
    (void)snprintf(why, PORT_WHY,
                   "%s: another program draws there (end it, or start this on another console; if it is gone, "
                   "switch consoles once)",
                   vt->path);
    return TIA_ERR_DEVICE;
}

int vt_take(struct vt *vt, bool graphics, int leave, int enter, char why[PORT_WHY])
{
    if (vt->fd < 0)
        return TIA_OK;
    if (read_modes(vt) != 0) {
        none(vt, vt->path);
        return TIA_OK;
    }
    if (lock(vt) != 0 || vt->mode.mode != VT_AUTO)
        return in_use(vt, why);
    if (take_modes(vt, leave, enter) != 0) {
        none(vt, vt->path);
        return TIA_OK;
    }
    if (bring_in_front(vt, enter) == 0 && set_graphics(vt, graphics) == 0)
        return TIA_OK;
    (void)snprintf(why, PORT_WHY, "%s: cannot come in front of tty%u (switch to it first)", vt->path, vt->back_to);
    vt_give(vt);
    return TIA_ERR_DEVICE;
}

bool vt_resume(const struct vt *vt, int leave, int enter, bool *left)
{
    struct vt_mode now;

    if (vt->fd < 0 || ioctl(vt->fd, VT_GETMODE, &now) != 0 || now.waitv == VT_MARK_TAKEN)
        return false;
    *left = now.waitv == VT_MARK_LEFT;
    (void)own(vt, leave, enter);
    return true;
}

void vt_give(struct vt *vt)
{
    struct vt_mode mode = vt->mode;

    if (vt->fd < 0)
        return;
    /* The kernel draws the text when the mode changes. */
    (void)ioctl(vt->fd, KDSETMODE, (long)KD_GRAPHICS);
    (void)ioctl(vt->fd, KDSETMODE, (long)vt->kd_mode);
    (void)vt_let_go(vt); /* VT_SETMODE would drop a switch that waits for an answer */
    (void)ioctl(vt->fd, VT_SETMODE, &mode);
    if (vt->back_to != 0 && vt_in_front(vt))
        (void)ioctl(vt->fd, VT_ACTIVATE, (long)vt->back_to);
    guardian_forget_vt(vt->path);
}

bool vt_let_go(const struct vt *vt)
{
    return ioctl(vt->fd, VT_RELDISP, 1L) == 0;
}
void vt_entered(const struct vt *vt)
{
    (void)ioctl(vt->fd, VT_RELDISP, (long)VT_ACKACQ);
}
bool vt_in_front(const struct vt *vt)
{
    return in_front(vt->fd) == vt->number;
}
