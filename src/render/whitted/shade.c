#include "shade.h"

#include "observe.h"
#include "render/trace/texture.h"
#include "scene/colour.h"

void path_hash_word(struct path *path, uint32_t word)
{
    for (int i = 0; path->hashed && i < 4; i++)
        path->hash = (path->hash ^ (word >> (8 * i) & 0xff)) * UINT32_C(16777619);
}

static void look_up(struct path *path, uint32_t texture, const num_length uv[2], num_length value[])
{
    const struct tia_texture *t = &path->view->scene->textures[texture - 1];
    uint32_t number = ray_texture(t, uv, value);

    if (ray_texture_is_hashed(t))
        path_hash_word(path, number);
}

static void texture(struct path *path, const struct hit *hit, struct shading *s)
{
    const struct tia_material *m = s->material;
    bool is_coloured = m->texture && !colour_is_black(&m->colour);
    num_length uv[2], texel[3];

    ray_rgb(&m->colour, s->colour);
    s->opacity = NUM_LENGTH_ONE;
    if (!is_coloured && !m->opacity)
        return;
    ray_uv(path->view, hit, s->point, uv);
    if (is_coloured) {
        look_up(path, m->texture, uv, texel);
        for (int c = 0; c < 3; c++)
            s->colour[c] = num_product(s->colour[c], texel[c]);
    }
    if (m->opacity)
        look_up(path, m->opacity, uv, &s->opacity);
}

void shade_prepare(struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s)
{
    const struct ray_view *view = path->view;
    struct surface surface;

    path_hash_word(path, hit->object);
    path_hash_word(path, hit->element);
    s->object = hit->object;
    s->material = &view->scene->materials[ray_material(view, hit->object, hit->element)];
    s->point = num_point_at(ray->origin, ray->direction, hit->t);
    s->viewer = num_dir_negated(ray->direction);
    ray_surface(view, hit, s->point, &surface);
    s->back = num_dir_dot(surface.normal, s->viewer) < 0;
    s->geometric = s->back ? num_dir_negated(surface.normal) : surface.normal;
    s->outside = num_point_at(s->point, s->geometric, view->bias);
    s->normal = s->back ? num_dir_negated(surface.smooth) : surface.smooth;
    s->facing = num_dir_dot(s->normal, s->viewer);
    texture(path, hit, s);
}

/* max(0, R.L)^exponent with R = 2 (N.V) N - V. */
static num_length highlight(const struct shading *s, struct num_dir to, num_unit lambert)
{
    num_unit half = num_times(s->facing, lambert) - num_dir_dot(s->viewer, to) / 2;

    if (half <= 0)
        return 0;
    return num_length_of_unit(num_power(half < NUM_UNIT_ONE / 2 ? 2 * half : NUM_UNIT_ONE, s->material->exponent));
}

/* What the material reflects of light from `to` towards the viewer. */
static void reflectance(const struct shading *s, struct num_dir to, num_unit lambert, num_length rgb[3])
{
    const struct tia_rgb *specular = &s->material->specular;
    num_length glossy[3], shine;

    for (int c = 0; c < 3; c++)
        rgb[c] = num_times(s->colour[c], lambert);
    if (colour_is_black(specular))
        return;
    ray_rgb(specular, glossy);
    shine = highlight(s, to, lambert);
    for (int c = 0; c < 3; c++)
        rgb[c] += num_product(glossy[c], shine);
}

/* How much of a sample's light gets to the point; false: none. `bit` is its number in path->lit. */
static bool arrives(const struct path *path, const struct shading *s, const struct ray_light *light,
                    const struct ray_sample *sample, unsigned bit, uint32_t *blocker, num_length through[3])
{
    struct ray shadow;
    num_length distance;

    if (path->known && !(path->lit.bits >> bit & 1))
        return false;
    bool partly = path->known && path->lit.shares;
    num_length part = partly ? num_length_of_q45((int64_t)path->lit.shares[bit] << 30) : NUM_LENGTH_ONE;
    through[0] = through[1] = through[2] = part;
    if ((path->known && !path->first->passes) || !ray_light_shadow(light, sample, s->outside, &shadow, &distance))
        return true;
    shadow.tests = path->tests;
    return path->known ? path->first->passes(path->first, &shadow, distance, blocker)
                       : ray_transmittance(path->view, &shadow, distance, blocker, through);
}

