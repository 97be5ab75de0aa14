#include "emitters.h"

#include "math/align.h"
#include "samples/direction.h"
#include "scene/colour.h"

void emitter_radiance(const struct tia_rgb *emission, uint8_t bits, num_length radiance[3])
{
    ray_rgb(emission, radiance);
    for (int c = 0; c < 3; c++)
        radiance[c] = num_product_within(radiance[c], num_integer(INT32_C(1) << bits));
}

static bool emits(const struct tia_scene *scene, uint32_t sphere)
{
    return !colour_is_black(&scene->materials[scene->spheres[sphere].material].emission);
}

/* Returns the area 4 |s x t| of a rectangle with the half sides s and t: 2 |s| times 2 |t| times the sine of their
 * angle. */
static struct num_density rectangle_area(const struct ray_light *l)
{
    struct num_dir along[2], normal;

    (void)num_normalise(l->side[0], &along[0]);
    (void)num_normalise(l->side[1], &along[1]);
    normal = num_dir_cross(along[0], along[1]);
    num_unit square = num_dir_dot(normal, normal);
    struct num_density sides =
        num_density_product(num_density_of(2 * num_norm(l->side[0])), num_density_of(2 * num_norm(l->side[1])));
    return num_density_product(sides,
                               num_density_of_unit(num_unit_sqrt(square < NUM_UNIT_ONE ? square : NUM_UNIT_ONE)));
}

#define PI_Q45 INT64_C(0x6487ed5110b4)

static struct num_density pi(void)
{
    return num_density_of(num_length_of_q45(PI_Q45));
}

static struct num_density disc_area(const struct ray_light *l)
{
    struct num_density radius = num_density_of(l->radius);

    return num_density_product(pi(), num_density_product(radius, radius));
}

/* Returns 0: points have no area, and spheres are sampled by the cone of directions to them. */
static struct num_density no_area(const struct ray_light *l)
{
    (void)l;
    return (struct num_density){0};
}

static struct num_point place_on_rectangle(const struct ray_light *l, const uint32_t u[2])
{
    return ray_light_rectangle_point(l, 2 * (num_unit_of_u32(u[0]) - NUM_UNIT_ONE / 2),
                                     2 * (num_unit_of_u32(u[1]) - NUM_UNIT_ONE / 2));
}

static struct num_point place_on_disc(const struct ray_light *l, const uint32_t u[2])
{
    int64_t flat[2];

    tia_sample_disc(u, flat);
    return num_point_add(l->centre,
                         num_point_add(num_point_along(l->axes[0], num_times(l->radius, num_unit_of_q62(flat[0]))),
                                       num_point_along(l->axes[1], num_times(l->radius, num_unit_of_q62(flat[1])))));
}

static struct num_point place_at_centre(const struct ray_light *l, const uint32_t u[2])
{
    (void)u;
    return l->centre;
}

struct emitter_light {
    enum emitter_kind kind;
    struct num_density (*area)(const struct ray_light *l);                     /* area of an EMITTER_PLANE, else 0 */
    struct num_point (*place)(const struct ray_light *l, const uint32_t u[2]); /* random point on an EMITTER_PLANE */
};

/* A row for each kind of TIA_LIGHTS. */
#define EMITTER(name, kind, area, place) static const struct emitter_light name##_emitter = {kind, area, place}
EMITTER(point, EMITTER_POINT, no_area, place_at_centre);
EMITTER(directional, EMITTER_POINT, no_area, place_at_centre);
EMITTER(ambient, EMITTER_POINT, no_area, place_at_centre);
EMITTER(spot, EMITTER_POINT, no_area, place_at_centre);
EMITTER(rectangle, EMITTER_PLANE, rectangle_area, place_on_rectangle);
EMITTER(disc, EMITTER_PLANE, disc_area, place_on_disc);
EMITTER(sphere, EMITTER_SPHERE, no_area, place_at_centre);

