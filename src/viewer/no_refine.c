/* no_refine.c - stands in for refine.c in programs that draw spheres alone: spans are never drawn pixel by pixel. */
#include "loop.h"

uint64_t tia_viewer_canvas_size(const struct loop *loop)
{
    (void)loop;
    return 0;
}

bool tia_viewer_refines(const struct loop *loop)
{
    (void)loop;
    return false;
}

int tia_viewer_draw_passes(struct loop *loop, struct tia_frame *frame)
{
    (void)frame;
    return tia_viewer_draw_tiles(loop);
}
