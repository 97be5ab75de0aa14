/* small.c - the span renderer without coherence, pixel by pixel. */
#include "span.h"

static int prepare(struct tia_view *view)
{
    return span_prepare(view, NULL);
}

const struct renderer span_renderer_small = {
    .draws = span_draws,
    .prepared_size = span_prepared_size,
    .prepare = prepare,
    .set_lights = span_set_lights,
    .buffer_size = span_buffer_size,
    .trace = span_trace,
    .light = span_light,
    .part = SIMD_SPANS,
};
