/* whole.c - the span renderer with coherence. */
#include "coherence/coherence.h"
#include "span.h"
#include "words/words_shade.h"

static const struct span_coherence coherence = {coherence_nearer, coherence_shadows, words_lights, words_add};

static int prepare(struct tia_view *view)
{
    return span_prepare(view, &coherence);
}

const struct renderer span_renderer = SPAN_RENDERER(prepare);
