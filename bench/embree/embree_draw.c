#include "embree_world.h"

#ifdef __x86_64__
#include <xmmintrin.h>
#endif

#define BIAS (1.0F / 8192)     /* 2^-13 */
#define DARKEST (1.0F / 65536) /* rays with less throughput are not traced */

/* A pending ray: each ray spawns two more at most, one level deeper. */
struct pending {
    struct float_ray ray;
    float throughput[3];
    unsigned depth;
};

struct pixel {
    const struct embree *embree;
    struct pending stack[EMBREE_DEPTH + 2];
    unsigned waiting;
    float colour[3];
};

struct point {
    const struct embree_material *material;
    struct vec place, outside, inside, geometric, normal, viewer;
    float facing;
    bool back;
};

static struct RTCRay ray_of(const struct float_ray *ray, float far)
{
    return (struct RTCRay){.org_x = ray->origin.x,
                           .org_y = ray->origin.y,
                           .org_z = ray->origin.z,
                           .dir_x = ray->direction.x,
                           .dir_y = ray->direction.y,
                           .dir_z = ray->direction.z,
                           .tfar = far,
                           .mask = UINT32_MAX};
}

static struct vec smooth_normal(const struct embree_face *face, float u, float v)
{
    struct vec n = vec_scaled(face->normal[0], 1 - u - v);

    return vec_unit(vec_along(vec_along(n, u, face->normal[1]), v, face->normal[2]));
}

static void find_normals(const struct embree *e, const struct RTCHit *hit, struct point *p)
{
    if (hit->geomID == EMBREE_SPHERES) {
        const float *s = e->spheres[hit->primID];
        p->geometric = vec_scaled(vec_sub(p->place, (struct vec){s[0], s[1], s[2]}), 1 / s[3]);
        p->normal = p->geometric;
    } else if (hit->geomID == EMBREE_FACES) {
        const struct embree_face *face = &e->faces[hit->primID];
        p->geometric = face->geometric;
        p->normal = face->smooth ? smooth_normal(face, hit->u, hit->v) : face->geometric;
    } else {
        p->geometric = vec_unit((struct vec){hit->Ng_x, hit->Ng_y, hit->Ng_z});
        p->normal = p->geometric;
    }
}

