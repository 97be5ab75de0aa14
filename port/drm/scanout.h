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
/* Returns the back buffer. */
const struct card_buffer *scanout_hidden(const struct scanout *scanout);
/* Shows the back buffer and waits until it is on screen. */
int scanout_swap(struct scanout *scanout, char why[PORT_WHY]);
/* Shows the front buffer again, after another master had the screen. */
int scanout_relight(struct scanout *scanout);
/* Waits for pending flips. */
void scanout_settle(struct scanout *scanout);
/* Restores the former state of the CRTC, if this process is still the master, and frees the buffers. */
void scanout_end(struct scanout *scanout);

#endif
