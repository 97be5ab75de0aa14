#include "oracle.h"

#include "rays.h"

static const struct oracle_variant as_tia = {.bias = ORACLE_BIAS};

/* Returns a unit vector, rounded to the variant's number of bits. */
static struct oracle_vec rounded(struct oracle_variant variant, struct oracle_vec v)
{
    double one = ldexp(1, (int)variant.direction_bits);

    if (!variant.direction_bits)
        return v;
    return (struct oracle_vec){nearbyint(v.x * one) / one, nearbyint(v.y * one) / one, nearbyint(v.z * one) / one};
}

struct oracle_vec oracle_direction(const struct tia_camera *camera, unsigned width, unsigned height, double x, double y)
{
    double a = tan(radians(camera->fov) / 2.0);
    double w = width, h = height;
    struct oracle_vec d = {(2.0 * (x + 0.5) / w - 1.0) * a * w / h, (1.0 - 2.0 * (y + 0.5) / h) * a, -1.0};

    return unit(d);
}

bool oracle_sphere_geometric(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                             double radius, double *t)
{
    struct oracle_vec l = sub(centre, origin);
    double tca = dot(l, direction);

    if (tca < 0)
        return false;
    struct oracle_vec perpendicular = along(l, -tca, direction);
    double d2 = dot(perpendicular, perpendicular);
    if (d2 > radius * radius)
        return false;
    double thc = sqrt(radius * radius - d2);
    double t0 = tca - thc, t1 = tca + thc;
    *t = t0 < 0 ? t1 : t0;
    return true;
}

bool oracle_sphere_analytic(struct oracle_vec origin, struct oracle_vec direction, struct oracle_vec centre,
                            double radius, double *t)
{
    struct oracle_vec o = sub(origin, centre);
    double a = dot(direction, direction);
    double b = 2.0 * dot(direction, o);
    double c = dot(o, o) - radius * radius;
    double discriminant = b * b - 4.0 * a * c;

    if (discriminant < 0)
        return false;
    double t0 = (-b - sqrt(discriminant)) / (2.0 * a);
    double t1 = (-b + sqrt(discriminant)) / (2.0 * a);
    if (t1 < 0)
        return false;
    *t = t0 < 0 ? t1 : t0;
    return true;
}

unsigned oracle_bayer(unsigned x, unsigned y)
{
    static const unsigned quadrant[2][2] = {{0, 2}, {3, 1}};
    unsigned value = 0;

    /* the bits of x and y, the lowest first, select a quadrant in each step from M(1) to M(8) */
    for (unsigned bit = 0; bit < 3; bit++)
        value += quadrant[y >> bit & 1][x >> bit & 1] << (4 - 2 * bit);
    return value;
}

static bool meets(struct oracle_variant variant, struct ray ray, const struct tia_sphere *sphere, double *t)
{
    return (variant.quadratic ? oracle_sphere_analytic : oracle_sphere_geometric)(
        ray.origin, ray.direction, position(sphere->centre), q16(sphere->radius), t);
}

/* True if b is in the ball around a or, with `on`, on it. The result is exact. */
static bool is_in(struct tia_vec3 a, tia_q16 radius, struct tia_vec3 b, bool on)
{
    int64_t x = (int64_t)a.x - b.x, y = (int64_t)a.y - b.y, z = (int64_t)a.z - b.z;

    uint64_t square = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z),
             most = (uint64_t)radius * (uint64_t)radius;

    return square < most || (on && square == most);
}

/* True if the eye is in the ball, but not on it. */
static bool is_around_eye(const struct tia_scene *scene, struct tia_vec3 centre, tia_q16 radius)
{
    return is_in(centre, radius, scene->camera.eye, false);
}

/* Returns the distance at which a ray leaves a sphere around its origin: the larger root. */
static double leaves(struct ray ray, struct oracle_vec centre, double radius)
{
    struct oracle_vec l = sub(centre, ray.origin);
    double tca = dot(l, ray.direction);
    struct oracle_vec perpendicular = along(l, -tca, ray.direction);

    return tca + sqrt(radius * radius - dot(perpendicular, perpendicular));
}

