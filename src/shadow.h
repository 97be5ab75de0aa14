/* shadow.h - prepares the test of one sphere between a light and a run of pixels. */
#ifndef TIA_SHADOW_H
#define TIA_SHADOW_H

#include "kernels.h"

/* The light that a run of pixels of one object looks at. */
struct shadow_source {
    const struct body *body;      /* the run's object */
    struct num_vec light;         /* Q */
    int exponent, reach_exponent; /* e_d of |Q - P|^2 and e_p of |P|^2 */
};

/* Prepares `line`, but for count, for the sphere `caster` from pixel (x, y) on.
 * False when it shades none of them. */
bool shadow_line_prepare(const struct tia_view *view, const struct shadow_source *source, const struct body *caster,
                         int x, int y, struct shadow_line *line);

#endif
