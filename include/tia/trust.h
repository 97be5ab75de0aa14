/* trust.h - checks for displays that must not show a wrong picture: of the memory that pictures are drawn from, and of
 * the pixels. docs/trust.md says what the checks guarantee and what they do not. A program that calls none of these
 * functions links none of them. It is not included by tia.h.
 */
#ifndef TIA_TRUST_H
#define TIA_TRUST_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- a view's memory ---- */

/* Checksums of a view's memory, of its scene, of the scene's arrays, and of the arrays that these refer to: each step
 * is compared before its pointers are used. A change of one bit or of two bits of a step is always noticed, and of
 * other changes all but one in 2^64. Private to the library, except that the program may copy or move it. */
struct tia_seal {
    uint64_t sums[5];
};

/* A view, its seal, and memory for hits. As all functions here trust this structure, it should be a const object in
 * read-only memory, with the addresses of static arrays. */
struct tia_sealed {
    void *view; /* the memory that a view was prepared in; nothing else may be stored there */
    size_t view_size;
    void *hits; /* memory for the hits of the tiles to draw, aligned for uint64_t, see tia_hits_size */
    size_t hits_size;
    struct tia_seal *seal;
    bool without_scene; /* true: checks the view alone, for a scene in read-only memory */
};

/* Stores the seal of a view that has just been prepared or got new lights. TIA_ERR_MEMORY when `view_size` is less than
 * the view has; TIA_ERR_UNSUPPORTED for a view with vector units, whose memory changes while it draws, or of a core
 * with a `drawing` of its own. */
int tia_view_seal(const struct tia_sealed *sealed);

/* Compares the view and its scene with the seal. TIA_ERR_DAMAGED when they differ: then prepare the view again.
 * TIA_ERR_DAMAGED, too, if the seal has changed. Reads every byte once. */
int tia_view_check(const struct tia_sealed *sealed);

/* Does the work of tia_view_check, tia_view_set_lights and tia_view_seal. After an error the old seal stays. */
int tia_view_set_lights_checked(const struct tia_sealed *sealed, const struct tia_light *lights, uint32_t count);

/* Checks the view, draws `tile` as tia_view_draw does, with new hits, and checks again: a change before the call draws
 * nothing, and a change during the call is reported at its end. Errors as for tia_view_check, tia_hits_init and
 * tia_view_draw. */
int tia_view_draw_checked(const struct tia_sealed *sealed, struct tia_tile tile, const struct tia_surface *surface,
                          const struct tia_options *options);

/* ---- what a display shows ---- */

/* Reads back what a display shows. */
struct tia_readback {
    /* Gives the pixels of a part of a row, tile.width x 1, as RGB565. Returns an enum tia_status. */
    int (*read)(void *ctx, struct tia_tile tile, tia_rgb565 *pixels);
    void *ctx;
};

/* Pixels that are not as drawn: their number, and the first one, row by row. */
struct tia_difference {
    uint32_t count; /* 0: the rest is undefined */
    uint16_t x, y;
    tia_rgb565 drawn, read;
};

/* Draws `tile` again, row by row, and compares it with what the display shows. TIA_ERR_DAMAGED with the difference, if
 * it is not NULL; its count is 0 if instead the view has changed, which is checked before the first row and after the
 * last. TIA_ERR_MEMORY when `pixels` has less than 2 * tile.width pixels, `count` of them, or the hits have too little
 * memory for a row; an error of `read` ends the comparison. `dither` is as in struct tia_options. */
int tia_view_compare(const struct tia_sealed *sealed, struct tia_tile tile, bool dither,
                     const struct tia_readback *readback, tia_rgb565 *pixels, size_t count,
                     struct tia_difference *difference);

/* ---- telltales ---- */

/* A rectangle of the picture whose pixels are known for each state of a scene, as tia-compile --crc writes it. */
struct tia_telltale {
    const char *name;
    struct tia_tile area; /* in pixels of the picture */
    const uint32_t *crcs; /* for each state the CRC-32 of the area, see tia_crc32 in debug.h, row by row */
};

/* The telltales of a scene. State 0 has the scene's lights; state n + 1 has those after pressing keys[n] in state 0. */
struct tia_telltales {
    uint16_t width, height; /* size of the picture */
    const struct tia_telltale *telltales;
    const uint16_t *keys; /* enum tia_key or ASCII, see port.h */
    uint32_t telltale_count, key_count;
};

/* What has been added of one telltale. All zero: nothing yet. */
struct tia_telltale_sum {
    uint32_t crc;
    uint16_t rows; /* number of rows in `crc` */
};

/* Adds the pixels of a tile of the picture to `sums`, one for each telltale. The tiles come from top to bottom, and
 * each has the whole width of the telltales that it touches. The first row of a telltale's area begins a new sum.
 * TIA_ERR_ARGUMENT, with the other telltales added, when a telltale's rows are not in order, or its columns not all in
 * the tile: then its sum stays incomplete. */
int tia_telltales_add(const struct tia_telltales *all, struct tia_telltale_sum *sums, struct tia_tile tile,
                      const struct tia_surface *surface);

/* Compares all sums with the CRCs of a state, and clears them, so that the next check needs another frame.
 * TIA_ERR_DAMAGED when one differs or is incomplete; *wrong receives the index of the first such telltale (`wrong` may
 * be NULL). */
int tia_telltales_check(const struct tia_telltales *all, struct tia_telltale_sum *sums, uint32_t state,
                        uint32_t *wrong);

#ifdef __cplusplus
}
#endif

#endif
