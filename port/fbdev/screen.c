#include "screen.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "console/guardian.h"
#include "console/node.h"

static int failed(const struct fb_screen *s, const char *what, char why[PORT_WHY])
{
    char reason[PORT_WHY];

    (void)snprintf(why, PORT_WHY, "%s: %s: %.100s", s->path, what, node_error(errno, reason));
    return TIA_ERR_DEVICE;
}

static int read_mode(struct fb_screen *s)
{
    return ioctl(s->fd, FBIOGET_VSCREENINFO, &s->var) != 0 || ioctl(s->fd, FBIOGET_FSCREENINFO, &s->fix) != 0 ? -1 : 0;
}

static int read_format(struct fb_screen *s, char why[PORT_WHY])
{
    char reason[PORT_WHY];
    int status;

    if (read_mode(s) != 0)
        return failed(s, "not a framebuffer", why);
    s->old = s->var;
    status = fb_format(&s->var, &s->fix, &s->format, reason);
    if (status)
        (void)snprintf(why, PORT_WHY, "%s: %.180s", s->path, reason);
    return status;
}

/* Locks the device against a second tia: the kernel lets any number of programs draw on one device. */
static int lock(struct fb_screen *s, char why[PORT_WHY])
{
    char holder[NODE_HOLDER];

    if (flock(s->fd, LOCK_EX | LOCK_NB) == 0)
        return TIA_OK;
    (void)snprintf(why, PORT_WHY, "%s: in use by %s (end it, or choose another display)", s->path,
                   node_holder(s->path, holder));
    return TIA_ERR_DEVICE;
}

int fb_probe(struct fb_screen *screen, const char *path, char why[PORT_WHY])
{
    int status;

    *screen = (struct fb_screen){.fd = node_open(path, O_RDWR, why), .pages = 1, .vsync = true};
    if (screen->fd < 0)
        return TIA_ERR_DEVICE;
    (void)snprintf(screen->path, sizeof screen->path, "%s", path);
    status = read_format(screen, why);
    if (!status)
        status = lock(screen, why);
    if (status)
        fb_close(screen, false);
    return status;
}

static int put_mode(struct fb_screen *s, const struct fb_var_screeninfo *var)
{
    struct fb_var_screeninfo v = *var;

    v.activate = FB_ACTIVATE_NOW;
    return ioctl(s->fd, FBIOPUT_VSCREENINFO, &v);
}

static bool same_picture(const struct fb_var_screeninfo *a, const struct fb_var_screeninfo *b)
{
    return a->xres == b->xres && a->yres == b->yres && a->bits_per_pixel == b->bits_per_pixel &&
           memcmp(&a->red, &b->red, sizeof a->red) == 0 && memcmp(&a->blue, &b->blue, sizeof a->blue) == 0;
}

/* Requests two pages, if the device can pan. The driver may round the request, so the result is checked. */
static void ask_for_pages(struct fb_screen *s)
{
    struct fb_var_screeninfo two = s->var;

    if (!fb_can_pan(&s->var, &s->fix))
        return;
    two.yres_virtual = 2 * two.yres;
    two.xoffset = two.yoffset = 0;
    if (s->var.yres_virtual < two.yres_virtual && put_mode(s, &two) != 0)
        return;
    if (read_mode(s) == 0 && same_picture(&s->var, &s->old) && s->var.yres_virtual >= 2 * s->var.yres &&
        fb_can_pan(&s->var, &s->fix)) {
        s->pages = 2;
        if (!fb_show(s, 0))
            return;
    }
    s->pages = 1;
    (void)put_mode(s, &s->old);
    (void)read_mode(s);
}

static int map(struct fb_screen *s, char why[PORT_WHY])
{
    /* the kernel maps whole pages of memory; the first pixel may be inside the first page */
    size_t skip = s->fix.smem_start & (size_t)(sysconf(_SC_PAGESIZE) - 1);

    s->map_size = s->fix.smem_len + skip;
    s->map = mmap(NULL, s->map_size, PROT_READ | PROT_WRITE, MAP_SHARED, s->fd, 0);
    if (s->map == MAP_FAILED) {
        s->map = NULL;
        return failed(s, "its memory cannot be mapped", why);
    }
    s->memory = s->map + skip;
    return TIA_OK;
}

/* Reads or sets the colour map, by `request`. With direct colour, each channel is looked up in this map, of which a
 * text console sets only 16 entries. */
