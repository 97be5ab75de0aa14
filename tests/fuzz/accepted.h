/* accepted.h - scenes with all features from a fuzzer's bytes, nearly all valid: a part that tia_scene_check refuses is
 * replaced. */
#ifndef TESTS_FUZZ_ACCEPTED_H
#define TESTS_FUZZ_ACCEPTED_H

#include "accepted_shapes.h"

static inline void make_camera(struct bytes *b, struct made *m)
{
    struct tia_camera *c = &m->scene.camera;
    uint8_t kind = take_byte(b);

    c->eye = kind & 1 ? take_size(b) : (struct tia_vec3){0, 0, 0};
    m->origin = kind & 2 ? c->eye : (struct tia_vec3){0, 0, 0};
    c->fov = take_within(b, TIA_FOV_MIN, TIA_FOV_MAX);
    c->projection = (enum tia_projection)(kind >> 2 & 3 ? kind >> 2 & 1 : TIA_ORTHOGRAPHIC);
    c->samples = kind & 16 ? 1 : kind & 32 ? 4 : 16;
    if (kind & 64) {
        c->reference = take_place(b, m);
        c->up = take_size(b);
    }
    if (c->projection == TIA_PERSPECTIVE)
        return;
    c->window = (struct tia_window){take_sized(b), take_sized(b), take_sized(b), take_sized(b), take_radius(b)};
    if (kind & 128)
        c->window.left = c->window.right = 0;
}

static inline void make_material(struct bytes *b, struct tia_material *m)
{
    uint8_t kind = take_byte(b);

    *m = (struct tia_material){.colour = take_colour(b, TIA_Q30_ONE), .fresnel = kind & 1, .exponent = TIA_Q16_ONE};
    if (kind & 2)
        m->transmission = take_colour(b, TIA_Q30_ONE);
    if (kind & 4)
        m->mirror = take_colour(b, TIA_Q30_ONE);
    if (kind & 8) {
        m->refraction = take_colour(b, TIA_Q30_ONE);
        m->index = take_within(b, TIA_INDEX_MIN, TIA_INDEX_MAX);
    }
    if (kind & 16) {
        m->specular = take_colour(b, TIA_Q30_ONE);
        m->exponent = take_within(b, TIA_Q16_ONE, TIA_EXPONENT_MAX);
    }
    if (kind & 32)
        m->texture = 1 + (take_byte(b) & 1);
    if (kind % 5 == 4)
        m->opacity = 3;
    if (kind % 7 == 6)
        m->bump = (uint16_t)(1 + take_byte(b) % 3);
    if (kind & 64)
        m->emission = take_colour(b, TIA_Q30_ONE);
    if (kind & 128)
        m->facing = take_colour(b, TIA_Q30_ONE);
}

/* Makes a texture whose texels end where their array does, so that reads beyond are detected. */
static inline void make_texture(struct bytes *b, struct made *m, struct tia_texture *t)
{
    static const uint16_t sizes[][2] = {{1, 1}, {2, 3}, {TIA_TEXTURE_MAX, 1}, {1, TIA_TEXTURE_MAX}};
    uint8_t kind = take_byte(b);

    t->kind = kind & 1 ? TIA_IMAGE : TIA_CHECKER;
    t->bilinear = t->footprint = kind & 2;
    t->repeat[0] = take_within(b, TIA_Q16_ONE / 1024, INT32_MAX);
    t->repeat[1] = take_within(b, TIA_Q16_ONE / 1024, INT32_MAX);
    t->repeat_bits = (int8_t)take_within(b, TIA_TEXTURE_BITS_MIN, TIA_TEXTURE_BITS_MAX);
    t->offset_bits = (int8_t)take_within(b, TIA_TEXTURE_BITS_MIN, TIA_TEXTURE_BITS_MAX);
    t->offset[0] = kind & 16 ? INT32_MIN : kind & 32 ? TIA_Q16(0.3) : 0;
    t->offset[1] = kind & 64 ? INT32_MAX : kind & 128 ? TIA_Q16(-0.3) : 0;
    t->cells[0] = take_colour(b, TIA_Q30_ONE);
    t->cells[1] = take_colour(b, TIA_Q30_ONE);
    t->octaves = (uint8_t)(1 + kind % TIA_OCTAVES_MAX);
    t->depth = take_within(b, -TIA_BUMP_MAX, TIA_BUMP_MAX);
    if ((kind & 13) == 12)
        t->kind = TIA_NOISE;
    t->width = sizes[kind >> 2 & 3][0];
    t->height = sizes[kind >> 2 & 3][1];
    t->texels = m->texels + sizeof m->texels - (size_t)3 * t->width * t->height;
    t->mip_levels = kind & 4 ? m->texels + sizeof m->texels - tia_mip_size(t) : NULL;
}

