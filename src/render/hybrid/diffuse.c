#include "diffuse.h"

#include "math/rotation.h"
#include "math/wide.h"
#include "raster/distance.h"
#include "raster_view.h"
#include "scene/colour.h"

#define RAY_BITS 24
#define NORMAL_BITS 20
#define MOST_BITS 38
#define UNCERTAIN_SHIFT 14 /* the error bound of N.w/|w| is 2^-14 */
#define NEAREST (INT64_C(1) << 20)
#define NEARNESS_LEAST (UINT64_C(1) << 47) /* nearness has an error of up to 2^15, and is clamped to 2^62 */
#define NEARNESS_MOST ((UINT64_C(1) << 62) - 65536)

static int64_t size_of(int64_t a)
{
    return a < 0 ? -a : a;
}

static int64_t largest(const int64_t v[3])
{
    int64_t x = size_of(v[0]), y = size_of(v[1]), z = size_of(v[2]);

    x = x > y ? x : y;
    return x > z ? x : z;
}

/* ---- the lights ---- */

static void emission_of(const struct tia_light *light, int32_t rgb[3])
{
    rgb[0] = light->emission.r;
    rgb[1] = light->emission.g;
    rgb[2] = light->emission.b;
}

static bool place_light(const struct diffuse *m, const struct tia_light *light, int64_t at[3])
{
    const int64_t centre[3] = {light->centre.x, light->centre.y, light->centre.z};

    for (int i = 0; i < 3; i++)
        at[i] = tia_round_shift(centre[i] * 65536 - m->flat->eye.origin[i], (unsigned)(32 - m->bits));
    return largest(at) < INT64_C(1) << MOST_BITS;
}

static void direct_light(const struct tia_light *light, int64_t to[3])
{
    const int64_t back[3] = {-(int64_t)light->direction.x, -(int64_t)light->direction.y, -(int64_t)light->direction.z};

    (void)wide_normalise(back, to);
    for (int i = 0; i < 3; i++)
        to[i] = tia_round_shift(to[i], 32);
}

static void aim_spot(const struct tia_light *light, struct diffuse_light *l)
{
    const int64_t uncertain = INT64_C(1) << (30 - UNCERTAIN_SHIFT);
    int64_t sine, cosine;

    direct_light(light, l->back);
    for (int i = 0; i < 3; i++)
        l->back[i] = tia_round_shift(l->back[i], 30 - NORMAL_BITS);
    tia_sincos(light->inner, &sine, &cosine);
    l->inner = (cosine >> 32) + uncertain;
    tia_sincos(light->outer, &sine, &cosine);
    l->outer = (cosine >> 32) - uncertain;
}

/* Adds a light. Returns false if it is visible, attenuated, too far away or has an area: such lights need rays. */
static bool add_light(struct diffuse *m, const struct tia_light *light, unsigned bit)
{
    struct diffuse_light *l = &m->lights[m->light_count++];

    l->kind = light->kind;
    l->bit = bit;
    emission_of(light, l->emission);
    if (!tia_light_has(light->kind, TIA_LIGHT_TECHNIQUES))
        return false;
    if (tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE))
        return true;
    if (tia_light_has(light->kind, TIA_LIGHT_FAR)) {
        direct_light(light, l->at);
        return true;
    }
    if (tia_light_has(light->kind, TIA_LIGHT_CONE))
        aim_spot(light, l);
    return !tia_light_has(light->kind, TIA_LIGHT_AREA) && !light->radius && !light->constant && !light->linear &&
           !light->quadratic && place_light(m, light, l->at);
}

/* Chooses the unit of positions, 2^-bits. Positions are up to 2^(range + 10), and coordinates of P below 2^15. */
static void choose_unit(struct diffuse *m)
{
    int range = m->flat->bits - m->flat->grid.fraction, most;

    m->bits = MOST_BITS - 10 - range;
    most = m->bits + 15;
    m->most = INT64_C(1) << (most < MOST_BITS ? most : MOST_BITS);
}

/* True if this build's arithmetic is precise enough: with a mantissa of 24 bits, errors exceed the bounds. */
static bool is_fine(void)
{
    return num_length_of_q45(INT32_C(1) << 15) + NUM_LENGTH_ONE > NUM_LENGTH_ONE;
}

