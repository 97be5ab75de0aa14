/* corpus_parts.h - the parts of corpus_rays.h's scenes. */
#ifndef PORT_COMMON_CORPUS_PARTS_H
#define PORT_COMMON_CORPUS_PARTS_H

#include "corpus_rays.h"

/* p + sign v */
struct tia_vec3 parts_moved(struct tia_vec3 p, struct tia_vec3 v, int32_t sign);

/* A direction of a length from 1/sqrt(3) to 1. */
struct tia_dir3 parts_random_direction(uint64_t *state);

void parts_random_material(uint64_t *state, struct tia_material *material);
void parts_random_light(uint64_t *state, struct tia_light *light);
void parts_random_textures(uint64_t *state, struct corpus_rays *out);

/* A smooth ball of 32 faces, and a height field of 50. */
void parts_random_meshes(uint64_t *state, struct corpus_rays *out);
void parts_random_grid(uint64_t *state, struct corpus_rays *out);

#endif
