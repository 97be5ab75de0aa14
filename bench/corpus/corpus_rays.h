/* corpus_rays.h - random scenes for the ray renderer, the same on every machine. */
#ifndef PORT_COMMON_CORPUS_RAYS_H
#define PORT_COMMON_CORPUS_RAYS_H

#include <tia/scene.h>

#define CORPUS_RAYS_OBJECTS 12
#define CORPUS_RAYS_LIGHTS 4
#define CORPUS_RAYS_CELLS 6 /* cells of a grid along an axis */
#define CORPUS_RAYS_LAND 5  /* cells of the height field along an axis */
#define CORPUS_RAYS_LAND_POINTS ((CORPUS_RAYS_LAND + 1) * (CORPUS_RAYS_LAND + 1)) /* its vertices */
#define CORPUS_RAYS_TEXELS 8                                                      /* texels of an image along an axis */

/* A scene and the arrays that it points to; do not copy it. */
struct corpus_rays {
    struct tia_scene scene;
    unsigned width, height;
    struct tia_material materials[CORPUS_RAYS_OBJECTS + 3];
    struct tia_sphere spheres[CORPUS_RAYS_OBJECTS + 1];
    struct tia_shape shapes[CORPUS_RAYS_OBJECTS + 1];
    struct tia_transform transforms[CORPUS_RAYS_OBJECTS];
    struct tia_light lights[CORPUS_RAYS_LIGHTS];
    struct tia_texture textures[3];
    struct tia_mesh meshes[2];
    struct tia_grid grid;
    struct tia_vec3 heights[CORPUS_RAYS_LAND_POINTS];
    struct tia_dir3 slopes[CORPUS_RAYS_LAND_POINTS];
    struct tia_uv places[CORPUS_RAYS_LAND_POINTS];
    struct tia_face land[2 * CORPUS_RAYS_LAND * CORPUS_RAYS_LAND];
    uint8_t cells[CORPUS_RAYS_CELLS * CORPUS_RAYS_CELLS * CORPUS_RAYS_CELLS];
    uint8_t texels[CORPUS_RAYS_TEXELS * CORPUS_RAYS_TEXELS * 3];
};

/* Random scene number `index` of the series `seed`: 1 to 12 objects of any shape, many of them instances,
 * on a ground of any of four kinds or none; matt, textured, glossy, mirrors and glass; 1 to 4 lights of
 * any kind; any camera, 1, 4 or 16 samples a pixel; an image of 120x90 to 640x480. tia_scene_check accepts
 * all of them. */
void corpus_random_rays(struct corpus_rays *out, uint64_t seed, unsigned index);

#endif
