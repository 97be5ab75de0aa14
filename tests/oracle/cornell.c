/* cornell.c - the Cornell box: Cornell University Program of Computer Graphics, "Cornell box data",
 * http://www.graphics.cornell.edu/online/box/data.html: camera, polygons, spectra.
 *
 * Colours are linear, with the primaries of sRGB. They are computed from those spectra with the CIE 1931 observer and
 * light of equal energy. The lamp emits on both sides, absorbs light that meets it, and is 0.05 below the ceiling. */
#include "cornell.h"

#include "vec.h"

enum { WHITE, RED, GREEN, LAMP, POLYGONS = 15 };

const double oracle_box_colours[4][3] = {{0.885809, 0.698859, 0.666422},
                                         {0.570068, 0.0430135, 0.0443706},
                                         {0.105421, 0.37798, 0.076425},
                                         {20.7168, 10.8546, 2.77075}};

const double oracle_box_polygons[POLYGONS][4][3] = {
    {{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}},               /* floor */
    {{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}},   /* ceiling */
    {{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}}, /* back wall */
    {{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}},               /* right wall */
    {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}},   /* left wall */
    {{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}},         /* short block */
    {{290, 0, 114}, {290, 165, 114}, {240, 165, 272}, {240, 0, 272}},
    {{130, 0, 65}, {130, 165, 65}, {290, 165, 114}, {290, 0, 114}},
    {{82, 0, 225}, {82, 165, 225}, {130, 165, 65}, {130, 0, 65}},
    {{240, 0, 272}, {240, 165, 272}, {82, 165, 225}, {82, 0, 225}},
    {{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}, /* tall block */
    {{423, 0, 247}, {423, 330, 247}, {472, 330, 406}, {472, 0, 406}},
    {{472, 0, 406}, {472, 330, 406}, {314, 330, 456}, {314, 0, 456}},
    {{314, 0, 456}, {314, 330, 456}, {265, 330, 296}, {265, 0, 296}},
    {{265, 0, 296}, {265, 330, 296}, {423, 330, 247}, {423, 0, 247}},
};
const double oracle_box_lamp[2][3] = {{213, 548.75, 227}, {343, 548.75, 332}};

/* ---- random numbers: splitmix64 ---- */

static double uniform(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ z >> 31) >> 11) / 9007199254740992.0;
}

/* ---- intersections ---- */

struct meeting {
    double t;
    int colour;
    struct oracle_vec normal; /* towards the ray's origin */
};

static struct oracle_vec corner(const double p[3])
{
    return (struct oracle_vec){p[0], p[1], p[2]};
}

/* Updates `nearest` if the ray meets the triangle before it. A point of the triangle's plane is in the triangle if it
 * is on the same side of all three edges. */
static void meet_triangle(struct ray ray, const double a[3], const double b[3], const double c[3], int colour,
                          struct meeting *nearest)
{
    struct oracle_vec p = corner(a), q = corner(b), r = corner(c), normal = cross(sub(q, p), sub(r, p));
    double down = dot(ray.direction, normal), t = dot(sub(p, ray.origin), normal) / down;

    if (down == 0 || !(t > 1e-7) || t >= nearest->t)
        return;
    struct oracle_vec x = at(ray, t);
    if (dot(cross(sub(q, p), sub(x, p)), normal) < 0 || dot(cross(sub(r, q), sub(x, q)), normal) < 0 ||
        dot(cross(sub(p, r), sub(x, r)), normal) < 0)
        return;
    *nearest = (struct meeting){t, colour, unit(scaled(normal, down > 0 ? -1 : 1))};
}

static void meet_lamp(struct ray ray, struct meeting *nearest)
{
    const double *low = oracle_box_lamp[0], *high = oracle_box_lamp[1];
    double t = (low[1] - ray.origin.y) / ray.direction.y;
    struct oracle_vec x = at(ray, t);

    if (t > 1e-7 && t < nearest->t && x.x >= low[0] && x.x <= high[0] && x.z >= low[2] && x.z <= high[2])
        *nearest = (struct meeting){t, LAMP, {0, ray.direction.y > 0 ? -1 : 1, 0}};
}

static struct meeting meet(struct ray ray)
{
    struct meeting nearest = {.t = 1e30};

