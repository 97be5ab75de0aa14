/* changes.h - what has changed of a canvas, for displays that copy it to one or two pages of a screen's memory. A page
 * was shown one or two frames ago, so that it lacks the changes of as many frames.
 *
 * The picture is divided into bands of rows; of each band, the rectangle around the changes is copied. */
#ifndef PORT_CHANGES_H
#define PORT_CHANGES_H

#include <tia/damage.h>

#include "canvas.h"

#define CHANGES_PAGES 2
#define CHANGES_BANDS 256 /* at most; the largest number of rectangles that DRM accepts at once */

struct changes {
    struct tia_damage damage;
    tia_rgb565 *shown;                       /* the last frame */
    unsigned bands, rows;                    /* number of bands; rows of a band */
    struct tia_tile (*lacks)[CHANGES_PAGES]; /* of each band, what each page lacks; a width of 0: nothing */
};

/* Returns memory for the pixels of a canvas as they are shown, which nothing is known of, and which the caller frees;
 * NULL: there is none. */
tia_rgb565 *damage_of_canvas(struct tia_damage *damage, const struct canvas *canvas);

/* Makes room for the changes of a canvas; both pages lack all of it. After TIA_ERR_MEMORY `changes` is empty. */
int changes_resize(struct changes *changes, const struct canvas *canvas);

/* Compares the canvas, which has a whole frame, with the last one. */
void changes_find(struct changes *changes, const struct canvas *canvas);

/* Gives the rectangle of a band that a page lacks, which is to be copied now: then the page lacks nothing of it. False
 * when it lacks nothing. */
bool changes_take(struct changes *changes, unsigned page, unsigned band, struct tia_tile *area);

/* Both pages lack all of the picture, as after another program has used them. */
void changes_forget(struct changes *changes);

void changes_free(struct changes *changes);

#endif
