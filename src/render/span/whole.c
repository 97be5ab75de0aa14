/* whole.c - the span renderer with coherence. */
#include "coherence/coherence.h"
#include "coherence/coherence_pays.h"
#include "span.h"

static const struct span_coherence coherence = {coherence_pays, coherence_shade};

static int prepare(struct tia_view *view)
{
    return span_prepare(view, &coherence);
}

const struct renderer span_renderer = {
    .draws = span_draws,
    .prepared_size = span_prepared_size,
    .prepare = prepare,
    .set_lights = span_set_lights,
    .buffer_size = span_buffer_size,
    .trace = span_trace,
    .light = span_light,
    .part = SIMD_SPANS,
};
