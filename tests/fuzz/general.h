/* general.h - parts of a scene besides spheres and plain lights, from a fuzzer's bytes. */
#ifndef TESTS_FUZZ_GENERAL_H
#define TESTS_FUZZ_GENERAL_H

#include <string.h>

#include "bytes.h"

#define FUZZ_SHAPES 6
#define FUZZ_FACES 4
#define FUZZ_CELLS 8
#define FUZZ_MEMBERS 2

struct fuzz_general {
    struct tia_shape shapes[FUZZ_SHAPES];
    struct tia_transform transforms[2];
    struct tia_texture textures[2];
    struct tia_mesh meshes[2];
    struct tia_grid grids[1];
    struct tia_shape members[FUZZ_MEMBERS];
    uint8_t steps[2 * FUZZ_MEMBERS - 1];
    struct tia_solid solids[1];
    struct tia_vec3 vertices[5];
    struct tia_dir3 normals[2];
    struct tia_uv uvs[2];
    struct tia_face faces[FUZZ_FACES];
    uint8_t cells[FUZZ_CELLS], texels[12];
    struct tia_track tracks[2];
    struct tia_keyframe keys[4];
    struct tia_fall falls[2];
    struct tia_falling falling;
};

/* Takes an index below `count`, or, one time in 32, any number. */
static inline uint32_t take_index(struct bytes *b, uint32_t count)
{
    uint8_t value = take_byte(b);
    return value >= 248 ? take_word(b) - 3 : count ? value % count : 0;
}

/* Takes a kind below `count`, or rarely `count`, which is invalid. */
static inline unsigned take_kind(struct bytes *b, unsigned count)
{
    return take_byte(b) % (count + (take_byte(b) == 255));
}

/* Takes a direction: a unit vector along an axis, or any numbers. */
static inline struct tia_dir3 take_dir3(struct bytes *b)
{
    uint8_t kind = take_byte(b);
    tia_q30 one = kind & 8 ? -TIA_Q30_ONE : TIA_Q30_ONE;

    if (kind >= 128)
        one = (tia_q30)take_word(b);
    return (struct tia_dir3){kind % 3 == 0 ? one : 0, kind % 3 == 1 ? one : 0, kind % 3 == 2 ? one : kind * 1000};
}

static inline void take_shape(struct bytes *b, struct tia_shape *s)
{
    *s = (struct tia_shape){.kind = (enum tia_shape_kind)take_kind(b, 12)};
    s->material = take_index(b, FUZZ_MATERIALS);
    s->transform = s->kind == TIA_PLANE ? 0 : take_index(b, 3);
    struct tia_vec3 one = take_vec3(b), two = take_vec3(b);
    tia_q16 radius = take_number(b), other = take_number(b);
    switch (s->kind) {
    case TIA_SPHERE:
        s->sphere.centre = one;
        s->sphere.radius = radius;
        break;
    case TIA_PLANE:
        s->plane = (struct tia_plane){one, take_dir3(b)};
        break;
    case TIA_DISC:
        s->disc = (struct tia_disc){one, take_dir3(b), radius};
        break;
    case TIA_CYLINDER:
        s->cylinder = (struct tia_cylinder){one, two, radius, other & 1};
        break;
    case TIA_CONE:
        s->cone = (struct tia_cone){one, two, radius, other, radius & 1};
        break;
    case TIA_BOX:
        s->box = (struct tia_box){one, two};
        break;
    case TIA_TRIANGLE:
        s->triangle = (struct tia_triangle){{one, two, take_vec3(b)}};
        break;
    case TIA_MESH:
        s->mesh = take_index(b, 2);
        break;
    case TIA_TORUS:
        s->torus = (struct tia_torus){one, take_dir3(b), radius, other};
        break;
    case TIA_ROUNDED:
        s->rounded = (struct tia_rounded){one, two, radius};
        break;
    case TIA_GRID:
        s->grid = take_index(b, 1);
        break;
    case TIA_SOLID:
        s->solid = take_index(b, 1);
        break;
    }
}

