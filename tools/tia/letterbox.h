/* letterbox.h - a display (tia/port.h) around another one: the picture smaller than the screen and
 * centred on black, turned, and its checksum taken on the way.
 *
 * Without a checksum the picture is drawn straight into the other display's memory.
 */
#ifndef TOOLS_TIA_STAGE_H
#define TOOLS_TIA_STAGE_H

#include <tia/port.h>

#include "rotate.h"

struct letterbox {
    /* What its maker fills in; all else zero. */
    const struct tia_display *screen;
    void *screen_ctx;
    const char *name;       /* the screen's, for messages */
    uint16_t width, height; /* of the picture; 0: as large as the screen */
    unsigned degrees;       /* clockwise */
    bool checksum;
    char *why; /* [PORT_WHY]: as in port/ports.h */

    /* Its own. */
    bool opened;          /* the screen could be opened, whatever became of the rest */
    struct tia_mode mode; /* the screen's */
    struct rotation rotation;
    struct tia_tile place; /* of the turned picture on the screen */
    tia_rgb565 *frame;     /* with a checksum: the turned picture */
    uint32_t crc;          /* of the frame that was presented last: the turned picture */
};

extern const struct tia_display letterbox_display; /* its context is a struct letterbox */

#endif