/* Returns the nearest sphere on the ray; of equally near ones, that of the lowest index. *t is the distance, infinite
 * without a sphere. */
static uint32_t nearest_sphere(const struct tia_scene *scene, struct oracle_variant variant, struct ray ray, double *t)
{
    uint32_t nearest = TIA_NO_OBJECT;
    double d;

    *t = INFINITY;
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        bool around = is_around_eye(scene, s->centre, s->radius);
        if (around)
            d = leaves(ray, position(s->centre), q16(s->radius));
        if ((around || meets(variant, ray, s, &d)) && d < *t) {
            *t = d;
            nearest = i;
        }
    }
    return nearest;
}

/* Returns the nearest light that is nearer than *t, and sets *t to its distance; TIA_NO_OBJECT if there is none. A
 * light of radius 0 is invisible. */
static uint32_t nearest_light(const struct tia_scene *scene, struct ray ray, double *t)
{
    uint32_t nearest = TIA_NO_OBJECT;
    double d;

    for (uint32_t i = 0; i < scene->light_count; i++) {
        const struct tia_light *l = &scene->lights[i];
        struct oracle_vec centre = position(l->centre);
        bool around = is_around_eye(scene, l->centre, l->radius);
        if (around)
            d = leaves(ray, centre, q16(l->radius));
        if (l->radius > 0 &&
            (around || oracle_sphere_geometric(ray.origin, ray.direction, centre, q16(l->radius), &d)) && d < *t) {
            *t = d;
            nearest = i;
        }
    }
    return nearest;
}

/* Returns the fraction of white light that is transmitted along the ray to a light at `distance`. A ball around the eye
 * filters all lights outside of it. *passed is the sum of index + 1 over the spheres on the way. */
static struct colour transmission(const struct tia_scene *scene, struct oracle_variant variant, struct ray ray,
                                  const struct tia_light *light, double distance, uint32_t *passed)
{
    struct colour left = {{1.0, 1.0, 1.0}};
    double d;

    *passed = 0;
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        bool blocks = is_around_eye(scene, s->centre, s->radius)
                          ? !is_in(s->centre, s->radius, light->centre, true)
                          : meets(variant, ray, s, &d) && (d < distance || variant.beyond_light);
        if (blocks) {
            const struct tia_material *material = &scene->materials[s->material];
            *passed += i + 1;
            left = product(left, rgb(variant.colour_passes ? material->colour : material->transmission));
        }
    }
    return left;
}

/* Adds the light of one light at a surface's point p with the normal n. True if any light arrives. *passed is that of
 * transmission(). */
static bool add_light(const struct tia_scene *scene, struct oracle_variant variant, const struct tia_light *light,
                      struct oracle_vec p, struct oracle_vec n, struct colour surface, double sum[3], uint32_t *passed)
{
    struct oracle_vec way = sub(position(light->centre), p);
    double distance = length(way);
    struct oracle_vec ldir = rounded(variant, divide(way, distance));
    double cosine = dot(n, ldir);

    if (!(cosine > 0))
        return false;
    struct colour left =
        transmission(scene, variant, (struct ray){along(p, variant.bias, n), ldir}, light, distance, passed);
    struct colour emission = rgb(light->emission);
    for (int c = 0; c < 3; c++)
        sum[c] += surface.channel[c] * left.channel[c] * cosine * emission.channel[c];
    return !is_black(left);
}

static void shade(const struct tia_scene *scene, struct oracle_variant variant, struct ray ray,
                  struct oracle_pixel *pixel)
{
    const struct tia_sphere *s = &scene->spheres[pixel->object];
    const struct tia_material *material = &scene->materials[s->material];
    struct oracle_vec p = along(ray.origin, pixel->depth, ray.direction);
    double out = is_around_eye(scene, s->centre, s->radius) ? -1 : 1;
    struct oracle_vec n = rounded(variant, divide(sub(p, position(s->centre)), out * q16(s->radius)));
    struct colour emission = rgb(material->emission);