/* Takes a solid, whose members and operation may be refused. */
static inline void take_solid(struct bytes *b, struct fuzz_general *g)
{
    for (int i = 0; i < FUZZ_MEMBERS; i++)
        take_shape(b, &g->members[i]);
    g->steps[0] = g->steps[1] = TIA_SOLID_MEMBER;
    g->steps[2] = (uint8_t)take_kind(b, 4);
    g->solids[0] = (struct tia_solid){g->members, g->steps, FUZZ_MEMBERS, sizeof g->steps};
}

static inline void take_meshes(struct bytes *b, struct fuzz_general *g)
{
    static const uint32_t groups[2] = {7, 3};

    for (int i = 0; i < 5; i++)
        g->vertices[i] = take_vec3(b);
    g->normals[0] = take_dir3(b);
    g->normals[1] = take_dir3(b);
    for (int i = 0; i < FUZZ_FACES * 3; i++) {
        uint8_t kind = i % 3 ? 0 : take_byte(b);
        struct tia_corner *c = &g->faces[i / 3].corner[i % 3];
        *c = (struct tia_corner){take_index(b, 5), TIA_NO_INDEX, TIA_NO_INDEX};
        if (i % 3 ? g->faces[i / 3].corner[0].normal != TIA_NO_INDEX : kind & 1)
            c->normal = take_index(b, 2);
        if (i % 3 ? g->faces[i / 3].corner[0].uv != TIA_NO_INDEX : kind & 2)
            c->uv = take_index(b, 2);
    }
    for (int i = 0; i < 2; i++)
        g->meshes[i] = (struct tia_mesh){
            g->vertices, g->normals, g->uvs, g->faces + 2 * i, 5, 2, 2, (uint32_t)take_byte(b) % 3, i ? groups : NULL};
}

static inline void take_grid(struct bytes *b, struct fuzz_general *g)
{
    uint8_t size = take_byte(b);

    g->grids[0] = (struct tia_grid){.corner = take_vec3(b), .cells = g->cells};
    g->grids[0].cell = TIA_RADIUS_MIN + take_number(b) / 4;
    for (int k = 0; k < 3; k++)
        g->grids[0].size[k] = (uint16_t)(size != 255 ? 1 + (size >> k & 1) : take_byte(b) & 1 ? 0 : 1025 + k);
    for (int i = 0; i < FUZZ_CELLS; i++)
        g->cells[i] = take_byte(b) % 5;
}

static inline void take_tracks(struct bytes *b, struct fuzz_general *g)
{
    for (int i = 0; i < 4; i++) {
        g->keys[i].time = take_number(b);
        g->keys[i].value = take_vec3(b);
    }
    for (int i = 0; i < 2; i++) {
        g->tracks[i] =
            (struct tia_track){.target = (enum tia_target)take_kind(b, TIA_TARGETS), .keys = g->keys + 2 * i};
        g->tracks[i].index = take_index(b, 2);
        g->tracks[i].smooth = take_byte(b) & 1;
        g->tracks[i].key_count = (uint32_t)take_byte(b) % 3;
    }
}

/* Takes falling balls, for a short time, since the fall to each time is computed from the beginning. */
static inline void take_falls(struct bytes *b, struct fuzz_general *g)
{
    for (int i = 0; i < 2; i++) {
        g->falls[i] = (struct tia_fall){.shape = take_index(b, FUZZ_SHAPES), .velocity = take_vec3(b)};
        g->falls[i].restitution = take_number(b);
        g->falls[i].mass = take_number(b);
    }
    g->falling = (struct tia_falling){.balls = g->falls, .count = (uint32_t)take_byte(b) % 4, .gravity = take_vec3(b)};
    g->falling.end = take_number(b) % (TIA_Q16_ONE / 2);
    if (g->falling.count > 2)
        g->falling.count = TIA_FALLS_MAX + 1;
}

