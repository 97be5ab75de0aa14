/* accepted_shapes.h - shapes, meshes, grids and solids of scenes that are mostly accepted, from a fuzzer's bytes. */
#ifndef TESTS_FUZZ_ACCEPTED_SHAPES_H
#define TESTS_FUZZ_ACCEPTED_SHAPES_H

#include "made.h"

/* Takes a point of a shape: in the shape's own axes if a transform places it, else in the world. */
static inline struct tia_vec3 take_point(struct bytes *b, const struct made *m, bool placed)
{
    return placed ? take_size(b) : take_place(b, m);
}

static inline void make_mesh(struct bytes *b, struct made *m)
{
    for (int i = 0; i < MADE_VERTICES; i++)
        m->vertices[i] = take_size(b);
    for (int i = 0; i < 3; i++) {
        m->normals[i] = take_direction(b);
        m->uvs[i] = (struct tia_uv){take_sized(b), take_sized(b)};
    }
    for (int i = 0; i < MADE_FACES; i++) {
        uint32_t corners = take_byte(b), kind = take_byte(b);
        for (uint32_t k = 0; k < 3; k++)
            m->faces[i].corner[k] = (struct tia_corner){(corners + k + (corners >> (2 * k) & 3)) % MADE_VERTICES,
                                                        kind & 1 ? (kind / 4 + k) % 3 : TIA_NO_INDEX,
                                                        kind & 2 ? (kind / 4 + k) % 3 : TIA_NO_INDEX};
    }
    m->meshes[0] = (struct tia_mesh){m->vertices, m->normals, m->uvs, m->faces, MADE_VERTICES, 3, 3, 1, NULL};
    m->meshes[1] = m->meshes[0];
    m->meshes[1].face_count = MADE_FACES;
}

/* Makes a grid whose cells end where their array does. */
static inline void make_grid(struct bytes *b, struct made *m)
{
    static const uint16_t sizes[] = {1, 2, 3, 4, 1, 2, 5, TIA_GRID_MAX};
    uint8_t size = take_byte(b), other = take_byte(b), filled[8];
    struct tia_grid *g = &m->grid;

    g->size[0] = sizes[size & 7];
    g->size[1] = g->size[0] == TIA_GRID_MAX ? 2 : sizes[size >> 3 & 7];
    g->size[2] = g->size[1] == TIA_GRID_MAX || g->size[0] == TIA_GRID_MAX ? 1 : sizes[other & 7];
    if (g->size[2] == TIA_GRID_MAX)
        g->size[0] = g->size[1] = 2;
    g->corner = other & 8 ? take_place(b, m) : take_size(b);
    g->cell = take_radius(b);
    if (g->size[0] > 5 || g->size[1] > 5 || g->size[2] > 5)
        g->cell = TIA_RADIUS_MIN + g->cell / TIA_GRID_MAX;
    for (int i = 0; i < 8; i++)
        filled[i] = take_byte(b) % 4;
    for (int i = 0; i < MADE_CELLS; i++)
        m->cells[i] = filled[(i * 5 / 8 + i) % 8] % 3;
    g->cells = m->cells + MADE_CELLS - (size_t)g->size[0] * g->size[1] * g->size[2];
}

static inline void make_box(struct bytes *b, const struct made *m, struct tia_box *box, bool placed)
{
    box->min = take_point(b, m, placed);
    struct tia_vec3 size = take_size(b);
    box->max = (struct tia_vec3){moved(box->min.x, size.x < 0 ? -size.x : size.x),
                                 moved(box->min.y, size.y < 0 ? -size.y : size.y),
                                 moved(box->min.z, size.z < 0 ? -size.z : size.z)};
}

static inline void make_closed(struct bytes *b, const struct made *m, struct tia_shape *s, bool placed)
{
    switch (s->kind) {
    case TIA_SPHERE:
        s->sphere.centre = take_point(b, m, placed);
        s->sphere.radius = take_radius(b);
        break;
    case TIA_CYLINDER:
        s->cylinder =
            (struct tia_cylinder){take_point(b, m, placed), take_point(b, m, placed), take_radius(b), take_byte(b) & 1};
        break;
    case TIA_CONE:
        s->cone = (struct tia_cone){take_point(b, m, placed), take_point(b, m, placed), take_radius(b), take_radius(b),
                                    take_byte(b) & 1};
        if (take_byte(b) & 1)
            s->cone.top_radius = 0;
        break;
    case TIA_TORUS:
        s->torus = (struct tia_torus){take_point(b, m, placed), take_direction(b), take_radius(b), take_radius(b)};
        s->torus.major = moved(s->torus.major, s->torus.minor);
        break;
    case TIA_ROUNDED:
        make_box(b, m, &s->box, placed);
        const struct tia_box box = s->box;
        s->rounded = (struct tia_rounded){box.min, box.max, TIA_RADIUS_MIN};
        break;
    default:
        make_box(b, m, &s->box, placed);
    }
}

static inline void make_shape(struct bytes *b, const struct made *m, struct tia_shape *s)
{
    uint8_t kind = take_byte(b);
    bool placed = kind / 12 % 4 != 0;

    *s = (struct tia_shape){.kind = (enum tia_shape_kind)(kind % 12), .material = take_byte(b) % 3};
    s->transform = s->kind == TIA_PLANE || !placed ? 0 : 1 + kind / 48 % 2;
    switch (s->kind) {
    case TIA_PLANE:
        s->plane = (struct tia_plane){take_place(b, m), take_direction(b)};
        break;
    case TIA_DISC:
        s->disc = (struct tia_disc){take_point(b, m, placed), take_direction(b), take_radius(b)};
        break;
    case TIA_TRIANGLE:
        for (int i = 0; i < 3; i++)
            s->triangle.corner[i] = take_point(b, m, placed);
        break;
    case TIA_MESH:
        s->mesh = kind / 96 % 2;
        break;
    case TIA_GRID:
        s->grid = 0;
        break;
    case TIA_SOLID:
        s->solid = 0;
        break;
    default:
        make_closed(b, m, s, placed);
    }
}

/* Makes a solid of members near its origin: two are combined, then the third with these. */
static inline void make_solid(struct bytes *b, struct made *m)
{
    static const enum tia_shape_kind kinds[] = {TIA_SPHERE, TIA_BOX, TIA_CYLINDER, TIA_CONE, TIA_TORUS, TIA_ROUNDED};
    const uint8_t operations = take_byte(b);
    const uint8_t steps[] = {TIA_SOLID_MEMBER, TIA_SOLID_MEMBER, (uint8_t)(TIA_SOLID_UNION + operations % 3),
                             TIA_SOLID_MEMBER, (uint8_t)(TIA_SOLID_UNION + operations / 3 % 3)};

    for (int i = 0; i < MADE_MEMBERS; i++) {
        uint8_t kind = take_byte(b);
        struct tia_shape *s = &m->members[i];
        *s = (struct tia_shape){.kind = kinds[kind % 6], .material = kind / 6 % 3, .transform = kind / 18 % 3};
        make_closed(b, m, s, true);
        if (s->kind == TIA_CYLINDER)
            s->cylinder.capped = true;
        else if (s->kind == TIA_CONE)
            s->cone.capped = true;
    }
    memcpy(m->steps, steps, sizeof m->steps);
    m->solid = (struct tia_solid){m->members, m->steps, MADE_MEMBERS, sizeof m->steps};
}

#endif