/* Adds what arrives of a light's sample i to the mean of the samples, which the emission multiplies later; false:
 * nothing arrives. */
static bool add_sample(struct path *path, const struct shading *s, const struct ray_aim *aim, unsigned i, unsigned bit,
                       uint32_t *blocker, num_length mean[3])
{
    struct ray_sample sample;
    num_length through[3], rgb[3];

    if (!ray_light_sample(aim, i, &sample))
        return false;
    num_unit lambert = num_dir_dot(s->normal, sample.to);
    if (lambert <= 0 || num_dir_dot(s->geometric, sample.to) <= 0)
        return false;
    bool reached = arrives(path, s, aim->light, &sample, bit, blocker, through);
    if (path->observer)
        observe_shadow(path, &(struct observed_shadow){s->object, s->outside, s->normal, aim->light, &sample, reached});
    if (!reached)
        return false;
    reflectance(s, sample.to, lambert, rgb);
    for (int c = 0; c < 3; c++)
        mean[c] += num_times(num_product_within(num_product(rgb[c], through[c]), sample.factor), 32 * aim->light->part);
    return true;
}

static void note_reached(struct path *path, bool reached)
{
    if (path->next_reached < PATH_REACHED)
        path->reached |= (uint64_t)reached << path->next_reached++;
}

static void add_light(struct path *path, const struct shading *s, uint32_t n, num_length own[3])
{
    const struct ray_light *light = &path->view->lights[n];
    uint32_t *blocker = &path->blocker[n % PATH_BLOCKERS];
    unsigned bit = path->known ? path->first->first_bit[n] : 0, step = path->known && !path->first->whole;
    num_length mean[3] = {0, 0, 0};
    struct ray_aim aim;

    if (light->kind == TIA_AMBIENT_LIGHT) {
        for (int c = 0; c < 3; c++)
            own[c] = num_sum_within(own[c], num_product(s->colour[c], light->emission[c]));
        return;
    }
    ray_light_aim(&aim, light, s->point, path->class);
    for (unsigned i = 0; i < light->samples && !path_stops(path); i++) {
        bool reached = add_sample(path, s, &aim, i, bit + step * i, blocker, mean);
        path_hash_word(path, reached);
        note_reached(path, reached);
    }
    for (int c = 0; c < 3; c++)
        own[c] = num_sum_within(own[c], num_product_within(mean[c], light->emission[c]));
}

void shade_light(struct path *path, const struct shading *s, const num_length throughput[3], num_length colour[3])
{
    num_length own[3], facing[3];

    if (s->opacity == 0)
        return;
    ray_rgb(&s->material->emission, own);
    ray_rgb(&s->material->facing, facing);
    for (int c = 0; c < 3 && s->facing > 0; c++)
        own[c] += num_times(facing[c], s->facing);
    for (uint32_t n = 0; n < path->view->light_count; n++)
        add_light(path, s, n, own);
    for (int c = 0; c < 3; c++) {
        if (s->opacity < NUM_LENGTH_ONE)
            own[c] = num_product_within(own[c], s->opacity);
        colour[c] = num_sum_within(colour[c], num_product_within(own[c], throughput[c]));
    }
}

/* Snell's law with q = n2/(4 n1), c = N.V and the sines s of V and s n1/n2 of the refracted direction T:
 *
 *     n2/n1 T = -V + (c - sqrt((n2/n1)^2 - s^2)) N,   in quarters  -V/4 + (c/4 - root) N,
 *     root = sqrt(q^2 - s^2/16)
 *
 * and nothing is refracted where there is no root, nor where an interpolated normal is turned away: there Rs = Rp = 1,
 * which in integers would be a little less. Returns F, what Fresnel's equations say is reflected:
 * with n2/n1 cos T = 4 root,
 *
 *     Rs = (c - n2/n1 cos T)/(c + ...)          = (c/4 - root)/(c/4 + root)
 *     Rp = (n2/n1 c - cos T)/(n2/n1 c + cos T)  = (q^2 c - root/4)/(q^2 c + root/4).
 *
 * q is at most 1: where n2 > 4 n1, which is less than 16 n1, all is in sixteenths. */
