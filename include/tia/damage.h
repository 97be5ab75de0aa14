/* damage.h - what has changed on a display: pixels that it shows already need not be sent again.
 *
 *     tia_damage_init(&damage, memory, sizeof memory, 320, 240);
 *     for each tile of a frame:
 *         if (tia_damage_update(&damage, tile, &surface, &changed))
 *             send the rectangle `changed`, which is a part of the tile
 *     tia_damage_complete(&damage);
 *
 * Pixels are compared with what the display shows, whatever has drawn them and whatever has moved: no changed pixel is
 * ever left out. What is shown is in the caller's memory. With two bytes a pixel that is a copy of the picture, and it
 * may be the display's own frame. With less it is the colour of each block of pixels of a row that has one colour, and
 * a bit that says so: blocks that have and had the same one colour are unchanged, and all others count as changed.
 */
#ifndef TIA_DAMAGE_H
#define TIA_DAMAGE_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_DAMAGE_BLOCK_MAX 8192 /* the largest number of pixels in a block */

/* What a display shows. All members are private. */
struct tia_damage {
    tia_rgb565 *colours; /* of each block, row by row */
    uint8_t
        *plain; /* a bit for each block, rows begin with a byte: the block has one colour; NULL: blocks are pixels */
    uint16_t width, height, columns; /* of the picture in pixels; blocks of a row */
    uint8_t shift;                   /* a block has 2^shift pixels */
    bool complete;                   /* all pixels are known */
};

/* Returns the number of bytes of memory for a picture of width x height pixels, each 1..TIA_SIZE_MAX, in blocks of
 * `block` pixels, a power of two up to TIA_DAMAGE_BLOCK_MAX; 1: single pixels, 2 width height bytes. SIZE_MAX when an
 * argument is out of its range, or the number does not fit. */
size_t tia_damage_size(unsigned width, unsigned height, unsigned block);

/* Chooses the smallest blocks for which `memory`, aligned for uint16_t, is large enough. Nothing is known of what the
 * display shows. TIA_ERR_ARGUMENT when a size is out of its range; TIA_ERR_MEMORY when `size` is less than the
 * tia_damage_size of blocks of any size. */
int tia_damage_init(struct tia_damage *damage, void *memory, size_t size, unsigned width, unsigned height);

/* Compares the pixels of `tile` with what the display shows, and stores them as shown. Returns true if some must be
 * sent: *changed is the smallest rectangle, in pixels of the picture, that includes them, made of whole blocks as far
 * as these are in the tile. Before tia_damage_complete this is the whole tile. All surfaces must have the same byte
 * order. Several threads may call this at once with tiles that have no row in common. False when an argument is NULL,
 * the tile is empty or leaves the picture, or the surface has no pixels or is not aligned. */
bool tia_damage_update(struct tia_damage *damage, struct tia_tile tile, const struct tia_surface *surface,
                       struct tia_tile *changed);

/* Marks all pixels as known: each has been in a tile since tia_damage_init or tia_damage_forget, and all have been
 * sent; or, if single pixels are compared, the memory is what the display shows. */
void tia_damage_complete(struct tia_damage *damage);

/* Marks all pixels as unknown, as after a failure to send. */
void tia_damage_forget(struct tia_damage *damage);

#ifdef __cplusplus
}
#endif

#endif
