/* scanout.h - one CRTC of a card, double buffered. */
#ifndef PORT_DRM_SCANOUT_H
#define PORT_DRM_SCANOUT_H

#include "card.h"

#define SCANOUT_CONNECTORS 8 /* connectors that a CRTC can drive at once */

struct scanout {
    const struct card *card; /* NULL: no mode set */
    uint32_t crtc, connector;
    drmModeModeInfo mode;
    struct card_format format;
    struct card_buffer buffers[2];
    int shown;                                   /* index of the buffer on screen */
    bool copied;                                 /* the screen has memory of its own, to which the driver copies the
                                                    buffer on screen by DIRTYFB: no other buffer is shown */
    bool flips;                                  /* the driver flips pages and sends an event for each flip */
    unsigned pending;                            /* flips whose event has not come yet */
    drmModeCrtc *old;                            /* the former state of the CRTC */
    uint32_t old_connectors[SCANOUT_CONNECTORS]; /* connectors that the CRTC drove then */
    int old_count;
};

/* Shows black on the connector, in the first mode and format that the driver accepts. This process must be the card's
 * master. */
int scanout_light(struct scanout *scanout, const struct card *card, const drmModeConnector *connector,
                  const char *mode_wish, char why[PORT_WHY]);
/* Returns the index of the buffer to draw into: the back buffer, or the only one. */
int scanout_drawn(const struct scanout *scanout);
/* Shows that buffer and waits until it is on screen. The `count` rectangles have all its pixels that differ from those
 * that it or the other buffer had when last shown; NULL: any pixel may. */
int scanout_swap(struct scanout *scanout, drmModeClip *changed, unsigned count, char why[PORT_WHY]);
/* Shows the front buffer again, after another master had the screen. */
int scanout_relight(struct scanout *scanout);
/* Waits for pending flips. */
void scanout_settle(struct scanout *scanout);
/* Restores the former state of the CRTC, if this process is still the master, and frees the buffers. */
void scanout_end(struct scanout *scanout);

#endif
