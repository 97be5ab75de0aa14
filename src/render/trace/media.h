/* media.h - the objects that a ray has entered, see tia/material.h. */
#ifndef TIA_RENDER_TRACE_MEDIA_H
#define TIA_RENDER_TRACE_MEDIA_H

#include "trace.h"

/* The entered objects in the order of entry. Each object is packed into a word, since many rays are pending on a small
 * stack. The word is the object's index, below TIA_OBJECTS_MAX, with the number of a grid's or solid's material in the
 * bits above it. */
struct media {
    uint32_t entered[TIA_MEDIA_MAX], count;
};

/* The indices of refraction before and behind a surface. */
struct boundary {
    tia_q16 from, to;
};

/* Returns the boundary where a ray meets the front or, if `back`, the back of `object`, which has the material
 * `material` there. Sets *media to the media behind the boundary. */
struct boundary media_cross(const struct ray_view *view, struct media *media, uint32_t object,
                            const struct tia_material *material, bool back);

#endif
