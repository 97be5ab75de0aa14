/* extreme_scenes.h - random scenes for integrators, with sizes, positions and materials at the ends of the accepted
 * ranges. */
#ifndef TESTS_EXTREME_SCENES_H
#define TESTS_EXTREME_SCENES_H

#include "common/corpus/corpus_rays.h"
#include "common/corpus/dice.h"
#include "light_scene.h"

static const tia_q16 sizes[] = {64, 75, 640, TIA_Q16(0.1), TIA_Q16(1), TIA_Q16(90), TIA_Q16(3000), TIA_Q16(11000)};

static tia_q16 random_size(uint64_t *state)
{
    return sizes[dice_next(state) % (sizeof sizes / sizeof *sizes)];
}

/* Returns a position for an object of this size: the centre of an existing sphere, a point on the y axis, or a point at
 * the height size/2. */
static struct tia_vec3 random_place(uint64_t *state, const struct tia_scene *s, tia_q16 size)
{
    tia_q16 away = dice_one_in(state, 2) ? size + TIA_Q16(4) : dice_between(state, 0, TIA_Q16(200));
    struct tia_vec3 p = {0, away, 0};

    if (dice_one_in(state, 3) && s->sphere_count)
        return s->spheres[dice_next(state) % s->sphere_count].centre;
    if (dice_one_in(state, 2))
        p = (struct tia_vec3){dice_between(state, -away, away), size / 2, away};
    return p;
}

static void make_extreme_light(uint64_t *state, struct corpus_rays *c, struct tia_light *l)
{
    static const enum tia_light_kind kinds[] = {TIA_SPHERE_LIGHT, TIA_SPHERE_LIGHT, TIA_DISC_LIGHT, TIA_RECTANGLE_LIGHT,
                                                TIA_POINT_LIGHT};
    tia_q16 size = random_size(state);

    l->kind = kinds[dice_next(state) % 5];
    l->radius = size;
    l->centre = random_place(state, &c->scene, size);
    l->emission_bits = (uint8_t)(dice_one_in(state, 2) ? 0 : dice_between(state, 1, TIA_EMISSION_BITS_MAX));
    l->direction = parts_random_direction(state);
    l->side[0] = (struct tia_vec3){size, dice_between(state, -size, size), 0};
    l->side[1] = dice_one_in(state, 4) ? l->side[0] : (struct tia_vec3){0, size, dice_between(state, -size, size)};
    l->side[1].z++;
}

/* Makes a material extreme: it may reflect more than it receives, have the narrowest or widest highlight, or an index
 * next to 1. */
static void make_extreme_material(uint64_t *state, struct tia_material *m)
{
    const struct tia_rgb white = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};

    if (dice_one_in(state, 2))
        m->colour = white;
    if (dice_one_in(state, 2))
        m->specular = white;
    if (dice_one_in(state, 2))
        m->mirror = white;
    if (dice_one_in(state, 4))
        m->refraction = white;
    m->exponent = dice_one_in(state, 2) ? TIA_EXPONENT_MAX : TIA_Q16_ONE;
    m->index = dice_one_in(state, 2) ? TIA_Q16_ONE + 1 : TIA_Q16(4);
}

/* Makes a cylinder or a cone 1000 times as large, with the same base point. */
static void make_huge(struct tia_shape *s)
{
    struct tia_vec3 along;

    if (s->transform || (s->kind != TIA_CYLINDER && s->kind != TIA_CONE))
        return;
    struct tia_vec3 *base = s->kind == TIA_CONE ? &s->cone.base : &s->cylinder.base;
    struct tia_vec3 *top = s->kind == TIA_CONE ? &s->cone.top : &s->cylinder.top;
    along = parts_moved(*top, *base, -1);
    *base = parts_moved(*base, (struct tia_vec3){0, 0, TIA_Q16(-2500)}, 1);
    *top = (struct tia_vec3){base->x + 1000 * along.x, base->y + 1000 * along.y, base->z + 1000 * along.z};
    if (s->kind == TIA_CYLINDER) {
        s->cylinder.radius *= 1000;
        return;
    }
    s->cone.base_radius *= 1000;
    s->cone.top_radius *= 1000;
}

