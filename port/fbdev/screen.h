/* screen.h - one framebuffer device: its format, memory and pages. Private to fbdev. */
#ifndef PORT_FBDEV_SCREEN_H
#define PORT_FBDEV_SCREEN_H

#include <linux/fb.h>

#include "device.h"
#include "pixels/expand.h"

struct fb_screen {
    int fd; /* -1: not open */
    char path[64];
    struct fb_fix_screeninfo fix;
    struct fb_var_screeninfo var, old; /* present mode; the former mode */
    struct pixel_format format;
    uint8_t *map; /* all of the device's memory */
    size_t map_size;
    uint8_t *memory;   /* the first pixel */
    unsigned pages;    /* 1, or 2: one is shown while the other is written */
    bool vsync;        /* FBIO_WAITFORVSYNC works */
    uint16_t *palette; /* direct colour: the former colour map, 3 x 256 */
    uint8_t *saved;    /* contents of the screen before fb_take */
};

/* Gives the format that the device reports. Returns TIA_OK, or TIA_ERR_UNSUPPORTED with the reason: "640x480, 8 bits a
 * pixel: ...". */
int fb_format(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix, struct pixel_format *format,
              char reason[PORT_WHY]);
/* True if the device can pan and has memory for two pages, one above the other. */
bool fb_can_pan(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix);
/* Writes an identity colour map: 2^length entries from 0 to 65535. */
void fb_ramp(uint16_t *out, unsigned length);

/* Opens `path`, reads its mode and locks it against a second tia; changes nothing. */
int fb_probe(struct fb_screen *screen, const char *path, char why[PORT_WHY]);
/* Prepares the device after fb_probe: saves the screen, sets up a second page if possible, maps the memory. */
int fb_take(struct fb_screen *screen, char why[PORT_WHY]);
/* Shows page number `page`. */
int fb_show(struct fb_screen *screen, unsigned page);
/* Shows the last shown page again, after another console had the screen. */
void fb_show_again(struct fb_screen *screen);
/* Returns the first byte of a page. */
uint8_t *fb_page(const struct fb_screen *screen, unsigned page);
/* Waits for the next vertical sync, if the driver supports that: then the last shown page is on the screen. */
void fb_wait(struct fb_screen *screen);
/* Restores what fb_take changed, and the old picture if this console is `visible`; then closes the device. Safe at any
 * time. */
void fb_close(struct fb_screen *screen, bool visible);

#endif
