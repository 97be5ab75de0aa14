/* strips.c - the rows of a tile on displays without a limit. */
#include "strips.h"

#include "loop.h"

#define FACE_PIXELS 48                  /* pixels of a tile for each face, where these are many */
#define SOME_FACES 5                    /* times as many pixels for each face, where these are fewer */
#define CACHED_PIXELS UINT32_C(0x80000) /* pixels of a tile whose buffers stay in a cache */

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

/* Each tile sets up all faces, each of which takes as long as a few pixels. So tiles of scenes with many faces are
 * large, as long as each worker gets one. With fewer faces each worker gets four, as tiles take different times, and
 * their buffers, 16 bytes a pixel, stay in a cache. All tiles have about as many rows. */
unsigned tia_strips_raster_rows(const struct tia_scene *scene, unsigned width, unsigned height, unsigned workers)
{
    uint64_t faces = face_count(scene);
    unsigned share = (height + workers - 1) / workers;
    unsigned many = least(FACE_PIXELS * faces / width, share);
    unsigned cached = least(CACHED_PIXELS / width, share);
    unsigned some = least(SOME_FACES * FACE_PIXELS * faces / width, cached);
    unsigned few = least(some > 4 * VIEWER_STRIP ? some : 4 * VIEWER_STRIP, share / 4);

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
