/* no_coherence.c - replaces the files coherence*.c on boards without the room: no sphere is wide. */
#include "coherence.h"
#include "coherence_pays.h"

bool coherence_pays(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    (void)primary;
    (void)sphere;
    return false;
}

bool coherence_shade(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[8],
                     tia_rgb565 *pixels)
{
    (void)view;
    (void)span;
    (void)threshold;
    (void)pixels;
    return false;
}