static inline void make_transform(struct bytes *b, struct made *m, struct tia_transform *t)
{
    uint8_t kind = take_byte(b);

    t->position = kind & 1 ? take_place(b, m) : m->origin;
    t->rotation = kind & 2 ? take_size(b) : (struct tia_vec3){0, 0, 0};
    t->scale.x = take_within(b, TIA_SCALE_MIN, kind & 8 ? 4 * TIA_Q16_ONE : TIA_SCALE_MAX);
    t->scale.y = kind & 4 ? take_within(b, TIA_SCALE_MIN, TIA_SCALE_MAX) : t->scale.x;
    t->scale.z = kind & 4 ? take_within(b, TIA_SCALE_MIN, TIA_SCALE_MAX) : t->scale.x;
}

static inline void make_light(struct bytes *b, const struct made *m, struct tia_light *l)
{
    static const uint16_t samples[] = {1, 0, 2, 3, 7, TIA_LIGHT_SAMPLES_MAX};
    uint8_t kind = take_byte(b);

    *l = (struct tia_light){.centre = take_place(b, m), .emission = take_colour(b, INT32_MAX)};
    l->kind = (enum tia_light_kind)(kind % 7);
    l->radius = kind & 128 ? take_radius(b) : 0;
    if (l->kind == TIA_DIRECTIONAL_LIGHT || l->kind == TIA_SPOT_LIGHT || l->kind == TIA_DISC_LIGHT)
        l->direction = take_direction(b);
    if (l->kind == TIA_SPOT_LIGHT) {
        l->outer = take_within(b, TIA_Q16_ONE, 90 * TIA_Q16_ONE);
        l->inner = take_within(b, 0, l->outer);
    }
    if (l->kind == TIA_RECTANGLE_LIGHT && kind & 128) {
        l->side[0] = take_size(b);
        l->side[1] = take_size(b);
    }
    l->samples = samples[kind / 7 % 6];
    if (kind & 64) {
        l->constant = take_within(b, 0, 32767 * TIA_Q16_ONE);
        l->linear = take_within(b, 0, 32767 * TIA_Q16_ONE);
        l->quadratic = take_within(b, 0, 32767 * TIA_Q16_ONE);
    }
}

static inline void connect(struct made *m, uint8_t counts)
{
    struct tia_scene *s = &m->scene;

    s->materials = m->materials;
    s->spheres = m->spheres;
    s->shapes = m->shapes;
    s->lights = m->lights;
    s->transforms = m->transforms;
    s->textures = m->textures;
    s->meshes = m->meshes;
    s->grids = &m->grid;
    s->solids = &m->solid;
    s->tracks = &m->track;
    s->material_count = MADE_MATERIALS;
    s->transform_count = s->mesh_count = 2;
    s->texture_count = 3;
    s->grid_count = s->solid_count = 1;
    s->sphere_count = counts % (MADE_SPHERES + 1);
    s->shape_count = counts / 4 % (MADE_SHAPES + 1);
    s->light_count = counts / 32 % (MADE_LIGHTS + 1);
    s->track_count = counts / 128;
    m->track = (struct tia_track){TIA_ROTATES_TRANSFORM, 0, true, m->keys, 2};
    m->keys[1].time = 1;
}

/* Returns a point of a shape, or the position of its transform; the fields of each kind begin with a point. */
static inline struct tia_vec3 place_of(const struct made *m, const struct tia_shape *s)
{
    if (s->transform)
        return m->transforms[s->transform - 1].position;
    return s->kind == TIA_MESH ? m->vertices[0] : s->kind == TIA_GRID ? m->grid.corner : s->sphere.centre;
}

/* Aims the camera at a shape. */
static inline void aim(struct bytes *b, struct made *m)
{
    uint8_t kind = take_byte(b);

    if (!(kind & 3) || !m->scene.shape_count)
        return;
    m->scene.camera.reference = place_of(m, &m->shapes[(kind >> 2) % m->scene.shape_count]);
    if (kind & 1)
        m->scene.camera.up = (struct tia_vec3){TIA_Q16_ONE, kind & 128 ? TIA_Q16_ONE : 0, 0};
}

static inline unsigned count_shadows(void)
{
    unsigned count = 0;

    while (tia_shadows_name(count))
        count++;
    return count;
}

