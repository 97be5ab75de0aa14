/* probe.c - a test's queries and commands to the kernel of a guest, beside the program under test.
 *
 *   probe vt N              prints the state of virtual terminal N, and which one is active
 *   probe text N            sets text mode for tty N, as systemd does before a getty begins
 *   probe push N TEXT       enters TEXT and a newline as if typed on tty N, without a keyboard
 *   probe fb DEVICE         prints geometry and pixel format of a framebuffer
 *   probe master DEVICE     is DRM master until it is killed
 *   probe grabbed           lists the event devices that any program has grabbed
 *   probe as UID COMMAND    runs COMMAND as that user, with no signal ignored
 *   probe keyboard NAME     makes a virtual keyboard fed by lines "CODE VALUE" on standard input */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/uinput.h>
#include <linux/vt.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define DRM_SET_MASTER _IO('d', 0x1e) /* DRM_IOCTL_SET_MASTER, without the need for libdrm's headers */

static int fail(const char *what)
{
    printf("%s: %s\n", what, strerror(errno));
    return 1;
}

static int open_tty(const char *number)
{
    char path[32];
    (void)snprintf(path, sizeof path, "/dev/tty%s", number);
    return open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
}

static int vt(char **argv)
{
    int tty = open_tty(argv[0]), graphics = -1, keyboard = -1;
    struct vt_stat state;
    struct vt_mode mode;
    if (tty < 0 || ioctl(tty, VT_GETSTATE, &state) || ioctl(tty, VT_GETMODE, &mode) ||
        ioctl(tty, KDGETMODE, &graphics) || ioctl(tty, KDGKBMODE, &keyboard))
        return fail(argv[0]);
    printf("active=%d graphics=%d process=%d keyboard=%d\n", state.v_active, graphics == KD_GRAPHICS,
           mode.mode == VT_PROCESS, keyboard);
    return 0;
}

static int text(char **argv)
{
    int tty = open_tty(argv[0]);
    return tty < 0 || ioctl(tty, KDSETMODE, (long)KD_TEXT) ? fail(argv[0]) : 0;
}

static int push(char **argv)
{
    int tty = open_tty(argv[0]);
    if (tty < 0)
        return fail(argv[0]);
    for (const char *c = argv[1]; *c; c++)
        if (ioctl(tty, TIOCSTI, c))
            return fail("TIOCSTI");
    return ioctl(tty, TIOCSTI, "\n") ? fail("TIOCSTI") : 0;
}

static int fb(char **argv)
{
    struct fb_var_screeninfo v;
    struct fb_fix_screeninfo f;
    int fd = open(argv[0], O_RDWR | O_CLOEXEC);
    if (fd < 0 || ioctl(fd, FBIOGET_VSCREENINFO, &v) || ioctl(fd, FBIOGET_FSCREENINFO, &f))
        return fail(argv[0]);
    printf("id=%.16s width=%u height=%u rows=%u bpp=%u pitch=%u red=%u green=%u blue=%u yoffset=%u\n", f.id, v.xres,
           v.yres, v.yres_virtual, v.bits_per_pixel, f.line_length, v.red.offset, v.green.offset, v.blue.offset,
           v.yoffset);
    return 0;
}

static int master(char **argv)
{
    int fd = open(argv[0], O_RDWR | O_CLOEXEC);
    if (fd < 0 || ioctl(fd, DRM_SET_MASTER, 0))
        return fail(argv[0]);
    puts("master");
    for (;;)
        pause();
}

static int grabbed(char **argv)
{
    (void)argv;
    for (int i = 0; i < 32; i++) {
        char path[32];
        (void)snprintf(path, sizeof path, "/dev/input/event%d", i);
        int fd = open(path, O_RDONLY | O_CLOEXEC);
        if (fd < 0)
            continue;
        if (ioctl(fd, EVIOCGRAB, 1) && errno == EBUSY)
            puts(path);
        (void)close(fd);
    }
    return 0;
}

static int emit(int fd, int type, int code, int value)
{
    struct input_event e = {.type = (uint16_t)type, .code = (uint16_t)code, .value = value};
    return write(fd, &e, sizeof e) == sizeof e ? 0 : fail("uinput");
}

static int keyboard(char **argv)
{
    struct uinput_setup setup = {.id = {.bustype = BUS_USB, .vendor = 1, .product = 1, .version = 1}};
    int fd = open("/dev/uinput", O_WRONLY | O_CLOEXEC), code, value;
    if (fd < 0)
        return fail("/dev/uinput");
    (void)ioctl(fd, UI_SET_EVBIT, EV_KEY);
    for (int key = 1; key < KEY_MICMUTE; key++)
        (void)ioctl(fd, UI_SET_KEYBIT, key);
    (void)snprintf(setup.name, sizeof setup.name, "%s", argv[0]);
    if (ioctl(fd, UI_DEV_SETUP, &setup) || ioctl(fd, UI_DEV_CREATE))
        return fail("UI_DEV_CREATE");
    while (scanf("%d %d", &code, &value) == 2)
        if (emit(fd, EV_KEY, code, value) || emit(fd, EV_SYN, SYN_REPORT, 0))
            return 1;
    return 0;
}

static int as(char **argv)
{
    unsigned user = (unsigned)atoi(argv[0]);
    (void)signal(SIGINT, SIG_DFL);
    (void)signal(SIGQUIT, SIG_DFL);
    if (setgid(user) || setuid(user))
        return fail(argv[0]);
    (void)execvp(argv[1], argv + 1);
    return fail(argv[1]);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int arguments; /* least number of arguments */
        int (*run)(char **argv);
    } commands[] = {{"vt", 1, vt},         {"text", 1, text},       {"push", 2, push},         {"fb", 1, fb},
                    {"master", 1, master}, {"grabbed", 0, grabbed}, {"keyboard", 1, keyboard}, {"as", 2, as}};
    (void)setvbuf(stdout, NULL, _IOLBF, 0);
    for (size_t i = 0; argc > 1 && i < sizeof commands / sizeof *commands; i++)
        if (!strcmp(argv[1], commands[i].name) && argc >= commands[i].arguments + 2)
            return commands[i].run(argv + 2);
    return 2;
}