static void palette(struct fb_screen *s, uint16_t *colours, unsigned long request)
{
    struct fb_cmap map = {.red = colours, .green = colours + 256, .blue = colours + 512};
    const uint8_t *l[] = {&s->format.red.length, &s->format.green.length, &s->format.blue.length};

    for (int i = 0; i < 3; i++)
        if (map.len < 1u << *l[i])
            map.len = 1u << *l[i];
    if (map.len <= 256)
        (void)ioctl(s->fd, request, &map);
}

static int take_palette(struct fb_screen *s)
{
    uint16_t straight[3 * 256];
    const uint8_t length[] = {s->format.red.length, s->format.green.length, s->format.blue.length};

    if (s->fix.visual != FB_VISUAL_DIRECTCOLOR || length[0] > 8 || length[1] > 8 || length[2] > 8)
        return 0;
    s->palette = calloc(3 * 256, sizeof *s->palette);
    if (!s->palette)
        return -1;
    palette(s, s->palette, FBIOGETCMAP);
    memset(straight, 0xff, sizeof straight);
    for (int i = 0; i < 3; i++)
        fb_ramp(straight + i * 256, length[i]);
    palette(s, straight, FBIOPUTCMAP);
    return 0;
}

static size_t visible_size(const struct fb_screen *s)
{
    return (size_t)s->fix.line_length * s->old.yres;
}
static size_t visible_start(const struct fb_screen *s)
{
    return (size_t)s->fix.line_length * s->old.yoffset;
}

int fb_take(struct fb_screen *screen, char why[PORT_WHY])
{
    if (map(screen, why))
        return TIA_ERR_DEVICE;
    screen->saved = malloc(visible_size(screen));
    if (!screen->saved)
        return failed(screen, "saving the screen", why);
    memcpy(screen->saved, screen->memory + visible_start(screen), visible_size(screen));
    (void)guardian_keep_fb(screen->path, &screen->old);
    (void)ioctl(screen->fd, FBIOBLANK, (long)FB_BLANK_UNBLANK);
    if (take_palette(screen) != 0)
        return failed(screen, "saving the colour map", why);
    ask_for_pages(screen);
    return TIA_OK;
}

int fb_show(struct fb_screen *screen, unsigned page)
{
    struct fb_var_screeninfo to = screen->var;

    if (screen->pages == 1)
        return TIA_OK;
    to.xoffset = 0;
    to.yoffset = page * to.yres;
    to.activate = FB_ACTIVATE_VBL;
    if (ioctl(screen->fd, FBIOPAN_DISPLAY, &to) != 0)
        return TIA_ERR_DEVICE;
    screen->var.xoffset = to.xoffset;
    screen->var.yoffset = to.yoffset;
    return TIA_OK;
}

void fb_show_again(struct fb_screen *screen)
{
    (void)put_mode(screen, &screen->var);
    if (screen->pages == 2)
        (void)fb_show(screen, screen->var.yoffset / screen->var.yres);
}

uint8_t *fb_page(const struct fb_screen *screen, unsigned page)
{
    size_t row = screen->pages == 1 ? screen->var.yoffset : (size_t)page * screen->var.yres;

    return screen->memory + row * screen->fix.line_length + (size_t)screen->var.xoffset * pixel_bytes(&screen->format);
}

void fb_wait(struct fb_screen *screen)
{
    uint32_t head = 0;

    if (screen->vsync && ioctl(screen->fd, FBIO_WAITFORVSYNC, &head) != 0)
        screen->vsync = false;
}

/* Restores the screen; if it is not `visible`, another console has the screen, and the panning position and the picture
 * stay. */
static void put_back(struct fb_screen *s, bool visible)
{
    struct fb_var_screeninfo old = s->old, now;

    if (!visible && ioctl(s->fd, FBIOGET_VSCREENINFO, &now) == 0) {
        old.xoffset = now.xoffset;
        old.yoffset = now.yoffset < old.yres_virtual - old.yres ? now.yoffset : old.yres_virtual - old.yres;
    }
    if (s->pages == 2) {
        (void)put_mode(s, &old);
        (void)ioctl(s->fd, FBIOPAN_DISPLAY, &old);
    }
    if (visible && s->memory)
        memcpy(s->memory + visible_start(s), s->saved, visible_size(s));
    if (s->palette)
        palette(s, s->palette, FBIOPUTCMAP);
    guardian_forget_fb(s->path);
}

void fb_close(struct fb_screen *screen, bool visible)
{
    if (screen->fd < 0)
        return;
    if (screen->saved)
        put_back(screen, visible);
    if (screen->map)
        (void)munmap(screen->map, screen->map_size);
    free(screen->saved);
    free(screen->palette);
    (void)close(screen->fd);
    *screen = (struct fb_screen){.fd = -1};
}
