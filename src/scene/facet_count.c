/* facet_count.c - corners lie on the surface, so that the faces of a closed shape are inside it: each ray that meets a
 * face also meets the shape.
 *
 * The chord between neighbours among n corners of a circle of radius r is at most r (1 - cos(pi/n)) < r pi^2/(2 n^2)
 * away from the circle. So n^2 >= 5 r/e is enough for an error of e. The surplus, 5 - pi^2/2 = 0.07, covers the
 * rounding of angles to 2^-16 degree, since n is at most 2^14. On a sphere, a face spans such an arc in both
 * directions. Let u be the direction of the arcs' middle: p.u >= r (1 - 2 (1 - cos(pi/n))) for each corner p, and so
 * for each point between the corners. So a sphere needs n^2 >= 10 r/e. A transform enlarges radii and errors by at most
 * its largest scale. */
#include "facet_count.h"

#include "math/integer.h"

#define AROUND_MAX (1 << 14)
#define AROUND_MIN 8
#define RADIUS_MAX (INT64_C(1) << 49) /* Q31.32; radii in an unchecked scene are clamped to this */

struct round {
    int64_t radius; /* the largest radius */
    bool ends[2];   /* for each end of a cylinder or cone: false if it is a point */
    bool capped;
};

static bool round_of(const struct tia_shape *s, struct round *r)
{
    switch (s->kind) {
    case TIA_SPHERE:
        *r = (struct round){.radius = s->sphere.radius};
        return true;
    case TIA_DISC:
        *r = (struct round){.radius = s->disc.radius};
        return true;
    case TIA_CYLINDER:
        *r = (struct round){s->cylinder.radius, {true, true}, s->cylinder.capped};
        return true;
    case TIA_CONE:
        *r = (struct round){s->cone.base_radius > s->cone.top_radius ? s->cone.base_radius : s->cone.top_radius,
                            {s->cone.base_radius > 0, s->cone.top_radius > 0},
                            s->cone.capped};
        return true;
    default:
        return false;
    }
}

/* Returns the transform's largest scale, Q16.16. */
static int64_t largest_scale(const struct tia_scene *scene, const struct tia_shape *s)
{
    if (!s->transform || s->transform > scene->transform_count)
        return TIA_Q16_ONE;
    const struct tia_vec3 *scale = &scene->transforms[s->transform - 1].scale;
    tia_q16 most = scale->x > scale->y ? scale->x : scale->y;
    return most > scale->z ? most : scale->z;
}

/* Returns a sufficient number of corners, a multiple of 4: n^2 >= factor radius/error. */
static uint32_t corners_of(int64_t radius, tia_q16 error, uint32_t factor)
{
    uint64_t size = radius < 0 ? 0 : (uint64_t)(radius < RADIUS_MAX ? radius : RADIUS_MAX);
    uint64_t square = factor * size / ((uint64_t)error << 16) + 1;
    uint32_t n = (tia_sqrt64(square) + 4) / 4 * 4;

    return n < AROUND_MIN ? AROUND_MIN : n;
}

static void count(const struct tia_shape *s, const struct round *r, struct tia_facets *f)
{
    uint64_t n = f->around, ends = (uint64_t)r->ends[0] + r->ends[1];

    if (s->kind == TIA_SPHERE) { /* n/2 - 1 rings and two poles */
        f->points = n * (n / 2 - 1) + 2;
        f->faces = 2 * n * (n / 2 - 1);
        return;
    }
    f->points = s->kind == TIA_DISC ? n + 1 : n * ends + 2;
    f->faces = s->kind == TIA_DISC ? n : n * ends * (r->capped ? 2 : 1);
}

bool tia_facets_of(const struct tia_scene *scene, uint32_t object, struct tia_facets *facets)
{
    struct tia_shape s = {.kind = TIA_SPHERE};
    struct round r;

    if (object >= scene->sphere_count)
        s = scene->shapes[object - scene->sphere_count];
    else
        s.sphere.radius = scene->spheres[object].radius;
    if (scene->tessellated <= 0 || !round_of(&s, &r))
        return false;
    int64_t radius = r.radius + (scene->fine ? 1 : 0); /* fine digits add at most one unit */
    facets->around = corners_of(radius * largest_scale(scene, &s), scene->tessellated, s.kind == TIA_SPHERE ? 10 : 5);
    count(&s, &r, facets);
    if (facets->around > AROUND_MAX)
        facets->faces = UINT64_C(1) << 40;
    return true;
}
