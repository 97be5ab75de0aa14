/* card.h - a card (/dev/dri/cardN), what hangs on it, and its buffers. */
#ifndef PORT_DRM_CARD_H
#define PORT_DRM_CARD_H

#include "pick.h"
#include "pixels/expand.h"

#define CARD "/dev/dri/card"
#define CARDS 64 /* of the kernel: minors 0..63 */

struct card {
    int fd; /* -1: not open */
    char path[64];
    struct drm_parts parts;
};

/* Opens it and reads what there is. Nothing is changed, but where nobody else has the card, the
 * kernel makes us its master. */
int card_open(struct card *card, const char *path, char why[PORT_WHY]);
void card_close(struct card *card);
/* The right to set modes. TIA_ERR_DEVICE and who has it. */
int card_become_master(const struct card *card, char why[PORT_WHY]);
/* Writes "PATH: WHAT: the reason of errno" and returns TIA_ERR_DEVICE. */
int card_failed(const struct card *card, const char *what, char why[PORT_WHY]);

/* A pixel format that tia draws. */
struct card_format {
    uint32_t fourcc;
    const struct pixel_format *pixel;
};

/* Those to try on a CRTC, best first, by n = 0, 1, ...: RGB565 and XRGB8888 whatever the driver
 * says, as some name too little, the others when its primary plane names them. False after the
 * last. `listed`: only those that the plane names. */
bool card_format(const struct card *card, uint32_t crtc, int n, bool listed, struct card_format *format);
/* The same choice, from the list of a plane's formats. */
bool card_format_of(const uint32_t *plane, size_t count, int n, bool listed, struct card_format *format);

/* A buffer that the screen can show and we can write to. */
struct card_buffer {
    uint32_t handle, fb, pitch;
    uint64_t size;
    uint8_t *map; /* NULL: not made */
};

/* 0, or -1 and errno; `what` then says which step. Nothing is left of a failed one. */
int card_buffer_create(const struct card *card, struct card_buffer *buffer, unsigned width, unsigned height,
                       const struct card_format *format, const char **what);
void card_buffer_destroy(const struct card *card, struct card_buffer *buffer);

#endif