static void move(struct tia_vec3 *p, struct tia_vec3 by)
{
    *p = parts_moved(*p, by, 1);
}

static void move_shape(struct tia_shape *s, struct tia_vec3 by)
{
    struct tia_vec3 *const points[][3] = {
        [TIA_SPHERE] = {&s->sphere.centre},
        [TIA_PLANE] = {&s->plane.point},
        [TIA_DISC] = {&s->disc.centre},
        [TIA_CYLINDER] = {&s->cylinder.base, &s->cylinder.top},
        [TIA_CONE] = {&s->cone.base, &s->cone.top},
        [TIA_BOX] = {&s->box.min, &s->box.max},
        [TIA_TRIANGLE] = {&s->triangle.corner[0], &s->triangle.corner[1], &s->triangle.corner[2]}};

    if (s->transform || s->kind >= sizeof points / sizeof *points)
        return;
    for (int i = 0; i < 3 && points[s->kind][i]; i++)
        move(points[s->kind][i], by);
}

static void move_all(struct corpus_rays *c, struct tia_vec3 by)
{
    struct tia_scene *s = &c->scene;

    move(&s->camera.eye, by);
    move(&s->camera.reference, by);
    for (uint32_t i = 0; i < s->sphere_count; i++)
        move(&c->spheres[i].centre, by);
    for (uint32_t i = 0; i < s->shape_count; i++)
        move_shape(&c->shapes[i], by);
    for (uint32_t i = 0; i < s->transform_count; i++)
        move(&c->transforms[i].position, by);
    for (uint32_t i = 0; i < s->light_count; i++)
        move(&c->lights[i].centre, by);
}

static void make_extreme(struct corpus_rays *c, unsigned i)
{
    uint64_t state = i * UINT64_C(7919);
    struct tia_scene *s = &c->scene;

    for (uint32_t k = i % 3; i % 5 == 0 && k < s->material_count; k += 3)
        c->materials[k].emission = (struct tia_rgb){TIA_Q30(0.5), TIA_Q30(0.25), TIA_Q30(0.75)};
    s->integration = (struct tia_integration){
        .integrator = i % 8 ? TIA_PATHS : TIA_OCCLUSION, .seed = i, .bounces = 12, .distance = random_size(&state)};
    for (uint32_t k = 0; k < s->light_count; k++)
        make_extreme_light(&state, c, &c->lights[k]);
    for (uint32_t k = 0; i % 2 && k < s->material_count; k++)
        make_extreme_material(&state, &c->materials[k]);
    for (uint32_t k = 0; k < s->sphere_count; k++)
        if (dice_one_in(&state, 2))
            c->spheres[k].radius = random_size(&state);
    for (uint32_t k = 0; i % 6 == 5 && k < s->shape_count; k++)
        make_huge(&c->shapes[k]);
    if (i % 3 == 0)
        s->background = (struct tia_rgb){3, 1, 1000};
    if (i % 4 == 1)
        s->scale_bits = (int32_t)dice_between(&state, 1, 8);
    if (i % 4 == 2)
        move_all(c, (struct tia_vec3){TIA_Q16(14000.3), TIA_Q16(9000.7), TIA_Q16(-12000.1)});
}

/* ---- scenes for one bound each ---- */

static void look_from(double x, double y, double z, double fov)
{
    world.camera = (struct tia_camera){.projection = TIA_PERSPECTIVE,
                                       .eye = {TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)},
                                       .reference = {TIA_Q16(x), TIA_Q16(y), TIA_Q16(z - 10)},
                                       .up = {0, TIA_Q16(1), 0},
                                       .fov = TIA_Q16(fov)};
}

/* Surrounds the eye with a box whose material reflects all light in each of four ways. A path takes one of the four,
 * with a weight that is four times as large. */
static struct tia_material *world_of_all_lobes(uint16_t bounces)
{
    world_begin(TIA_PATHS);
    world_materials[0] = (struct tia_material){.colour = GREY(1),
                                               .mirror = GREY(1),
                                               .specular = GREY(1),
                                               .refraction = GREY(1),
                                               .exponent = TIA_Q16(1),
                                               .index = TIA_Q16(1.5)};
    world.integration.bounces = bounces;
    world_shape(TIA_BOX, 0)->box =
        (struct tia_box){{-TIA_Q16(1), -TIA_Q16(1), -TIA_Q16(1)}, {TIA_Q16(1), TIA_Q16(1), TIA_Q16(1)}};
    look_from(0.1, 0.2, 0.3, 80);
    return &world_materials[0];
}

