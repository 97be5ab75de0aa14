/* scatter.h - where a path goes on from a surface: by Lambert's law, Phong's lobe, as a mirror or through glass.
 *
 * One random number chooses among them, in proportion to the largest channel of each. Reflectances and densities are
 * over solid angles, times pi: so Lambert's are colour cos and cos. */
#ifndef TIA_RENDER_PATH_SCATTER_H
#define TIA_RENDER_PATH_SCATTER_H

#include "num/num_estimate.h"
#include "render/trace/shading.h"

enum lobe { LOBE_NONE, LOBE_DIFFUSE, LOBE_GLOSSY, LOBE_MIRROR, LOBE_GLASS };

struct scatter {
    const struct shading *surface;
    num_length specular[3], mirror[3], refraction[3];
    struct num_dir mirrored;
    uint32_t below[3]; /* chances of a mirror, of that or glass, of those or the glossy lobe */
    bool rough;        /* it has a diffuse or a glossy lobe */
    bool black;        /* it has none at all */
};

void scatter_prepare(struct scatter *scatter, const struct shading *surface);

/* Of light from `to`, whose cosine to the normal is positive: what the diffuse and the glossy lobe reflect, the cosine
 * included, and with which density scatter_sample would go there. */
void scatter_evaluate(const struct scatter *scatter, struct num_dir to, num_unit cosine, num_length reflected[3],
                      struct num_density *density);

enum lobe scatter_choose(const struct scatter *scatter, uint32_t number);

/* The probability that a path goes on as a mirror, or through glass. */
num_unit scatter_chance(const struct scatter *scatter, enum lobe lobe);

/* Where the path goes on by the diffuse or the glossy lobe, cos t/pi or (n + 1)/(2 pi) cos^n t, and what multiplies its
 * throughput; false: below the surface. `density` is that of scatter_evaluate. */
bool scatter_sample(const struct scatter *scatter, enum lobe lobe, const uint32_t u[2], struct num_dir *to,
                    num_length factor[3], struct num_density *density);

#endif
