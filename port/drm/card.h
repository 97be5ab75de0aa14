/* card.h - a card (/dev/dri/cardN), its connectors and encoders, and its buffers. */
#ifndef PORT_DRM_CARD_H
#define PORT_DRM_CARD_H

#include "pick.h"
#include "pixels/expand.h"

#define CARD "/dev/dri/card"
#define CARDS 64 /* the kernel's limit: minors 0..63 */

struct card {
    int fd; /* -1: not open */
    char path[64];
    struct drm_parts parts;
};

/* Opens the card and reads its resources. Changes nothing, except that the kernel makes this process the card's master
 * if the card has none. */
int card_open(struct card *card, const char *path, char why[PORT_WHY]);
void card_close(struct card *card);
/* Becomes the card's master, which may set modes. Returns TIA_OK, or TIA_ERR_DEVICE with the present master in
 * `why`. */
int card_become_master(const struct card *card, char why[PORT_WHY]);
/* Writes "PATH: WHAT: REASON" to `why`, where REASON is the text of errno. Returns TIA_ERR_DEVICE. */
int card_failed(const struct card *card, const char *what, char why[PORT_WHY]);

/* A pixel format that tia draws. */
struct card_format {
    uint32_t fourcc;
    const struct pixel_format *pixel;
};

/* Gives format n = 0, 1, ... to try on a CRTC, best first; false after the last. Without `listed`, RGB565 and XRGB8888
 * are always among them, since some drivers list too few formats. All other formats are those that the primary plane
 * lists. */
bool card_format(const struct card *card, uint32_t crtc, int n, bool listed, struct card_format *format);
/* Gives format n as card_format does, for a plane that lists `count` formats. */
bool card_format_of(const uint32_t *plane, size_t count, int n, bool listed, struct card_format *format);

/* A dumb buffer: the screen can show it, and the CPU writes to it. */
struct card_buffer {
    uint32_t handle, fb, pitch;
    uint64_t size;
    uint8_t *map; /* NULL: no buffer */
};

/* Creates a buffer. Returns 0, or -1 with errno and the failed step in *what, after freeing all that was created. */
int card_buffer_create(const struct card *card, struct card_buffer *buffer, unsigned width, unsigned height,
                       const struct card_format *format, const char **what);
void card_buffer_destroy(const struct card *card, struct card_buffer *buffer);

#endif