/* Finds the nearest hit of a ray. Returns false if there is none. */
static bool find_point(const struct embree *e, const struct float_ray *ray, struct point *p)
{
    struct embree_context context;
    struct RTCRayHit found;

    found.ray = ray_of(ray, 1e30F);
    found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcInitIntersectContext(&context.context);
    rtcIntersect1(e->scene, &context.context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    p->material = &e->materials[e->material_of[found.hit.geomID][found.hit.primID]];
    p->place = vec_along(ray->origin, found.ray.tfar, ray->direction);
    p->viewer = vec_scaled(ray->direction, -1);
    find_normals(e, &found.hit, p);
    p->back = vec_dot(p->geometric, p->viewer) < 0;
    if (p->back) {
        p->geometric = vec_scaled(p->geometric, -1);
        p->normal = vec_scaled(p->normal, -1);
    }
    p->facing = vec_dot(p->normal, p->viewer);
    p->outside = vec_along(p->place, BIAS, p->geometric);
    p->inside = vec_along(p->place, -BIAS, p->geometric);
    return true;
}

static bool is_dark(const struct embree *e, struct embree_context *context, const struct float_ray *ray, float distance)
{
    struct RTCRay shadow = ray_of(ray, distance);

    rtcInitIntersectContext(&context->context);
    context->through[0] = context->through[1] = context->through[2] = 1;
    rtcOccluded1(e->scene, &context->context, &shadow);
    return shadow.tfar < 0;
}

static void add_light(const struct embree *e, const struct point *p, const struct embree_light *light, float own[3])
{
    struct vec way = vec_sub(light->place, p->place);
    float distance = sqrtf(vec_dot(way, way)), shine = 0;
    const struct float_ray shadow = {p->outside, vec_scaled(way, 1 / distance)};
    float lambert = vec_dot(p->normal, shadow.direction);
    struct embree_context context;

    if (lambert <= 0 || vec_dot(p->geometric, shadow.direction) <= 0 || is_dark(e, &context, &shadow, distance))
        return;
    float half = 2 * p->facing * lambert - vec_dot(p->viewer, shadow.direction);
    if (p->material->shines && half > 0)
        shine = powf(half < 1 ? half : 1, p->material->exponent);
    for (int c = 0; c < 3; c++)
        own[c] += (p->material->colour[c] * lambert + p->material->specular[c] * shine) * light->emission[c] *
                  context.through[c];
}

static void follow(struct pixel *pixel, const struct pending *from, struct vec origin, struct vec direction,
                   const float part[3])
{
    struct pending *next = &pixel->stack[pixel->waiting];
    bool visible = false;

    for (int c = 0; c < 3; c++) {
        next->throughput[c] = from->throughput[c] * part[c];
        visible = visible || next->throughput[c] >= DARKEST;
    }
    next->ray = (struct float_ray){origin, direction};
    next->depth = from->depth + 1;
    pixel->waiting += visible;
}

/* Refracts the direction. Returns false on total internal reflection. */
static bool refract(const struct point *p, struct vec *direction)
{
    float index = p->back ? 1 / p->material->index : p->material->index;
    float square = index * index - (1 - p->facing * p->facing);

    if (square <= 0 || p->facing <= 0)
        return false;
    *direction = vec_unit(vec_along(vec_scaled(p->viewer, -1), p->facing - sqrtf(square), p->normal));
    return true;
}

static void bounce(struct pixel *pixel, const struct pending *from, const struct point *p)
{
    const struct embree_material *m = p->material;
    float mirror[3] = {m->mirror[0], m->mirror[1], m->mirror[2]};
    bool reflects = m->reflects;
    struct vec direction;

    if (m->refracts && refract(p, &direction)) {
        follow(pixel, from, p->inside, direction, m->refraction);
    } else if (m->refracts) {
        for (int c = 0; c < 3; c++)
            mirror[c] += m->refraction[c];
        reflects = true;
    }
    if (reflects)
        follow(pixel, from, p->outside, vec_sub(vec_scaled(p->normal, 2 * p->facing), p->viewer), mirror);
}

static void trace(struct pixel *pixel, const struct pending *now)
{
    const struct embree *e = pixel->embree;
    struct point point;
    float own[3] = {0, 0, 0};
    bool meets = find_point(e, &now->ray, &point);

    for (uint32_t i = 0; meets && i < e->given->light_count; i++)
        add_light(e, &point, &e->lights[i], own);
    for (int c = 0; c < 3; c++)
        pixel->colour[c] += (meets ? own[c] : e->background[c]) * now->throughput[c];
    if (meets && now->depth < e->depth)
        bounce(pixel, now, &point);
}

static unsigned level(float value, unsigned most)
{
    return (unsigned)((value < 0 ? 0 : value > 1 ? 1 : value) * (float)most + 0.5F);
}

static tia_rgb565 draw_pixel(const struct embree *e, struct vec eye, struct vec direction)
{
    struct pixel pixel; /* the stack is not cleared: that would take a tenth of the time */

    pixel.embree = e;
    pixel.waiting = 1;
    pixel.colour[0] = pixel.colour[1] = pixel.colour[2] = 0;
    pixel.stack[0] = (struct pending){{eye, vec_unit(direction)}, {1, 1, 1}, 0};
    while (pixel.waiting) {
        struct pending now = pixel.stack[--pixel.waiting];
        trace(&pixel, &now);
    }
    return (tia_rgb565)(level(pixel.colour[0], 31) << 11 | level(pixel.colour[1], 63) << 5 |
                        level(pixel.colour[2], 31));
}

/* Bits of MXCSR that flush denormal results and operands to zero, as Embree requires. */
#define FLUSH_TO_ZERO 0x9fc0u

static unsigned set_modes(unsigned modes)
{
#ifdef __x86_64__
    unsigned before = _mm_getcsr();
    _mm_setcsr(modes);
    return before;
#else
    return modes;
#endif
}

void embree_draw(const struct embree *e, uint16_t width, uint16_t height, tia_rgb565 *pixels)
{
    const struct tia_camera *camera = &e->given->camera;
    struct vec eye = embree_place(e->given, camera->eye);
    struct vec back = vec_unit(vec_sub(eye, embree_place(e->given, camera->reference)));
    struct vec right = vec_unit(vec_cross(float_place(camera->up), back)), up = vec_cross(back, right);
    float tall = tanf((float)camera->fov / 65536 * 3.14159265F / 360), wide = tall * width / height;
    unsigned before = set_modes(FLUSH_TO_ZERO);

    for (unsigned y = 0; y < height; y++)
        for (unsigned x = 0; x < width; x++) {
            float across = (2 * ((float)x + 0.5F) / width - 1) * wide,
                  upward = (1 - 2 * ((float)y + 0.5F) / height) * tall;
            struct vec d = vec_along(vec_along(vec_scaled(back, -1), across, right), upward, up);
            pixels[(size_t)y * width + x] = draw_pixel(e, eye, d);
        }
    (void)set_modes(before);
}
