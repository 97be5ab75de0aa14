/* shown.h - the pixels that a window shows, so that strips of sixel pictures are sent only when they have changed. A
 * picture of kitty's protocol is different: the frame that follows removes it. */
#ifndef PORT_TERMINAL_SHOWN_H
#define PORT_TERMINAL_SHOWN_H

#include <tia/damage.h>

#include "encode.h"
#include "pixels/canvas.h"

struct shown {
    struct tia_damage damage;
    tia_rgb565 *pixels; /* NULL: nothing is compared, every strip counts as changed */
};

/* Makes room for a canvas; nothing is shown. Returns TIA_OK or TIA_ERR_MEMORY. */
int shown_resize(struct shown *shown, const struct canvas *canvas);
/* True if the strip has changed since it was last passed; its pixels count as shown from now on. */
bool shown_update(struct shown *shown, const struct canvas *canvas, struct strip strip);
void shown_forget(struct shown *shown); /* The window may show anything. */
void shown_free(struct shown *shown);

#endif
