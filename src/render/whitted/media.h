/* media.h - which objects a ray has entered, see tia/material.h. */
#ifndef TIA_RENDER_WHITTED_MEDIA_H
#define TIA_RENDER_WHITTED_MEDIA_H

#include "render/trace/trace.h"

/* The object entered last is the last one. Each is a word, as many rays wait on a small stack: the object's index,
 * below TIA_OBJECTS_MAX, and above it, of a grid, which of its materials. */
struct media {
    uint32_t entered[TIA_MEDIA], count;
};

/* The indices of refraction before and behind a surface. */
struct boundary {
    tia_q16 from, to;
};

/* What a ray passes that is refracted by `object`, where it is of that material, at its front or its back; `media`
 * become those behind it. */
struct boundary media_cross(const struct ray_view *view, struct media *media, uint32_t object,
                            const struct tia_material *material, bool back);

#endif
