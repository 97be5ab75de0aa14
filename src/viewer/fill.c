/* fill.c - fills the gaps between the pixels that the eye needs. */
#include "loop.h"

/* A pixel that is drawn, and the size of the block that it stands for. */
struct sample {
    unsigned x, y, size;
};

/* Returns the largest block of the grid, up to TIA_GAZE_BLOCK, whose corner is (x, y). */
static unsigned level_of(unsigned x, unsigned y)
{
    unsigned bits = x | y | TIA_GAZE_BLOCK;

    return bits & (~bits + 1u);
}

/* Returns the sample shown at (x, y): the smallest block around it whose corner was drawn in the pass of its size.
 * Blocks do not cross tiles. */
static struct sample sample_at(const struct loop *loop, unsigned x, unsigned y)
{
    unsigned left = x / loop->tile_width * loop->tile_width, top = y / loop->tile_height * loop->tile_height;
    struct sample s = {x, y, 1};

    for (; s.size < TIA_GAZE_BLOCK; s.size *= 2) {
        s.x = left + (x - left) / s.size * s.size;
        s.y = top + (y - top) / s.size * s.size;
        if (level_of(s.x - left, s.y - top) == s.size && tia_acuity_block(&loop->acuity, s.x, s.y) <= s.size)
            return s;
    }
    s.x = left + (x - left) / TIA_GAZE_BLOCK * TIA_GAZE_BLOCK;
    s.y = top + (y - top) / TIA_GAZE_BLOCK * TIA_GAZE_BLOCK;
    return s;
}

static tia_rgb565 colour_at(const struct loop *loop, unsigned x, unsigned y)
{
    struct sample s = sample_at(loop, x, y);

    return *viewer_canvas_at(loop, s.x, s.y);
}

/* Gets the colours at a block's corners. For a corner beyond the picture's edge, the block's own column or row is
 * used. */
static void get_corners(const struct loop *loop, struct sample s, tia_rgb565 corners[4])
{
    for (unsigned i = 0; i < 4; i++) {
        unsigned x = s.x + (i & 1) * s.size, y = s.y + (i >> 1) * s.size;
        corners[i] = colour_at(loop, x < loop->mode.width ? x : s.x, y < loop->mode.height ? y : s.y);
    }
}

/* Interpolates a channel bilinearly at (x, y) of a block, in levels of RGB565, rounded to nearest. The weights add up
 * to size^2, at most 256. */
static unsigned mix(const tia_rgb565 corners[4], unsigned shift, unsigned mask, unsigned size, unsigned x, unsigned y)
{
    unsigned a = (corners[0] >> shift & mask) * (size - x) + (corners[1] >> shift & mask) * x;
    unsigned b = (corners[2] >> shift & mask) * (size - x) + (corners[3] >> shift & mask) * x;

    return (a * (size - y) + b * y + size * size / 2) / (size * size);
}

static tia_rgb565 mixed(const tia_rgb565 corners[4], unsigned size, unsigned x, unsigned y)
{
    unsigned red = mix(corners, 11, 31, size, x, y), green = mix(corners, 5, 63, size, x, y);

    return (tia_rgb565)(red << 11 | green << 5 | mix(corners, 0, 31, size, x, y));
}

/* Returns the nearest corner's colour; ties go to the left and upwards. */
static tia_rgb565 nearest(const tia_rgb565 corners[4], unsigned size, unsigned x, unsigned y)
{
    return corners[(2 * x > size) + 2 * (2 * y > size)];
}

/* Fills a row. Reads only drawn pixels and writes only the others, so tiles may be filled in any order. */
static void fill_row(const struct loop *loop, struct tia_tile tile, unsigned y)
{
    struct sample last = {0, 0, 0};
    tia_rgb565 corners[4] = {0, 0, 0, 0};

    for (unsigned x = tile.x; x < (unsigned)tile.x + tile.width; x++) {
        struct sample s = sample_at(loop, x, y);
        if (s.x == x && s.y == y)
            continue;
        if (s.x != last.x || s.y != last.y || s.size != last.size)
            get_corners(loop, s, corners);
        last = s;
        *viewer_canvas_at(loop, x, y) =
            loop->gaze.smooth ? mixed(corners, s.size, x - s.x, y - s.y) : nearest(corners, s.size, x - s.x, y - s.y);
    }
}

static void fill_job(void *arg, unsigned index)
{
    struct loop *loop = arg;
    struct tia_tile tile = tia_viewer_tile(loop, index);
    int status = tia_viewer_watch(loop);

    for (unsigned y = tile.y; !status && y < (unsigned)tile.y + tile.height; y++)
        fill_row(loop, tile, y);
    loop->status[index] = (int8_t)status;
}

int tia_viewer_fill(struct loop *loop)
{
    return loop->gazes ? tia_viewer_run_tiles(loop, fill_job) : TIA_OK;
}