static void set_shape(struct emitter *emitter, const struct ray_light *light)
{
#define SHAPE(KIND, name, what, traits)                                                                                \
    case KIND:                                                                                                         \
        emitter->kind = name##_emitter.kind;                                                                           \
        emitter->area = name##_emitter.area(light);                                                                    \
        break;
    switch (light->kind) {
        TIA_LIGHTS(SHAPE)
    }
}

static struct num_point place_on_plane(const struct ray_light *l, const uint32_t u[2])
{
#define PLACE(KIND, name, what, traits)                                                                                \
    case KIND:                                                                                                         \
        return name##_emitter.place(l, u);
    switch (l->kind) {
        TIA_LIGHTS(PLACE)
    }
    return l->centre;
}

void emitter_of_light(const struct ray_light *light, const struct tia_light *given, struct emitter *emitter)
{
    *emitter = (struct emitter){.light = light, .centre = light->centre, .radius = light->radius};
    emitter_radiance(&given->emission, given->emission_bits, emitter->radiance);
    set_shape(emitter, light);
}

void emitter_of_sphere(const struct tia_scene *scene, uint32_t sphere, struct emitter *emitter)
{
    const struct tia_material *m = &scene->materials[scene->spheres[sphere].material];

    *emitter = (struct emitter){
        .kind = EMITTER_SPHERE, .centre = ray_sphere_centre(scene, sphere), .radius = ray_sphere_radius(scene, sphere)};
    emitter_radiance(&m->emission, m->emission_bits, emitter->radiance);
}

static uint32_t count_spheres(const struct tia_scene *scene, struct cancel *cancel)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->sphere_count && !cancelled(cancel, 1); i++)
        count += scene->spheres[i].material < scene->material_count && emits(scene, i);
    return count;
}

uint64_t emitters_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    struct cancel never = {0};

    return ((uint64_t)light_capacity + count_spheres(scene, &never)) * sizeof(struct emitter);
}

/* Sets the memory for the emitters, which emitters_set fills in, and counts the emitting spheres. */
int emitters_prepare(struct emitters *emitters, const struct ray_view *view, void *memory)
{
    struct cancel cancel = view_cancel(view->view);

    emitters->first = memory;
    emitters->count = 0;
    emitters->spheres = count_spheres(view->scene, &cancel);
    return cancel.stopped ? TIA_STOPPED : TIA_OK;
}

/* False for a light that is dark, that paths do not sample, or whose area is 0. */
static bool shines(const struct tia_light *l)
{
    if (!tia_light_has(l->kind, TIA_LIGHT_PATHS) || colour_is_black(&l->emission))
        return false;
    if (!tia_light_has(l->kind, TIA_LIGHT_AREA))
        return true;
    return tia_light_has(l->kind, TIA_LIGHT_SIDES) ? l->side[0].x || l->side[0].y || l->side[0].z : l->radius > 0;
}

/* Converts a count, 0..2^25, to a struct num_density. */
static struct num_density count_density(uint32_t count)
{
    return num_density_product(num_density_of(num_length_of_q45((int64_t)count << 32)),
                               num_density_of(num_integer(8192)));
}

void emitters_set(struct emitters *emitters, const struct ray_view *view)
{
    const struct tia_scene *scene = view->scene;

    emitters->count = 0;
    for (uint32_t i = 0; i < view->light_count; i++)
        if (shines(&view->view->lights[i]))
            emitter_of_light(&view->lights[i], &view->view->lights[i], &emitters->first[emitters->count++]);
    for (uint32_t i = 0; emitters->spheres && i < scene->sphere_count; i++)
        if (emits(scene, i))
            emitter_of_sphere(scene, i, &emitters->first[emitters->count++]);
    emitters->one_of = num_density_quotient(num_density_of(NUM_LENGTH_ONE), count_density(emitters->count));
}

/* Returns 1 - cos a = sin^2 a/(1 + cos a), or 0 inside the sphere; a is half the angle that the sphere subtends at a
 * distance from its centre. */
static num_unit cone_of(const struct emitter *e, num_length distance)
{
    if (distance <= e->radius)
        return 0;
    num_unit sine = num_fraction(e->radius, distance), square = num_times(sine, sine);
    return num_fraction(square / 2, NUM_UNIT_ONE / 2 + num_unit_sqrt(NUM_UNIT_ONE - square) / 2);
}