/* Makes paths whose throughput reaches 2^17, where it is clamped, before they meet a background of 2^-28. */
static void make_cut_throughput(void)
{
    (void)world_of_all_lobes(12);
    world.background = (struct tia_rgb){4, 4, 4};
}

/* Makes two walls of index 1. After 7 bounces, only passing straight through the walls raises a throughput beyond
 * 2^17. */
static void make_cut_layers(void)
{
    world_of_all_lobes(8)->index = TIA_Q16(1);
    world.background = (struct tia_rgb){4, 4, 4};
    world_shape(TIA_BOX, 0)->box =
        (struct tia_box){{-TIA_Q16(2), -TIA_Q16(2), -TIA_Q16(2)}, {TIA_Q16(2), TIA_Q16(2), TIA_Q16(2)}};
}

/* Makes a light that is chosen with a higher probability than it is hit. The product of throughput and radiance is
 * clamped, although the weight would then reduce it. */
static void make_cut_radiance(void)
{
    struct tia_light *lamp;

    (void)world_of_all_lobes(5);
    lamp = world_light(TIA_SPHERE_LIGHT, -0.3, -0.3, -0.2);
    lamp->radius = TIA_Q16(0.2);
    lamp->emission_bits = 12;
}

/* Makes a light 5,200 long and at most 2^-15 wide. Some of its points lie farther behind its plane than the gap at the
 * end of shadow rays. */
static void make_sliver(void)
{
    world_begin(TIA_PATHS);
    world.integration.bounces = 1;
    world_plane(0, -1, 0, 0, 1, 0);
    (void)world_light(TIA_POINT_LIGHT, 1, 1, -1);
    (void)world_light(TIA_POINT_LIGHT, -1, 1, -1);
    struct tia_light *lamp = world_light(TIA_RECTANGLE_LIGHT, 0, 1300, -700);
    lamp->side[0] = (struct tia_vec3){TIA_Q16(1300.3), TIA_Q16(154.2), TIA_Q16(0.7)};
    lamp->side[1] = lamp->side[0];
    lamp->side[1].z++;
    lamp->emission_bits = TIA_EMISSION_BITS_MAX;
    look_from(0, 0, 3, 40);
}

/* Makes rays that graze a scaled sphere and pass straight through it. A unit in the sphere's axes is 2^-35. A ray's
 * origin is behind the surface by only 2^-26 times the grazing angle, so some rays start outside the sphere again. */
static void make_grazed(void)
{
    static const struct tia_transform large = {
        {0, 0, 0}, {TIA_Q16(10.3), TIA_Q16(20.2), TIA_Q16(30.1)}, {TIA_Q16(1024), TIA_Q16(1024), TIA_Q16(1024)}};
    struct tia_shape *ball;

    world_begin(TIA_PATHS);
    world_materials[1] = (struct tia_material){.refraction = GREY(0.5), .index = TIA_Q16(1)};
    world.background = GREY(1);
    world.transforms = &large;
    world.transform_count = 1;
    ball = world_shape(TIA_SPHERE, 1);
    ball->sphere.radius = TIA_Q16(10);
    ball->transform = 1;
    world.camera.eye = (struct tia_vec3){0, TIA_Q16(10240), TIA_Q16(10500)};
    world.camera.reference = (struct tia_vec3){0, TIA_Q16(10240), 0};
    world.camera.window = (struct tia_window){-TIA_Q16(0.001), TIA_Q16(0.001), -TIA_Q16(0.06), TIA_Q16(0.1), 0};
}

static const struct {
    const char *name;
    void (*make)(void);
} bound_scenes[] = {{"cut throughputs", make_cut_throughput},
                    {"cut throughputs of layers", make_cut_layers},
                    {"cut radiance", make_cut_radiance},
                    {"places beside a light's plane", make_sliver},
                    {"straight on through a grazed sphere", make_grazed}};

#endif
