/* strips.c - the rows of a tile on displays without a limit. */
#include "strips.h"

#include "loop.h"

/* Pixels of a tile: for each face, where these are many; and of tiles whose buffers, 16 bytes a pixel, stay in a cache.
 * Exact maps set up all faces for each tile, each for as long as a few pixels take; the other techniques pass over
 * those that are not in the tile. */
#define FACE_PIXELS 4
#define CACHED_PIXELS UINT32_C(0x40000)
#define EXACT_FACE_PIXELS 48
#define EXACT_SOME_FACES 5 /* times as many pixels for each face, where these are fewer */
#define EXACT_CACHED_PIXELS UINT32_C(0x80000)

/* Returns about the number of faces behind the rasteriser: those of meshes, and six for any other shape. */
static uint64_t face_count(const struct tia_scene *scene)
{
    uint64_t count = 0;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        count += scene->shapes[i].kind == TIA_MESH ? scene->meshes[scene->shapes[i].mesh].face_count : 6;
    return count;
}

static unsigned least(uint64_t a, unsigned b)
{
    return a < b ? (unsigned)a : b;
}

/* Tiles of scenes with many faces are large, as long as each worker gets one. With fewer faces each worker gets four,
 * as tiles take different times. All tiles have about as many rows. */
unsigned tia_strips_raster_rows(const struct tia_scene *scene, unsigned width, unsigned height, unsigned workers)
{
    bool exact = scene->shadows == TIA_SHADOWS_MAP_EXACT;
    uint64_t face_pixels = (exact ? EXACT_FACE_PIXELS : FACE_PIXELS) * face_count(scene);
    uint64_t some = EXACT_SOME_FACES * face_pixels, cached = CACHED_PIXELS;
    unsigned share = (height + workers - 1) / workers;

    if (exact)
        cached = some < EXACT_CACHED_PIXELS ? some : EXACT_CACHED_PIXELS;
    unsigned many = least(face_pixels / width, share), few = least(cached / width, share);

    few = least(few > 4 * VIEWER_STRIP ? few : 4 * VIEWER_STRIP, share / 4);
    unsigned rows = many > few ? many : few, tiles = rows ? (height + rows - 1) / rows : height;
    return (height + tiles - 1) / tiles;
}

/* Traced frames have few rows in a tile, so that each worker gets as many. */
unsigned tia_viewer_strip_rows(const struct loop *loop)
{
    if (loop->base->shadows == TIA_SHADOWS_TRACED)
        return VIEWER_STRIP;
    unsigned rows = tia_strips_raster_rows(loop->base, loop->mode.width, loop->mode.height, viewer_workers(loop));
    return (rows + VIEWER_STRIP - 1) / VIEWER_STRIP * VIEWER_STRIP;
}