static inline void take_light_rest(struct bytes *b, struct tia_light *l)
{
    l->kind = (enum tia_light_kind)take_kind(b, 7);
    l->direction = take_dir3(b);
    l->inner = take_number(b);
    l->outer = take_number(b);
    l->side[0] = take_vec3(b);
    l->side[1] = take_vec3(b);
    l->constant = take_number(b);
    l->linear = take_number(b);
    l->quadratic = take_number(b);
    l->samples = take_byte(b) * 2;
}

static inline void take_material_rest(struct bytes *b, struct tia_material *m)
{
    m->specular = take_rgb(b);
    m->mirror = take_rgb(b);
    m->refraction = take_rgb(b);
    m->facing = take_rgb(b);
    m->exponent = take_number(b);
    m->index = take_number(b);
    m->texture = take_index(b, 3);
    uint8_t flags = take_byte(b);
    m->fresnel = flags & 1;
    m->opacity = flags >> 1 & 3;
    m->bump = flags >> 3 & 3;
}

static inline void take_camera_rest(struct bytes *b, struct tia_camera *c)
{
    c->projection = (enum tia_projection)take_kind(b, 3);
    c->reference = take_vec3(b);
    c->up = take_vec3(b);
    c->window.left = take_number(b);
    c->window.right = take_number(b);
    c->window.bottom = take_number(b);
    c->window.top = take_number(b);
    c->window.near = take_number(b);
    c->samples = take_byte(b) % 18;
}

/* Adds parts chosen by the bytes to a scene of take_scene; none when the bytes have run out. */
static inline void take_general(struct bytes *b, struct fuzz_scene *f, struct fuzz_general *g)
{
    uint8_t what = take_byte(b), shapes = take_byte(b);

    memset(g, 0, sizeof *g);
    f->scene.depth = what & 1 ? take_byte(b) : 0;
    if (what & 2)
        take_camera_rest(b, &f->scene.camera);
    for (uint32_t i = 0; what & 4 && i < f->scene.light_count; i++)
        take_light_rest(b, &f->lights[i]);
    for (uint32_t i = 0; what & 8 && i < FUZZ_MATERIALS; i++)
        take_material_rest(b, &f->materials[i]);
    f->scene.shapes = g->shapes;
    f->scene.shape_count = shapes % (FUZZ_SHAPES + 1);
    f->scene.transforms = g->transforms;
    f->scene.textures = g->textures;
    f->scene.meshes = g->meshes;
    f->scene.grids = g->grids;
    f->scene.solids = g->solids;
    f->scene.tracks = g->tracks;
    f->scene.transform_count = f->scene.texture_count = f->scene.mesh_count = 2;
    f->scene.grid_count = f->scene.solid_count = 1;
    f->scene.track_count = what & 16 ? 2 : 0;
    for (int i = 0; i < 2; i++) {
        const struct tia_transform unit = {{0, 0, 0}, {0, 0, 0}, {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}};
        g->textures[i] = (struct tia_texture){.repeat = {TIA_Q16_ONE, TIA_Q16_ONE}, .width = 2, .height = 2};
        g->textures[i].texels = g->texels;
        g->textures[i].kind = (enum tia_texture_kind)(what & 32 ? take_kind(b, 4) : 0);
        g->textures[i].octaves = what & 128 ? take_byte(b) : 3;
        g->textures[i].depth = what & 128 ? take_number(b) : 0;
        g->textures[i].footprint = what & 128;
        g->transforms[i] = unit;
        if (what & 64) {
            g->transforms[i].position = take_vec3(b);
            g->transforms[i].rotation = take_vec3(b);
            g->transforms[i].scale = take_vec3(b);
        }
    }
    take_meshes(b, g);
    take_grid(b, g);
    if (what & 16)
        take_tracks(b, g);
    for (uint32_t i = 0; i < f->scene.shape_count; i++)
        take_shape(b, &g->shapes[i]);
    take_solid(b, g);
    if (take_byte(b) & 1) {
        take_falls(b, g);
        f->scene.falling = &g->falling;
    }
}

#endif
