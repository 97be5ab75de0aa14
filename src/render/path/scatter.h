/* scatter.h - sampling of reflected directions: Lambert's law, Phong's lobe, mirror and glass.
 *
 * A random number chooses one of these lobes, with a probability proportional to the lobe's largest channel.
 * Reflectances and densities are per solid angle, times pi: for Lambert's law, the reflectance is colour cos, and the
 * density cos. */
#ifndef TIA_RENDER_PATH_SCATTER_H
#define TIA_RENDER_PATH_SCATTER_H

#include "num/num_estimate.h"
#include "render/trace/shading.h"

enum lobe { LOBE_NONE, LOBE_DIFFUSE, LOBE_GLOSSY, LOBE_MIRROR, LOBE_GLASS };

struct scatter {
    const struct shading *surface;
    num_length specular[3], mirror[3], refraction[3];
    struct num_dir mirrored;
    uint32_t below[3]; /* cumulative chances: mirror; mirror or glass; mirror, glass or the glossy lobe */
    bool rough;        /* the surface has a diffuse or a glossy lobe */
    bool black;        /* the surface has no lobe at all */
};

void scatter_prepare(struct scatter *scatter, const struct shading *surface);

/* Evaluates light from the direction `to`, whose cosine to the normal is positive. Sets `reflected` to the reflectance
 * of the diffuse and the glossy lobe, times the cosine, and *density to the density with which scatter_sample would
 * choose `to`. */
void scatter_evaluate(const struct scatter *scatter, struct num_dir to, num_unit cosine, num_length reflected[3],
                      struct num_density *density);

enum lobe scatter_choose(const struct scatter *scatter, uint32_t number);

/* Returns the probability with which scatter_choose returns `lobe`: LOBE_MIRROR or LOBE_GLASS. */
num_unit scatter_chance(const struct scatter *scatter, enum lobe lobe);

/* Samples a direction of the diffuse or the glossy lobe, with the density cos t/pi or (n + 1)/(2 pi) cos^n t. Sets
 * `factor` to the factor of the throughput, and *density as scatter_evaluate does. Returns false if the direction is
 * below the surface. */
bool scatter_sample(const struct scatter *scatter, enum lobe lobe, const uint32_t u[2], struct num_dir *to,
                    num_length factor[3], struct num_density *density);

#endif
