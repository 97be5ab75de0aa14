/* small.c - the span renderer without coherence, pixel by pixel. */
#include "span.h"

static int prepare(struct tia_view *view)
{
    return span_prepare(view, NULL);
}

const struct renderer span_renderer_small = SPAN_RENDERER(prepare);