static inline void make_scene(struct bytes *b, struct made *m)
{
    uint8_t counts = take_byte(b);

    memset(m, 0, offsetof(struct made, cells));
    connect(m, counts);
    uint8_t depth = take_byte(b);
    m->scene.depth = depth % (TIA_DEPTH_MAX + 1);
    m->scene.shadows = (enum tia_shadows)(depth / (TIA_DEPTH_MAX + 1) % count_shadows());
    m->scene.shadow_map.size = TIA_MAP_SIZE_MIN; /* a light may have 64 samples, with six maps each */
    make_camera(b, m);
    m->scene.background = take_colour(b, TIA_Q30_ONE);
    for (uint32_t i = 0; i < m->scene.shape_count; i++)
        make_shape(b, m, &m->shapes[i]);
    for (uint32_t i = 0; i < m->scene.light_count; i++)
        make_light(b, m, &m->lights[i]);
    for (uint32_t i = 0; i < m->scene.sphere_count; i++) {
        m->spheres[i] = (struct tia_sphere){take_place(b, m), take_radius(b), 0};
        m->spheres[i].material = take_byte(b) % MADE_MATERIALS;
    }
    for (int i = 0; i < 2; i++)
        make_transform(b, m, &m->transforms[i]);
    aim(b, m);
    for (int i = 0; i < MADE_MATERIALS; i++)
        make_material(b, &m->materials[i]);
    make_mesh(b, m);
    make_grid(b, m);
    make_solid(b, m);
    make_texture(b, m, &m->textures[0]);
    make_texture(b, m, &m->textures[1]);
    make_texture(b, m, &m->textures[2]);
    m->textures[2].kind = TIA_OPACITY;
    m->textures[2].mip_levels = m->texels;
    m->textures[2].texels = m->texels + sizeof m->texels - (size_t)m->textures[2].width * m->textures[2].height;
    for (size_t i = sizeof m->texels - 64; i < sizeof m->texels; i++)
        m->texels[i] = (uint8_t)(i * 77);
}

/* Replaces the part that the technique for shadows does not permit: a shape without flat faces becomes a box around the
 * eye or a plane through it. */
static inline void flatten(struct made *m, const struct tia_fault *f)
{
    struct tia_vec3 eye = m->scene.camera.eye;
    struct tia_shape *s = &m->shapes[f->index % MADE_SHAPES];

    if (!strcmp(f->thing, "sphere"))
        m->scene.sphere_count = 0;
    else if (!strcmp(f->thing, "shape"))
        *s = f->index % 2
                 ? (struct tia_shape){.kind = TIA_PLANE, .plane = {eye, {0, TIA_Q30_ONE, 1 << 20}}}
                 : (struct tia_shape){.kind = TIA_BOX,
                                      .box = {{moved(eye.x, -4 * TIA_Q16_ONE), moved(eye.y, -5 * TIA_Q16_ONE), eye.z},
                                              {moved(eye.x, 9 << 16), eye.y, moved(eye.z, 7 << 16)}}};
    else if (!strcmp(f->thing, "material")) {
        m->materials[f->index].transmission = (struct tia_rgb){0, 0, 0};
        m->materials[f->index].opacity = 0;
    } else if (!strcmp(f->thing, "light") && m->lights[f->index].kind != TIA_RECTANGLE_LIGHT)
        m->lights[f->index] = (struct tia_light){eye, 0, TIA_RGB(1, 1, 1), .kind = TIA_RECTANGLE_LIGHT, .samples = 5};
    else if (!strcmp(f->thing, "light"))
        m->lights[f->index].samples = 3;
    else
        m->scene.camera.samples = 1;
}

/* Replaces the part that the fault names, an object by a small one at the eye. */
static inline void mend(struct made *m, const struct tia_fault *f)
{
    struct tia_vec3 eye = m->scene.camera.eye;

    if (strstr(f->rule, "with these shadows")) {
        flatten(m, f);
        return;
    }

    if (!strcmp(f->thing, "shape"))
        m->shapes[f->index] = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {eye, 3 << 16}};
    else if (!strcmp(f->thing, "sphere"))
        m->spheres[f->index] = (struct tia_sphere){eye, 2 << 16, 0};
    else if (!strcmp(f->thing, "light"))
        m->lights[f->index] = (struct tia_light){eye, 0, TIA_RGB(1, 1, 1)};
    else if (!strcmp(f->thing, "transform"))
        m->transforms[f->index].position = eye;
    else if (!strcmp(f->thing, "grid"))
        m->grid = (struct tia_grid){{0, 0, 0}, TIA_RADIUS_MIN, {1, 1, 1}, m->cells};
    else if (!strcmp(f->thing, "solid"))
        for (int i = 0; i < MADE_MEMBERS; i++)
            m->members[i] = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {{0, 0, 0}, (3 + i) << 16}};
    else if (!strcmp(f->thing, "camera"))
        m->scene.camera = (struct tia_camera){.eye = eye, .fov = 25 << 16};
    else
        MUST(!"refused");
}

/* Makes a valid scene; false if the repairs do not suffice. */
static inline bool make_accepted(struct bytes *b, struct made *m)
{
    struct tia_fault fault;

    make_scene(b, m);
    for (int i = 0; i < 4 * MADE_SHAPES + MADE_SPHERES + 3 * MADE_LIGHTS + MADE_MATERIALS; i++) {
        if (!tia_scene_check(&m->scene, &fault))
            return true;
        mend(m, &fault);
    }
    return false;
}

#endif
