/* scanout.h - one CRTC of a card and the two buffers that it shows in turn. */
#ifndef PORT_DRM_SCANOUT_H
#define PORT_DRM_SCANOUT_H

#include "card.h"

#define SCANOUT_CONNECTORS 8 /* that a CRTC lights at once */

struct scanout {
    const struct card *card; /* NULL: not lit */
    uint32_t crtc, connector;
    drmModeModeInfo mode;
    struct card_format format;
    struct card_buffer buffers[2];
    int shown;        /* which of them */
    bool flips;       /* the driver flips pages and tells when */
    unsigned pending; /* flips whose event has not come */
    drmModeCrtc *old; /* as found, and what it lit */
    uint32_t old_connectors[SCANOUT_CONNECTORS];
    int old_count;
};

/* Shows black on the connector: with the first mode and format that the driver takes. Needs the
 * master's rights. */
int scanout_light(struct scanout *scanout, const struct card *card, const drmModeConnector *connector,
                  const char *mode_wish, char why[PORT_WHY]);
/* The buffer that is not shown. */
const struct card_buffer *scanout_hidden(const struct scanout *scanout);
/* Shows it, and waits until it is on the screen. */
int scanout_swap(struct scanout *scanout, char why[PORT_WHY]);
/* Shows again what was shown, after another master. */
int scanout_relight(struct scanout *scanout);
/* Waits for flips on their way. */
void scanout_settle(struct scanout *scanout);
/* Puts back the picture that was there, as long as we are the master, and frees the buffers. */
void scanout_end(struct scanout *scanout);

#endif