    for (uint32_t i = 0; i < scene->light_count; i++) {
        uint32_t passed;
        bool lit = add_light(scene, variant, &scene->lights[i], p, n, rgb(material->colour), pixel->linear, &passed);
        if (lit && i < 16)
            pixel->path_hash = (pixel->path_hash + (passed * (i + 1) << 16)) | UINT32_C(1) << i;
    }
    for (int c = 0; c < 3; c++)
        pixel->linear[c] += emission.channel[c];
}

static void set_linear(struct oracle_pixel *pixel, struct colour colour)
{
    for (int c = 0; c < 3; c++)
        pixel->linear[c] = colour.channel[c];
}

/* Returns floor(levels c + threshold) of a channel clamped to [0, 1]. */
static unsigned quantise(double linear, double levels, double threshold, double *margin)
{
    double clamped = linear < 0 ? 0 : linear > 1 ? 1 : linear;
    double value = levels * clamped + threshold;

    *margin = fmin(*margin, fabs(value - nearbyint(value)));
    return (unsigned)floor(value);
}

tia_rgb565 oracle_pack(struct oracle_pixel *pixel, unsigned x, unsigned y, bool dither)
{
    double threshold = dither ? (oracle_bayer(x, y) + 0.5) / 64.0 : 0.5;

    pixel->margin = 1;
    unsigned r = quantise(pixel->linear[0], 31, threshold, &pixel->margin);
    unsigned g = quantise(pixel->linear[1], 63, threshold, &pixel->margin);
    unsigned b = quantise(pixel->linear[2], 31, threshold, &pixel->margin);
    pixel->colour = (tia_rgb565)(r << 11 | g << 5 | b);
    return pixel->colour;
}

static struct oracle_pixel spheres_look(const struct tia_scene *scene, struct oracle_variant variant, unsigned width,
                                        unsigned height, double x, double y)
{
    struct ray ray = {position(scene->camera.eye),
                      rounded(variant, oracle_direction(&scene->camera, width, height, x, y))};
    struct oracle_pixel pixel = {0};

    pixel.sphere = nearest_sphere(scene, variant, ray, &pixel.depth);
    uint32_t light = nearest_light(scene, ray, &pixel.depth);
    pixel.object = light == TIA_NO_OBJECT ? pixel.sphere : scene->sphere_count + light;
    if (light != TIA_NO_OBJECT) {
        pixel.path_hash = UINT32_C(0xffff0000) + light;
        set_linear(&pixel, rgb(scene->lights[light].emission));
    } else if (pixel.object == TIA_NO_OBJECT) {
        set_linear(&pixel, rgb(scene->background));
    } else {
        shade(scene, variant, ray, &pixel);
    }
    return pixel;
}

struct oracle_pixel oracle_look(const struct tia_scene *scene, unsigned width, unsigned height, double x, double y)
{
    return oracle_needs_rays(scene) ? oracle_rays_look(scene, width, height, x, y)
                                    : spheres_look(scene, as_tia, width, height, x, y);
}

struct oracle_pixel oracle_variant_pixel(const struct tia_scene *scene, struct oracle_variant variant, unsigned width,
                                         unsigned height, unsigned x, unsigned y)
{
    struct oracle_pixel pixel = spheres_look(scene, variant, width, height, x, y);

    (void)oracle_pack(&pixel, x, y, false);
    return pixel;
}

struct oracle_pixel oracle_pixel(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                                 bool dither)
{
    struct oracle_pixel pixel = oracle_look(scene, width, height, x, y);

    (void)oracle_pack(&pixel, x, y, dither);
    return pixel;
}

bool oracle_undecided(const struct tia_scene *scene, unsigned width, unsigned height, unsigned x, unsigned y,
                      double reach)
{
    struct oracle_pixel here = oracle_look(scene, width, height, x, y);

    for (int i = 0; i < 9; i++) {
        double u = x + (i % 3 - 1) * reach, v = y + (i / 3 - 1) * reach;
        struct oracle_pixel near = oracle_look(scene, width, height, u, v);
        if (near.object != here.object || near.sphere != here.sphere || near.path_hash != here.path_hash)
            return true;
    }
    return false;
}