bool diffuse_init(struct diffuse *m, const struct tia_view *view, const struct tia_shadow_view *shadow,
                  const uint8_t *first_bit)
{
    m->rays = view->prepared;
    m->flat = &shadow->flat;
    m->light_count = 0;
    m->row_y = -1;
    m->face.face = TIA_NO_FACE;
    if (!is_fine() || m->flat->eye.projection == TIA_ORTHOGRAPHIC || tia_flat_samples(view->scene) > 1 ||
        view->light_count > DIFFUSE_LIGHTS)
        return false;
    choose_unit(m);
    tia_world_init(&m->world, m->flat);
    for (uint32_t n = 0; n < view->light_count; n++)
        if (!add_light(m, &view->lights[n], first_bit[n]))
            return false;
    return true;
}

/* ---- faces ---- */

/* Returns floor(2^20 a). */
static int64_t digits(num_unit a)
{
    num_length scaled = num_times(num_integer(INT32_C(1) << 17), a);
    int32_t whole = num_floor(scaled);

    return (int64_t)whole * 8 + num_floor((scaled - num_integer(whole)) * 8);
}

static bool is_diffuse(const struct tia_material *m)
{
    return !m->texture && !m->opacity && !m->bump && colour_is_black(&m->specular) && colour_is_black(&m->mirror) &&
           colour_is_black(&m->refraction) && colour_is_black(&m->facing);
}

static void look_up(struct diffuse *m, uint32_t face)
{
    const struct tia_flat_object *object = tia_flat_object_of(m->flat, face);
    const struct tia_scene *scene = m->rays->scene;
    uint32_t element = tia_flat_element_of(m->flat, face);
    struct surface surface;

    m->face = (struct diffuse_face){.face = face};
    if (object->divided || raster_is_smooth(scene, object, element))
        return;
    m->face.material = &scene->materials[ray_material(m->rays, object->object, element)];
    m->face.fits = is_diffuse(m->face.material);
    if (!m->face.fits)
        return;
    const struct hit hit = {.object = object->object, .element = element, .light = TIA_NO_OBJECT};
    ray_surface(m->rays, &hit, m->rays->camera.eye, &surface);
    m->face.normal[0] = digits(surface.normal.x);
    m->face.normal[1] = digits(surface.normal.y);
    m->face.normal[2] = digits(surface.normal.z);
}

/* ---- positions ---- */

static void begin_row(struct diffuse *m, int y)
{
    for (int i = 0; i < 3; i++) {
        m->row[i] = m->world.first[i] + y * m->world.down[i];
        m->right[i] = m->world.right[i];
    }
    m->row_y = y;
}

/* Returns D, from nearness = w 2^scale/(D 2^fraction), or 0 if it is too far. */
static int64_t distance_of(const struct diffuse *m, uint64_t nearness)
{
    const struct tia_raster_grid *l = &m->flat->grid;
    unsigned zeros = tia_clz64(nearness);
    uint64_t product = (uint64_t)l->w * tia_reciprocal((uint32_t)(nearness << zeros >> 32));
    int shift = 95 - (int)zeros - l->scale + l->fraction - m->bits;

    return shift < 0 || shift > 63 ? 0 : (int64_t)(product >> shift);
}

static bool find_place(const struct diffuse *m, const struct diffuse_pixel *p, int64_t *distance, int64_t at[3])
{
    if (p->nearness < NEARNESS_LEAST || p->nearness > NEARNESS_MOST)
        return false;
    *distance = distance_of(m, p->nearness);
    if (!*distance || *distance >= m->most / 4)
        return false;
    for (int i = 0; i < 3; i++) {
        int64_t r = (m->row[i] + p->x * m->right[i]) >> (TIA_DISTANCE_BITS - RAY_BITS);
        if (size_of(r) >= INT64_C(4) << RAY_BITS)
            return false;
        at[i] = (r * *distance) >> RAY_BITS;
    }
    return largest(at) < m->most;
}

static int64_t dot(const int64_t n[3], const int64_t v[3])
{
    return n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
}

/* Turns the face's normal to the eye. Returns false if the eye may be in the face's plane. */
static bool turn(struct diffuse *m, const int64_t at[3])
{
    int64_t side = dot(m->face.normal, at);

    if (size_of(side) >> 8 <= largest(at))
        return false;
    for (int i = 0; i < 3 && side > 0; i++)
        m->face.normal[i] = -m->face.normal[i];
    return true;
}

/* ---- colours ---- */

