/* A framebuffer of any geometry: a file is its memory and the functions below are its driver. Real drivers are tested
 * in guests (tests/vm), but none there has rows with padding. */
#include "check.h"
#include "fbdev/fbdev.h"
#include "without_vt.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <stdarg.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { WIDTH = 20, HEIGHT = 10, MOST = 16384 };

static struct {
    struct fb_var_screeninfo var, before;
    struct fb_fix_screeninfo fix;
    bool resets; /* a mode change resets the position to (0, 0), as in some drivers */
    int fd;
    uint8_t *memory; /* the test's own mapping */
    uint8_t old[MOST];
    char path[32];
} fb;

/* ---- the driver ---- */

static bool shows_memory(const struct fb_var_screeninfo *v)
{
    return v->xoffset + v->xres <= v->xres_virtual && v->yoffset + v->yres <= v->yres_virtual &&
           (size_t)v->yres_virtual * fb.fix.line_length <= fb.fix.smem_len;
}

static int set(struct fb_var_screeninfo *to, bool position_only)
{
    struct fb_var_screeninfo next = position_only ? fb.var : *to;

    next.xoffset = position_only || !fb.resets ? to->xoffset : 0;
    next.yoffset = position_only || !fb.resets ? to->yoffset : 0;
    if (!shows_memory(&next) || (position_only && fb.fix.ypanstep == 0)) {
        errno = EINVAL;
        return -1;
    }
    fb.var = next;
    return 0;
}

/* Replaces the C library's ioctl. */
int ioctl(int fd, unsigned long request, ...)
{
    va_list values;
    void *value;

    va_start(values, request);
    value = va_arg(values, void *);
    va_end(values);
    switch (request) {
    case FBIOGET_VSCREENINFO:
        *(struct fb_var_screeninfo *)value = fb.var;
        return 0;
    case FBIOGET_FSCREENINFO:
        *(struct fb_fix_screeninfo *)value = fb.fix;
        return 0;
    case FBIOPUT_VSCREENINFO:
        return set(value, false);
    case FBIOPAN_DISPLAY:
        return set(value, true);
    case FBIOBLANK:
        return 0;
    default:
        return (int)syscall(SYS_ioctl, fd, request, value);
    }
}

/* ---- a device, and a picture on it ---- */

struct geometry {
    unsigned bits, row, rows, x, y; /* bits of a pixel, bytes of a row, rows of memory; position */
    bool pans, resets;
};

static void plug(const struct geometry *g)
{
    const struct fb_bitfield r16 = {11, 5, 0}, g16 = {5, 6, 0}, b16 = {0, 5, 0};
    const struct fb_bitfield r32 = {16, 8, 0}, g32 = {8, 8, 0}, b32 = {0, 8, 0};
    bool deep = g->bits == 32;

    fb.fix = (struct fb_fix_screeninfo){.smem_len = g->row * g->rows,
                                        .type = FB_TYPE_PACKED_PIXELS,
                                        .visual = FB_VISUAL_TRUECOLOR,
                                        .line_length = g->row,
                                        .ypanstep = g->pans};
    fb.var = (struct fb_var_screeninfo){.xres = WIDTH,
                                        .yres = HEIGHT,
                                        .xres_virtual = g->row / (g->bits / 8),
                                        .yres_virtual = g->y + HEIGHT,
                                        .xoffset = g->x,
                                        .yoffset = g->y,
                                        .bits_per_pixel = g->bits,
                                        .red = deep ? r32 : r16,
                                        .green = deep ? g32 : g16,
                                        .blue = deep ? b32 : b16};
    fb.before = fb.var;
    fb.resets = g->resets;
    (void)snprintf(fb.path, sizeof fb.path, "/tmp/tia-fb.XXXXXX");
    fb.fd = mkstemp(fb.path);
    CHECK(fb.fd >= 0 && ftruncate(fb.fd, (off_t)fb.fix.smem_len) == 0);
    fb.memory = mmap(NULL, fb.fix.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, fb.fd, 0);
    for (size_t i = 0; i < fb.fix.smem_len; i++)
        fb.old[i] = fb.memory[i] = (uint8_t)(i * 37 + i / 256 + 11);
}

static void unplug(void)
{
    (void)munmap(fb.memory, fb.fix.smem_len);
    (void)close(fb.fd);
    (void)unlink(fb.path);
}

static tia_rgb565 pixel(unsigned frame, unsigned x, unsigned y)
{
    return (tia_rgb565)(frame * 0x1357u + x * 2111u + y * 31u * 65u);
}

