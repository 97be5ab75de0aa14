/* thumbnail_page.h - the memory that the process which draws a thumbnail shares with the one that saves it. */
#ifndef TOOLS_TIA_THUMBNAIL_PAGE_H
#define TOOLS_TIA_THUMBNAIL_PAGE_H

#include <stdatomic.h>
#include <stdint.h>

#include "device.h"

struct options;

/* Bounds of --thumbnail. The sizes of freedesktop.org's thumbnails are 128, 256, 512 and 1024. */
enum { THUMBNAIL_MIN = 16, THUMBNAIL_MAX = 1024 };

struct thumbnail_page {
    atomic_uint drawn; /* number of pictures drawn; picture n, from 0, is in rgb[n % 2] */
    atomic_bool ended;
    int status;         /* exit status, once ended */
    char why[PORT_WHY]; /* reason if `status` is not 0 */
    unsigned width, height;
    unsigned char rgb[2][3 * THUMBNAIL_MAX * THUMBNAIL_MAX];
};

/* Reads the scene and draws it, in a confined process that gets files by `socket`; pictures that cannot be finished by
 * end_us, the time of clock_now_us, are not begun. */
_Noreturn void thumbnail_draw(struct options *options, struct thumbnail_page *page, int socket, uint64_t end_us);

#endif
