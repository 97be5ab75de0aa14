/* whole.c - the span renderer with coherence. */
#include "coherence/coherence.h"
#include "span.h"

static const struct span_coherence coherence = {coherence_nearer, coherence_surround};

static int prepare(struct tia_view *view)
{
    return span_prepare(view, &coherence);
}

const struct renderer span_renderer = SPAN_RENDERER(prepare);