    for (int i = 0; i < POLYGONS; i++) {
        const double(*p)[3] = oracle_box_polygons[i];
        int colour = i == 3 ? GREEN : i == 4 ? RED : WHITE;
        meet_triangle(ray, p[0], p[1], p[2], colour, &nearest);
        meet_triangle(ray, p[0], p[2], p[3], colour, &nearest);
    }
    meet_lamp(ray, &nearest);
    return nearest;
}

/* ---- paths ---- */

/* Distance from the lamp: nearer surfaces sample its light by directions, others by points of the lamp. Directions
 * alone would be noisy everywhere else, points alone in the gap above the lamp. */
#define NEAR 60

/* Returns the light from a random point of the lamp to a white surface at x, for a radiance of 1: 1/pi cos cos'
 * area/d^2. */
static double from_lamp(struct oracle_vec x, struct oracle_vec normal, uint64_t *state)
{
    const double *low = oracle_box_lamp[0], *high = oracle_box_lamp[1];
    struct oracle_vec y = {low[0] + (high[0] - low[0]) * uniform(state), low[1],
                           low[2] + (high[2] - low[2]) * uniform(state)};
    double distance = length(sub(y, x));
    struct ray ray = {x, unit(sub(y, x))};
    double cosine = dot(ray.direction, normal);

    if (distance < NEAR || cosine <= 0 || meet(ray).t < distance - 1e-6)
        return 0;
    return cosine * fabs(ray.direction.y) * (high[0] - low[0]) * (high[2] - low[2]) / (PI * distance * distance);
}

/* Returns a random direction with the density cos t/pi: the point of the hemisphere above a random point of the unit
 * disc. */
static struct oracle_vec scattered(struct oracle_vec normal, uint64_t *state)
{
    double a, b;

    do {
        a = 2 * uniform(state) - 1;
        b = 2 * uniform(state) - 1;
    } while (a * a + b * b >= 1);
    const struct oracle_vec other = fabs(normal.x) < 0.5 ? (struct oracle_vec){1, 0, 0} : (struct oracle_vec){0, 1, 0};
    struct oracle_vec u = unit(cross(other, normal)), v = cross(normal, u);
    return along(along(scaled(normal, sqrt(1 - a * a - b * b)), a, u), b, v);
}

#define GOES_ON 0.75 /* probability of each bounce after the second */

static struct colour radiance(struct ray ray, uint64_t *state)
{
    struct colour sum = grey(0), throughput = grey(1);

    for (int bounce = 0;; bounce++) {
        struct meeting m = meet(ray);
        if (m.t >= 1e30)
            return sum;
        double direct = m.colour == LAMP ? bounce == 0 || m.t < NEAR : 0;
        for (int c = 0; c < 3; c++)
            sum.channel[c] += throughput.channel[c] * direct * oracle_box_colours[LAMP][c];
        if (m.colour == LAMP || (bounce > 2 && uniform(state) >= GOES_ON))
            return sum;
        ray.origin = along(at(ray, m.t), 1e-6, m.normal);
        direct = from_lamp(ray.origin, m.normal, state);
        for (int c = 0; c < 3; c++) {
            throughput.channel[c] *= oracle_box_colours[m.colour][c] / (bounce > 2 ? GOES_ON : 1);
            sum.channel[c] += throughput.channel[c] * direct * oracle_box_colours[LAMP][c];
        }
        ray.direction = scattered(m.normal, state);
    }
}

/* Returns a ray of the camera on Cornell's page: its focal length is 0.035, the picture is 0.025 wide, and x grows to
 * the left. */
static struct ray camera_ray(double x, double y)
{
    const double half = 0.0125 / 0.035;
    struct oracle_vec d = {(1 - 2 * x) * half, (1 - 2 * y) * half, 1};

    return (struct ray){{278, 273, -800}, unit(d)};
}

/* The samples of a pixel lie in rows x rows squares, one in each. */
void oracle_box(unsigned side, uint64_t seed, unsigned rows, double *rgb)
{
    uint64_t state = seed * UINT64_C(0xd1342543de82ef95);
    const double width = (double)side * rows;

    for (unsigned i = 0; i < side * side; i++)
        for (unsigned n = 0; n < rows * rows; n++) {
            double x = (i % side * rows + n % rows + uniform(&state)) / width;
            double y = (i / side * rows + n / rows + uniform(&state)) / width;
            struct colour sample = radiance(camera_ray(x, y), &state);
            for (int c = 0; c < 3; c++)
                rgb[3 * i + (unsigned)c] += sample.channel[c] / (rows * rows);
        }
}
