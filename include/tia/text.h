/* text.h - small text on pictures: ASCII in cells of 6x8 pixels, for programs with or without an OS.
 *
 * Letters take a cell's first five columns and seven rows; the eighth row is for descenders (g j p q y , ;) and _. A
 * line feed begins a new line; characters that are not ASCII are blank. The text has a border of one pixel at the left
 * and above, so that m columns and n lines cover 6 m + 1 by 8 n + 1 pixels, times the scale.
 */
#ifndef TIA_TEXT_H
#define TIA_TEXT_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_TEXT_WIDTH 6
#define TIA_TEXT_HEIGHT 8

struct tia_text {
    const char *text;
    uint16_t x, y;         /* position of the text's upper left corner, pixels of the image */
    uint16_t scale;        /* size of a letter's dot, in pixels, at least 1 */
    tia_rgb565 ink, paper; /* colours of the letters and of the rest */
};

/* Returns the part of a width x height image that the text covers; empty when all of it is outside, or the scale is
 * 0. */
struct tia_tile tia_text_area(const struct tia_text *text, unsigned width, unsigned height);

/* Draws the part of the text that is in `tile`, whose memory is *surface; all other pixels stay unchanged. */
int tia_text_draw(const struct tia_text *text, struct tia_tile tile, const struct tia_surface *surface);

#ifdef __cplusplus
}
#endif

#endif