static num_unit refract(const struct shading *s, struct boundary between, struct num_dir *refracted)
{
    const num_length parts = between.to <= 4 * between.from ? 4 : 16;
    num_unit q = num_fraction(num_length_of(between.to), parts * num_length_of(between.from));
    num_unit c = s->facing, square = num_times(q, q);
    num_unit inside = square - (NUM_UNIT_ONE - num_times(c, c)) / (parts * parts);

    if (inside <= 0 || c <= 0)
        return NUM_UNIT_ONE;
    num_unit root = num_unit_sqrt(inside), bend = c / parts - root, q2c = num_times(square, c);
    struct num_dir part = {-s->viewer.x / parts, -s->viewer.y / parts, -s->viewer.z / parts};
    num_unit rs = num_fraction(bend, c / parts + root), rp = num_fraction(q2c - root / parts, q2c + root / parts);

    *refracted = num_dir_normalised(num_dir_add(part, num_dir_scaled(s->normal, bend)));
    return num_times(rs, rs) / 2 + num_times(rp, rp) / 2;
}

static struct ray straight_on(const struct ray_view *view, const struct shading *s)
{
    return (struct ray){num_point_at(s->point, s->viewer, -view->bias), num_dir_negated(s->viewer), NULL};
}

/* The refracted ray. Returns how much of it is reflected instead. */
static num_unit pass(const struct ray_view *view, const struct shading *s, struct bounces *b)
{
    const struct tia_material *m = s->material;
    struct boundary between = media_cross(view, &b->media, s->object, m, s->back);

    b->straight = between.from == between.to || colour_is_black(&m->refraction);
    b->refracted = straight_on(view, s);
    if (b->straight)
        return 0;
    b->refracted.origin = num_point_at(s->point, s->geometric, -view->bias);
    num_unit fresnel = refract(s, between, &b->refracted.direction);
    return m->fresnel || fresnel == NUM_UNIT_ONE ? fresnel : 0;
}

/* The surface is there to the part of its opacity. */
static void let_past(const struct ray_view *view, const struct shading *s, struct bounces *b)
{
    num_length *passes = b->straight ? b->refracts : b->passes;

    b->past = straight_on(view, s);
    for (int c = 0; c < 3; c++) {
        b->reflects[c] = num_product(b->reflects[c], s->opacity);
        b->refracts[c] = num_product(b->refracts[c], s->opacity);
        passes[c] += NUM_LENGTH_ONE - s->opacity;
    }
}

static bool is_zero(const num_length rgb[3])
{
    return rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0;
}

void shade_bounce(const struct ray_view *view, const struct shading *s, const struct media *media, struct bounces *b)
{
    const struct tia_material *m = s->material;

    ray_rgb(&m->mirror, b->reflects);
    ray_rgb(&m->refraction, b->refracts);
    b->media = *media;
    b->straight = false;
    b->passes[0] = b->passes[1] = b->passes[2] = 0;
    if (!colour_is_black(&m->refraction) || s->opacity < NUM_LENGTH_ONE) {
        num_unit fresnel = pass(view, s, b);
        for (int c = 0; c < 3; c++) {
            num_length back = num_times(b->refracts[c], fresnel);
            b->reflects[c] += back;
            b->refracts[c] -= back;
        }
    }
    if (s->opacity < NUM_LENGTH_ONE)
        let_past(view, s, b);
    if (is_zero(b->reflects))
        return;
    b->reflected.origin = s->outside;
    b->reflected.tests = NULL;
    struct num_dir half = {-s->viewer.x / 2, -s->viewer.y / 2, -s->viewer.z / 2};
    b->reflected.direction = num_dir_normalised(num_dir_add(num_dir_scaled(s->normal, s->facing), half)); /* R/2 */
}
