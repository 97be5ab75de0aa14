/* strips.c - the rows of a tile on displays without a limit. */
#include "loop.h"

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

/* Traced frames have few rows in a tile, so that each worker gets as many. Behind the rasteriser each tile sets up all
 * faces, each of which takes as long as a few pixels: there they are more, as long as each worker gets four tiles or,
 * of scenes with many faces, one. */
unsigned tia_viewer_strip_rows(const struct loop *loop)
{
    if (loop->base->shadows == TIA_SHADOWS_TRACED)
        return VIEWER_STRIP;
    unsigned share = (loop->mode.height + viewer_workers(loop) - 1) / viewer_workers(loop);
    unsigned by_faces = least(32 * face_count(loop->base) / loop->mode.width, share);
    unsigned rows = least(share / 4, 4 * VIEWER_STRIP);
    rows = by_faces > rows ? by_faces : rows;
    return (rows + VIEWER_STRIP - 1) / VIEWER_STRIP * VIEWER_STRIP;
}