/* Returns max(0, N.w/|w|), Q.30, or a negative number if it is uncertain. */
static int64_t cosine_of(const int64_t normal[3], const int64_t w[3], int64_t distance)
{
    int64_t most = largest(w), facing = dot(normal, w);

    if (most < NEAREST || most < distance >> 6)
        return -1;
    if (facing <= 0)
        return 0;
    int cut = 33 - (int)tia_clz64((uint64_t)most);
    uint64_t square = 0;
    for (int i = 0; i < 3; i++) {
        int64_t part = cut > 0 ? w[i] >> cut : w[i];
        square += (uint64_t)(part * part);
    }
    unsigned up = tia_clz64(square) & ~1u;
    uint64_t y = tia_rsqrt(square << up); /* 2^31/sqrt(square 2^(up - 64)) */
    unsigned down = tia_clz64((uint64_t)facing) < 32 ? 32 - tia_clz64((uint64_t)facing) : 0;
    int shift = 63 - (int)(up / 2) + (cut > 0 ? cut : 0) - (int)down - 30 + NORMAL_BITS;
    return (int64_t)(((uint64_t)facing >> down) * y >> shift);
}

static int64_t lambert(const struct diffuse *m, const struct diffuse_light *l, const int64_t at[3], int64_t distance)
{
    if (tia_light_has(l->kind, TIA_LIGHT_FAR)) {
        int64_t facing = dot(m->face.normal, l->at);
        return facing > 0 ? facing >> NORMAL_BITS : 0;
    }
    const int64_t w[3] = {l->at[0] - at[0], l->at[1] - at[1], l->at[2] - at[2]};
    if (tia_light_has(l->kind, TIA_LIGHT_CONE)) {
        int64_t c = cosine_of(l->back, w, distance);
        if (c < l->inner)
            return c >= 0 && c <= l->outer ? 0 : -1;
    }
    return cosine_of(m->face.normal, w, distance);
}

/* A colour, Q.30, and its error bound. */
struct diffuse_colour {
    int64_t rgb[3], uncertain[3];
};

static void add(struct diffuse_colour *c, const struct diffuse *m, const struct diffuse_light *l, int64_t part,
                bool exact)
{
    const struct tia_rgb *own = &m->face.material->colour;
    const int64_t colour[3] = {own->r, own->g, own->b};

    for (int i = 0; i < 3; i++) {
        int64_t most = colour[i] * l->emission[i] >> 30;
        c->rgb[i] += most * part >> 30;
        c->uncertain[i] += 4 + (exact ? 0 : most >> UNCERTAIN_SHIFT);
    }
}

static bool add_lights(struct diffuse_colour *c, const struct diffuse *m, const struct diffuse_pixel *p,
                       const int64_t at[3], int64_t distance)
{
    for (unsigned n = 0; n < m->light_count; n++) {
        const struct diffuse_light *l = &m->lights[n];
        if (tia_light_has(l->kind, TIA_LIGHT_EVERYWHERE)) {
            add(c, m, l, INT64_C(1) << 30, true);
            continue;
        }
        if (!(p->lit >> l->bit & 1))
            continue;
        int64_t part = lambert(m, l, at, distance);
        if (part < 0)
            return false;
        add(c, m, l, p->shares ? part * p->shares[l->bit] >> TIA_SHARE_BITS : part, false);
    }
    return true;
}

static unsigned level(int64_t q30, unsigned levels, num_u threshold)
{
    int64_t one = INT64_C(1) << 30, within = q30 < 0 ? 0 : q30 > one ? one : q30;

    return num_levels(num_length_of_q45(within * 32768), levels, threshold);
}

static bool pack(const struct diffuse_colour *c, num_u threshold, tia_rgb565 *out)
{
    static const unsigned levels[3] = {31, 63, 31};
    unsigned found[3];

    for (int i = 0; i < 3; i++) {
        found[i] = level(c->rgb[i] - c->uncertain[i], levels[i], threshold);
        if (found[i] != level(c->rgb[i] + c->uncertain[i], levels[i], threshold))
            return false;
    }
    *out = (tia_rgb565)(found[0] << 11 | found[1] << 5 | found[2]);
    return true;
}

static struct diffuse_colour colour_of(const struct tia_rgb *rgb)
{
    return (struct diffuse_colour){.rgb = {rgb->r, rgb->g, rgb->b}};
}

bool diffuse_pixel(struct diffuse *m, const struct diffuse_pixel *p, num_u threshold, tia_rgb565 *out)
{
    int64_t distance, at[3];

    if (p->face == TIA_NO_FACE) {
        struct diffuse_colour behind = colour_of(&m->rays->scene->background);
        return pack(&behind, threshold, out);
    }
    if (p->y != m->row_y)
        begin_row(m, p->y);
    if (p->face != m->face.face)
        look_up(m, p->face);
    if (!m->face.fits || !find_place(m, p, &distance, at) || !turn(m, at))
        return false;
    struct diffuse_colour c = colour_of(&m->face.material->emission);
    return add_lights(&c, m, p, at, distance) && pack(&c, threshold, out);
}