struct num_density emitter_density(const struct emitter *e, struct num_point from, struct num_dir to,
                                   num_length distance)
{
    if (e->kind == EMITTER_SPHERE) {
        num_unit open = cone_of(e, num_norm(num_point_sub(e->centre, from)));
        return open <= 0 ? num_density_of(0)
                         : num_density_quotient(num_density_of(NUM_LENGTH_ONE / 2), num_density_of_unit(open));
    }
    num_unit cosine = num_dir_dot(to, e->light->direction);
    struct num_density d = num_density_of(distance);
    return num_density_quotient(num_density_product(pi(), num_density_product(d, d)),
                                num_density_product(e->area, num_density_of_unit(cosine < 0 ? -cosine : cosine)));
}

/* Returns a direction in the cone. Its angle b to the axis has 1 - cos b = open u = h, and sin b = sqrt(2 h - h^2). */
static struct num_dir within_cone(struct num_dir axis, num_unit open, const uint32_t u[2])
{
    num_unit h = num_times(open, num_unit_of_u32(u[0])), r = num_unit_sqrt(2 * num_times(h, NUM_UNIT_ONE - h / 2));
    int64_t s, c;

    tia_sample_turn(u[1], &s, &c);
    return ray_around(
        axis, (struct num_dir){num_times(r, num_unit_of_q62(c)), num_times(r, num_unit_of_q62(s)), NUM_UNIT_ONE - h});
}

static bool place_on_sphere(const struct emitter *e, struct num_point from, const uint32_t u[2],
                            struct num_point *place, struct num_dir *normal)
{
    struct num_point way = num_point_sub(e->centre, from);
    num_unit open = cone_of(e, num_norm(way));
    struct ray ray = {.origin = from};
    num_length t;

    if (open <= 0 || !num_normalise(way, &ray.direction))
        return false;
    ray.direction = within_cone(ray.direction, open, u);
    if (!sphere_intersect(e->centre, e->radius, &ray, NUM_LENGTH_MAX, &t))
        t = num_point_dot(way, ray.direction);
    *place = num_point_at(from, ray.direction, t);
    return num_normalise(num_point_sub(*place, e->centre), normal);
}

static bool sample_point(const struct emitter *e, struct num_point from, struct num_dir facing,
                         struct emitter_sample *s)
{
    struct ray_sample sample;
    struct ray_aim aim;
    struct ray shadow;

    ray_light_aim(&aim, e->light, from, facing, 0);
    if (!ray_light_sample(&aim, 0, &sample) || !ray_light_shadow(e->light, &sample, from, &shadow, &s->distance))
        return false;
    s->to = shadow.direction;
    for (int c = 0; c < 3; c++)
        s->radiance[c] = num_product_within(e->radiance[c], sample.factor);
    s->density = num_density_of(0);
    return true;
}

bool emitter_sample(const struct emitter *e, struct num_point from, struct num_dir facing, num_length bias,
                    const uint32_t u[2], struct emitter_sample *s)
{
    struct num_point place;
    struct num_dir normal;

    if (e->kind == EMITTER_POINT)
        return sample_point(e, from, facing, s);
    if (e->kind == EMITTER_PLANE) {
        place = place_on_plane(e->light, u);
        bool front = num_point_dot(num_point_sub(from, place), e->light->direction) >= 0;
        normal = front ? e->light->direction : num_dir_negated(e->light->direction);
    } else if (!place_on_sphere(e, from, u, &place, &normal)) {
        return false;
    }
    struct num_point way = num_point_sub(num_point_at(place, normal, bias), from);
    s->distance = num_norm(way);
    if (!num_normalise(way, &s->to) || num_dir_dot(s->to, normal) >= 0)
        return false;
    for (int c = 0; c < 3; c++)
        s->radiance[c] = e->radiance[c];
    s->density = emitter_density(e, from, s->to, s->distance);
    return true;
}
