/* present.c - shows a frame, also on slow displays. */
#include "loop.h"

static int await(struct loop *loop, int status)
{
    const struct tia_viewer *v = loop->viewer;

    loop->showing = status == TIA_BUSY;
    while (status == TIA_BUSY) {
        status = tia_viewer_watch(loop);
        if (status)
            return status;
        status = v->ports.display->go_on(v->ports.display_ctx);
        loop->showing = status == TIA_BUSY;
    }
    return status;
}

int tia_viewer_present(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    return await(loop, v->ports.display->present(v->ports.display_ctx));
}

/* Continues to show the frame; an event that interrupts this is handled in the next round. */
int tia_viewer_go_on(struct loop *loop)
{
    const struct tia_viewer *v = loop->viewer;

    if (!loop->showing)
        return TIA_OK;
    tia_viewer_watch_begin(loop);
    int status = await(loop, v->ports.display->go_on(v->ports.display_ctx));
    return status == VIEWER_OUTDATED ? TIA_OK : status;
}