static void draw(void *ctx, unsigned frame)
{
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    struct tia_surface s;

    CHECK_EQ(port_fbdev_display.acquire(ctx, all, &s), TIA_OK);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++)
            *(tia_rgb565 *)(void *)((uint8_t *)s.pixels + (ptrdiff_t)y * s.pitch + (ptrdiff_t)x * s.step) =
                pixel(frame, x, y);
    CHECK_EQ(port_fbdev_display.submit(ctx, all), TIA_OK);
    CHECK_EQ(port_fbdev_display.present(ctx), TIA_OK);
}

/* Returns a pixel's bytes, little endian, as on this machine's framebuffers. */
static uint32_t shown(unsigned bits, tia_rgb565 p)
{
    uint32_t r = p >> 11, g = p >> 5 & 63, b = p & 31;

    return bits == 16 ? p : (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
}

/* Checks that the screen shows this frame and that all other memory, except the other page, is unchanged. */
static void check_picture(const struct geometry *g, unsigned frame)
{
    unsigned bytes = g->bits / 8, wrong = 0, spoilt = 0;

    for (size_t i = 0; i < fb.fix.smem_len; i++) {
        size_t row = i / g->row - fb.var.yoffset, column = i % g->row / bytes - fb.var.xoffset;
        if (row < HEIGHT && column < WIDTH) {
            uint32_t want = shown(g->bits, pixel(frame, (unsigned)column, (unsigned)row));
            wrong += fb.memory[i] != (uint8_t)(want >> 8 * (i % g->row % bytes));
        } else {
            spoilt += !g->pans && fb.memory[i] != fb.old[i];
        }
    }
    CHECK_MSG(wrong == 0 && spoilt == 0, "%u bytes of the picture are wrong, %u beside it", wrong, spoilt);
}

/* Checks the mode, the position and the picture. */
static void check_put_back(const struct geometry *g)
{
    size_t start = (size_t)g->y * g->row, size = (size_t)HEIGHT * g->row;

    CHECK(fb.var.xoffset == g->x && fb.var.yoffset == g->y);
    CHECK_EQ(fb.var.yres_virtual, fb.before.yres_virtual);
    CHECK(memcmp(fb.memory + start, fb.old + start, size) == 0);
    if (!g->pans)
        CHECK(memcmp(fb.memory, fb.old, fb.fix.smem_len) == 0);
}

static void three_frames(const struct geometry *g)
{
    char why[PORT_WHY] = "";
    struct port_wish wish = {.device = fb.path, .why = why};
    struct tia_mode mode;
    unsigned pages = 0;

    if (!no_vt() || *(const uint8_t *)&(const uint16_t){1} != 1)
        return;
    plug(g);
    void *ctx = port_fbdev_create(&wish);
    CHECK_MSG(!port_fbdev_display.open(ctx, &mode), "%s", why);
    for (unsigned frame = 1; frame <= 3; frame++) {
        draw(ctx, frame);
        check_picture(g, frame);
        pages |= 1u << fb.var.yoffset / HEIGHT;
    }
    if (g->pans)
        CHECK_EQ(pages, 3);
    port_fbdev_display.close(ctx);
    port_fbdev_destroy(ctx);
    check_put_back(g);
    unplug();
}

TEST(rows_with_padding)
{
    three_frames(&(struct geometry){.bits = 16, .row = 64, .rows = HEIGHT});
    three_frames(&(struct geometry){.bits = 32, .row = 96, .rows = HEIGHT});
}

TEST(panned_in_x_and_y)
{
    three_frames(&(struct geometry){.bits = 16, .row = 64, .rows = 17, .x = 5, .y = 7});
    three_frames(&(struct geometry){.bits = 32, .row = 112, .rows = 13, .x = 8, .y = 3});
}

TEST(two_pages_from_anywhere)
{
    three_frames(&(struct geometry){.bits = 16, .row = 64, .rows = 2 * HEIGHT, .pans = true});
    three_frames(&(struct geometry){.bits = 16, .row = 64, .rows = 2 * HEIGHT, .x = 3, .y = 4, .pans = true});
    three_frames(&(struct geometry){.bits = 32, .row = 80, .rows = 3 * HEIGHT, .y = 2 * HEIGHT, .pans = true});
    three_frames(
        &(struct geometry){.bits = 16, .row = 64, .rows = 2 * HEIGHT, .x = 3, .y = 4, .pans = true, .resets = true});
}

static int run_all(void)
{
    RUN(rows_with_padding);
    RUN(panned_in_x_and_y);
    RUN(two_pages_from_anywhere);
    return check_status();
}

int main(void)
{
    return in_process_without_vt(run_all);
}
