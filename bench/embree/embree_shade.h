/* embree_shade.h - shading of points that Embree has hit, by Whitted's method in float, for all ways to trace rays:
 * inline, so that each way has it without calls. */
#ifndef BENCH_EMBREE_EMBREE_SHADE_H
#define BENCH_EMBREE_EMBREE_SHADE_H

#include "embree_world.h"

#ifdef __x86_64__
#include <xmmintrin.h>
#endif

#define BIAS (1.0F / 8192)     /* 2^-13 */
#define DARKEST (1.0F / 65536) /* rays with less throughput are not traced */

/* A point that a ray has hit. */
struct point {
    const struct embree_material *material;
    struct vec place, outside, inside, geometric, normal, viewer;
    float facing;
    bool back;
};

static inline struct RTCRay ray_of(const struct float_ray *ray, float far)
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

static inline void start_ray(struct RTCRayHit *to, const struct float_ray *ray, float far)
{
    to->ray = ray_of(ray, far);
    to->hit.geomID = to->hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

/* Finds the nearest hit of a ray. Returns false if there is none up to `far`. */
static inline bool meet_nearest(RTCScene scene, const struct float_ray *ray, float far, struct RTCRayHit *found)
{
    struct RTCIntersectContext context;

    start_ray(found, ray, far);
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, found);
    return found->hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

static inline struct vec smooth_normal(const struct embree_face *face, float u, float v)
{
    struct vec n = vec_scaled(face->normal[0], 1 - u - v);

    return vec_unit(vec_along(vec_along(n, u, face->normal[1]), v, face->normal[2]));
}

static inline void find_normals(const struct embree *e, const struct RTCHit *hit, struct point *p)
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

/* Finds the point of a hit at the distance `far` along a ray. */
static inline void find_point(const struct embree *e, const struct float_ray *ray, const struct RTCHit *hit, float far,
                              struct point *p)
{
    p->material = &e->materials[e->material_of[hit->geomID][hit->primID]];
    p->place = vec_along(ray->origin, far, ray->direction);
    p->viewer = vec_scaled(ray->direction, -1);
    find_normals(e, hit, p);
    p->back = vec_dot(p->geometric, p->viewer) < 0;
    if (p->back) {
        p->geometric = vec_scaled(p->geometric, -1);
        p->normal = vec_scaled(p->normal, -1);
    }
    p->facing = vec_dot(p->normal, p->viewer);
    p->outside = vec_along(p->place, BIAS, p->geometric);
    p->inside = vec_along(p->place, -BIAS, p->geometric);
}

/* A shadow ray to a light, and the light's part of the point's colour where nothing is between them. */
struct lighting {
    struct float_ray shadow;
    float distance, part[3];
};

/* Returns false where the light is behind the surface. */
static inline bool find_lighting(const struct point *p, const struct embree_light *light, struct lighting *to)
{
    const struct embree_material *m = p->material;
    struct vec way = vec_sub(light->place, p->place);
    float shine = 0;

    to->distance = sqrtf(vec_dot(way, way));
    to->shadow = (struct float_ray){p->outside, vec_scaled(way, 1 / to->distance)};
    float lambert = vec_dot(p->normal, to->shadow.direction);
    if (lambert <= 0 || vec_dot(p->geometric, to->shadow.direction) <= 0)
        return false;
    float half = 2 * p->facing * lambert - vec_dot(p->viewer, to->shadow.direction);
    if (m->shines && half > 0)
        shine = powf(half < 1 ? half : 1, m->exponent);
    for (int c = 0; c < 3; c++)
        to->part[c] = (m->colour[c] * lambert + m->specular[c] * shine) * light->emission[c];
    return true;
}

/* Refracts the direction. Returns false on total internal reflection. */
static inline bool refract(const struct point *p, struct vec *direction)
{
    float index = p->back ? 1 / p->material->index : p->material->index;
    float square = index * index - (1 - p->facing * p->facing);

    if (square <= 0 || p->facing <= 0)
        return false;
    *direction = vec_unit(vec_along(vec_scaled(p->viewer, -1), p->facing - sqrtf(square), p->normal));
    return true;
}

/* The rays that a point sends on: at most a refracted and a reflected one, and their parts of its colour. */
struct bounces {
    struct float_ray ray[2];
    float part[2][3];
    int count;
};

static inline void add_bounce(struct bounces *to, struct vec origin, struct vec direction, const float part[3])
{
    to->ray[to->count] = (struct float_ray){origin, direction};
    for (int c = 0; c < 3; c++)
        to->part[to->count][c] = part[c];
    to->count++;
}

static inline void find_bounces(const struct point *p, struct bounces *to)
{
    const struct embree_material *m = p->material;
    float mirror[3] = {m->mirror[0], m->mirror[1], m->mirror[2]};
    bool reflects = m->reflects;
    struct vec direction;

    to->count = 0;
    if (m->refracts && refract(p, &direction)) {
        add_bounce(to, p->inside, direction, m->refraction);
    } else if (m->refracts) {
        for (int c = 0; c < 3; c++)
            mirror[c] += m->refraction[c];
        reflects = true;
    }
    if (reflects)
        add_bounce(to, p->outside, vec_sub(vec_scaled(p->normal, 2 * p->facing), p->viewer), mirror);
}

/* Multiplies two colours. Returns false where the product is too dark to be traced. */
static inline bool scale_throughput(const float by[3], const float part[3], float to[3])
{
    bool visible = false;

    for (int c = 0; c < 3; c++) {
        to[c] = by[c] * part[c];
        visible = visible || to[c] >= DARKEST;
    }
    return visible;
}

static inline unsigned level(float value, unsigned most)
{
    return (unsigned)((value < 0 ? 0 : value > 1 ? 1 : value) * (float)most + 0.5F);
}

static inline tia_rgb565 pixel_of(const float colour[3])
{
    return (tia_rgb565)(level(colour[0], 31) << 11 | level(colour[1], 63) << 5 | level(colour[2], 31));
}

/* The eye's rays. */
struct eye_rays {
    struct vec eye, right, up, ahead;
    float tall, wide;
    unsigned width, height;
};

static inline struct eye_rays eye_rays_of(const struct tia_scene *scene, unsigned width, unsigned height)
{
    const struct tia_camera *camera = &scene->camera;
    struct vec eye = embree_place(scene, camera->eye);
    struct vec back = vec_unit(vec_sub(eye, embree_place(scene, camera->reference)));
    struct vec right = vec_unit(vec_cross(float_place(camera->up), back));
    float tall = tanf((float)camera->fov / 65536 * 3.14159265F / 360);

    return (struct eye_rays){
        eye,   right, vec_cross(back, right), vec_scaled(back, -1), tall, tall * (float)width / (float)height,
        width, height};
}

static inline struct float_ray eye_ray(const struct eye_rays *eye, unsigned x, unsigned y)
{
    float across = (2 * ((float)x + 0.5F) / (float)eye->width - 1) * eye->wide;
    float upward = (1 - 2 * ((float)y + 0.5F) / (float)eye->height) * eye->tall;

    return (struct float_ray){eye->eye,
                              vec_unit(vec_along(vec_along(eye->ahead, across, eye->right), upward, eye->up))};
}

/* Bits of MXCSR that flush denormal results and operands to zero, as Embree requires. */
#define FLUSH_TO_ZERO 0x9fc0u

static inline unsigned set_modes(unsigned modes)
{
#ifdef __x86_64__
    unsigned before = _mm_getcsr();
    _mm_setcsr(modes);
    return before;
#else
    return modes;
#endif
}

#endif
