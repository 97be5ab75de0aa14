/* letterbox.h - a display (tia/port.h) that draws on another one: it centres a smaller picture on black, rotates
 * it, puts a label or, if the other display has it, text on it, and computes its checksum, without the label.
 *
 * If neither its checksum nor its pixels are needed later, the picture is drawn straight into the other display's
 * memory.
 */
#ifndef TOOLS_TIA_LETTERBOX_H
#define TOOLS_TIA_LETTERBOX_H

#include "device.h"
#include "rotate.h"

struct letterbox {
    /* Set by the caller; all else zero. */
    const struct tia_display *screen;
    void *screen_ctx;
    const char *name;       /* name of the screen, for messages */
    uint16_t width, height; /* size of the picture; 0: as large as the screen */
    unsigned degrees;       /* rotation of the picture, clockwise */
    bool checksum;
    bool keeps; /* the picture is needed after it is shown */
    /* NULL, or called after each tile, and with 0 before a picture is shown. */
    void (*drawn)(void *ctx, uint64_t pixels);
    void *drawn_ctx;
    char *why; /* receives the reason for a failure, [PORT_WHY], see port/device.h */

    /* NULL if the screen has pixels alone, else the screen's function that shows text, see port/device.h. */
    void (*set_text)(void *ctx, struct port_text *text);
    struct port_text *text; /* the text for set_text; may change from frame to frame */
    char label[1200];       /* see label.h; empty: no label. May change from frame to frame; not used with set_text */

    /* Private, but readable. */
    bool opened;          /* the screen was opened, even if the letterbox was not */
    struct tia_mode mode; /* the screen's mode */
    struct rotation rotation;
    struct tia_tile place; /* position of the rotated picture on the screen */
    tia_rgb565 *frame;     /* the rotated picture; only with a checksum, or if the picture is kept */
    bool shown;            /* a picture of this size was shown */
    uint32_t crc;          /* CRC of the frame presented last, rotated */
};

extern const struct tia_display letterbox_display; /* the context is a struct letterbox */

#endif
