/* coherence_pays.h - decides which spheres are wide, see coherence.h. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_PAYS_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_PAYS_H

#include "render/span/span_sphere.h"

/* True if a sphere is seen from outside and so large in the image that many of its pixels have one colour. */
bool coherence_pays(const struct primary_rays *primary, const struct span_sphere *sphere);

#endif
