/* radio_world.h - scenes of flat faces, and the paths found in them. */
#ifndef TESTS_RADIO_WORLD_H
#define TESTS_RADIO_WORLD_H

#include <tia/radio.h>

#include "check.h"

enum { WORLD_SHAPES = 64, WORLD_PATHS = 4096 };

struct world {
    struct tia_scene scene;
    struct tia_material material;
    struct tia_shape shapes[WORLD_SHAPES];
    struct tia_radio *radio;
    struct tia_radio_room *room;
    struct tia_radio_path paths[WORLD_PATHS];
    unsigned count;
};

static inline void world_begin(struct world *w)
{
    w->scene = (struct tia_scene){.materials = &w->material, .material_count = 1, .shapes = w->shapes};
    w->material = (struct tia_material){.index = TIA_Q16_ONE};
    w->radio = NULL;
    w->room = NULL;
}

static inline struct tia_vec3 world_at(double x, double y, double z)
{
    return (struct tia_vec3){TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)};
}

static inline void world_add(struct world *w, struct tia_shape shape)
{
    w->shapes[w->scene.shape_count++] = shape;
}

static inline void world_plane(struct world *w, struct tia_vec3 point, double x, double y, double z)
{
    world_add(w, (struct tia_shape){.kind = TIA_PLANE, .plane = {point, {TIA_Q30(x), TIA_Q30(y), TIA_Q30(z)}}});
}

static inline void world_box(struct world *w, struct tia_vec3 min, struct tia_vec3 max)
{
    world_add(w, (struct tia_shape){.kind = TIA_BOX, .box = {min, max}});
}

static inline void world_triangle(struct world *w, struct tia_vec3 a, struct tia_vec3 b, struct tia_vec3 c)
{
    world_add(w, (struct tia_shape){.kind = TIA_TRIANGLE, .triangle = {{a, b, c}}});
}

/* Adds the six planes of a room from 0 to the given corner. */
static inline void world_shoebox(struct world *w, double x, double y, double z)
{
    const double far[3] = {x, y, z};

    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2; side++) {
            double at[3] = {0, 0, 0}, n[3] = {0, 0, 0};
            at[k] = side ? far[k] : 0;
            n[k] = side ? -1 : 1;
            world_plane(w, world_at(at[0], at[1], at[2]), n[0], n[1], n[2]);
        }
}

static inline void world_end(struct world *w)
{
    free(w->radio);
    free(w->room);
}

static inline bool world_build(struct world *w)
{
    size_t size = tia_radio_size(&w->scene);
    struct tia_fault fault;

    w->room = malloc(tia_radio_room_size());
    void *memory = malloc(size);
    return memory && w->room && !tia_radio_init(&w->radio, memory, size, &w->scene, &fault);
}

static inline bool world_found(void *ctx, const struct tia_radio_path *path)
{
    struct world *w = ctx;

    if (w->count < WORLD_PATHS)
        w->paths[w->count] = *path;
    w->count++;
    return true;
}

static inline struct tia_radio_link world_link(struct world *w, struct tia_vec3 from, struct tia_vec3 to,
                                               unsigned order, unsigned walls)
{
    return (struct tia_radio_link){from, to, order, walls, world_found, w};
}

/* Compares paths by order, then planes, then walls. The order of sorted paths then does not depend on the method. */
static inline int world_compare(const void *left, const void *right)
{
    const struct tia_radio_path *a = left, *b = right;

    if (a->order != b->order)
        return a->order > b->order ? 1 : -1;
    for (uint32_t i = 0; i < a->order; i++)
        if (a->face[i] != b->face[i])
            return a->face[i] > b->face[i] ? 1 : -1;
    return 0;
}

static inline unsigned world_images(struct world *w, struct tia_vec3 from, struct tia_vec3 to, unsigned order,
                                    unsigned walls)
{
    struct tia_radio_link link = world_link(w, from, to, order, walls);

    w->count = 0;
    CHECK_EQ(tia_radio_images(w->radio, w->room, &link), TIA_OK);
    qsort(w->paths, w->count < WORLD_PATHS ? w->count : WORLD_PATHS, sizeof *w->paths, world_compare);
    return w->count;
}

static inline double world_length(const struct tia_radio_path *path)
{
    return (double)path->length / (double)(INT64_C(1) << TIA_RADIO_LENGTH_BITS);
}

#endif
