/* corpus_parts.h - a random scene of corpus_rays.h, and its parts. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_PARTS_H
#define TOOLS_COMMON_CORPUS_CORPUS_PARTS_H

#include <tia/scene.h>

#define CORPUS_RAYS_OBJECTS 12
#define CORPUS_RAYS_NESTED 10 /* number of further objects, of nested glass */
#define CORPUS_RAYS_LIGHTS 4
#define CORPUS_RAYS_CELLS 6 /* number of cells of a grid along an axis */
#define CORPUS_RAYS_LAND 5  /* number of cells of the height field along an axis */
#define CORPUS_RAYS_LAND_POINTS ((CORPUS_RAYS_LAND + 1) * (CORPUS_RAYS_LAND + 1)) /* number of its vertices */
#define CORPUS_RAYS_TEXELS 8                                                      /* texels of an image along an axis */

/* A scene and the arrays that it points to; do not copy it. */
#define CORPUS_RAYS_SOLIDS 6
#define CORPUS_RAYS_MEMBERS 7

struct corpus_rays {
    struct tia_scene scene;
    unsigned width, height;
    struct tia_material materials[CORPUS_RAYS_OBJECTS + 3 + CORPUS_RAYS_NESTED];
    struct tia_sphere spheres[CORPUS_RAYS_OBJECTS + 1];
    struct tia_shape shapes[CORPUS_RAYS_OBJECTS + 1 + CORPUS_RAYS_NESTED];
    struct tia_transform
        transforms[CORPUS_RAYS_OBJECTS + CORPUS_RAYS_NESTED + CORPUS_RAYS_SOLIDS * CORPUS_RAYS_MEMBERS];
    struct tia_light lights[CORPUS_RAYS_LIGHTS];
    struct tia_fog fog;
    struct tia_texture textures[5]; /* the last two are opacities */
    struct tia_mesh meshes[2];
    struct tia_grid grid;
    struct tia_solid solids[CORPUS_RAYS_SOLIDS];
    struct tia_shape members[CORPUS_RAYS_SOLIDS][CORPUS_RAYS_MEMBERS];
    uint8_t steps[CORPUS_RAYS_SOLIDS][2 * CORPUS_RAYS_MEMBERS - 1];
    struct tia_vec3 heights[CORPUS_RAYS_LAND_POINTS];
    struct tia_dir3 slopes[CORPUS_RAYS_LAND_POINTS];
    struct tia_uv places[CORPUS_RAYS_LAND_POINTS];
    struct tia_face land[2 * CORPUS_RAYS_LAND * CORPUS_RAYS_LAND];
    uint32_t groups[2 * CORPUS_RAYS_LAND * CORPUS_RAYS_LAND]; /* groups of the faces */
    uint8_t cells[CORPUS_RAYS_CELLS * CORPUS_RAYS_CELLS * CORPUS_RAYS_CELLS];
    uint8_t texels[CORPUS_RAYS_TEXELS * CORPUS_RAYS_TEXELS * 3];
    uint8_t opacities[CORPUS_RAYS_TEXELS * CORPUS_RAYS_TEXELS];
};

/* Returns p + sign v. */
struct tia_vec3 parts_moved(struct tia_vec3 p, struct tia_vec3 v, int32_t sign);

/* Returns a direction of a length from 1/sqrt(3) to 1. */
struct tia_dir3 parts_random_direction(uint64_t *state);

void parts_random_material(uint64_t *state, struct tia_material *material);
void parts_random_light(uint64_t *state, struct tia_light *light);
/* Gives on average half of the materials an opacity texture. */
void parts_random_opacities(uint64_t *state, struct corpus_rays *out);

void parts_random_textures(uint64_t *state, struct corpus_rays *out);

/* Makes a smooth ball of 32 faces, and a height field of 50. */
void parts_random_meshes(uint64_t *state, struct corpus_rays *out);
void parts_random_grid(uint64_t *state, struct corpus_rays *out);

/* Adds shapes nested in each other, with the materials from number `material` on, and groups of the meshes' faces. */
void parts_random_nest(uint64_t *state, struct corpus_rays *out, uint32_t material);

#endif
