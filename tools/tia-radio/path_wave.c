#include "path_wave.h"

#include <math.h>

#define PI 3.14159265358979323846
#define Q62 4611686018427387904.0 /* 2^62 */

/* ---- places ---- */

double metres_of(const struct world *world, tia_q16 at)
{
    return ldexp(at, -16 - world->scale_bits);
}

struct tia_vec3 place_at(const struct world *world, const double metres[3])
{
    tia_q16 at[3];

    for (int k = 0; k < 3; k++)
        at[k] = (tia_q16)llround(ldexp(metres[k], 16 + world->scale_bits));
    return (struct tia_vec3){at[0], at[1], at[2]};
}

/* ---- coefficients ---- */

struct coefficients fresnel(double complex eta, double cosine)
{
    double complex root = csqrt(eta - (1 - cosine * cosine));

    return (struct coefficients){(cosine - root) / (cosine + root), (eta * cosine - root) / (eta * cosine + root)};
}

/* Returns the coefficients by P.2040-3, 2.2.2.2: T = (1 - R^2) exp(-j q) / (1 - R^2 exp(-2 j q)), q = 2 pi d / lambda
 * sqrt(eta - sin^2). The path's length includes the way through the wall. The phase of that way in air, 2 pi d cos /
 * lambda, is therefore subtracted. */
struct coefficients slab(double complex eta, double thickness, double cosine, double frequency)
{
    double way = 2 * PI * thickness * frequency / LIGHT_SPEED;
    double complex q = way * csqrt(eta - (1 - cosine * cosine)), once = cexp(-I * q), back = cexp(I * way * cosine);
    struct coefficients r = fresnel(eta, cosine);

    return (struct coefficients){(1 - r.te * r.te) * once * back / (1 - r.te * r.te * once * once),
                                 (1 - r.tm * r.tm) * once * back / (1 - r.tm * r.tm * once * once)};
}

/* ---- vectors ---- */

static void unit_of(const int64_t from[3], double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = (double)from[k] / Q62;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static bool normalise(double a[3])
{
    double length = sqrt(dot(a, a));

    for (int k = 0; k < 3; k++)
        a[k] = length > 1e-12 ? a[k] / length : 0;
    return length > 1e-12;
}

static double complex along(const double complex e[3], const double v[3])
{
    return e[0] * v[0] + e[1] * v[1] + e[2] * v[2];
}

/* Computes the unit vector perpendicular to d that is closest to vertical; if d itself is vertical, the one closest to
 * the x axis. */
static void vertical_of(int up, const double d[3], double v[3])
{
    for (int tries = 0; tries < 2; tries++) {
        int axis = tries == 0 ? up : 0;
        for (int k = 0; k < 3; k++)
            v[k] = (k == axis ? 1 : 0) - d[axis] * d[k];
        if (normalise(v))
            return;
    }
}

static void polarisation_of(const struct world *world, int polarisation, const double d[3], double e[3])
{
    double v[3];

    vertical_of(world->up, d, v);
    if (polarisation == HORIZONTAL)
        cross(d, v, e);
    for (int k = 0; k < 3 && polarisation == VERTICAL; k++)
        e[k] = v[k];
}

/* ---- along a path ---- */

/* Multiplies the component of E perpendicular to the plane of incidence by c.te, and the component in that plane by
 * c.tm. In the plane, E is along d x te, where d is the direction before or after the surface. If d is along the
 * normal, any plane through d is a plane of incidence. */
static void apply(struct coefficients c, const double n[3], const double before[3], const double after[3],
                  double complex e[3])
{
    double te[3], in[3], out[3];

    cross(before, n, te);
    if (!normalise(te))
        vertical_of(1, before, te);
    cross(before, te, in);
    cross(after, te, out);
    double complex across = c.te * along(e, te), within = c.tm * along(e, in);
    for (int k = 0; k < 3; k++)
        e[k] = across * te[k] + within * out[k];
}

static double cosine_of(const double n[3], const double d[3])
{
    return fmin(fabs(dot(n, d)), 1);
}

static double thickness_of(const struct world *world, const struct medium *medium, const struct tia_radio_face *face)
{
    return medium->thickness > 0 ? medium->thickness
           : face->thickness > 0 ? metres_of(world, face->thickness)
                                 : THICKNESS_DEFAULT;
}

/* Computes the coefficients at the path's faces and through its walls. */
static void meet(const struct world *world, const struct tia_radio_path *path, struct field *field)
{
    for (uint32_t i = 0; i < path->order; i++) {
        struct tia_radio_face face = tia_radio_face(world->radio, path->face[i]);
        double n[3], d[3];
        unit_of(face.normal, n);
        unit_of(path->direction[i], d);
        field->reflection[i] = fresnel(world->media[face.material].eta, cosine_of(n, d));
    }
    for (uint32_t i = 0; i < path->wall_count; i++) {
        struct tia_radio_face face = tia_radio_face(world->radio, path->wall[i].face);
        const struct medium *medium = &world->media[face.material];
        double n[3], d[3];
        unit_of(face.normal, n);
        unit_of(path->direction[path->wall[i].segment], d);
        field->transmission[i] =
            slab(medium->eta, thickness_of(world, medium, &face), cosine_of(n, d), world->frequency);
    }
}

/* Returns the gain of a polarisation along the path, excluding free-space loss. The walls that a segment passes through
 * are applied in the order in which they were found. If the walls are parallel, or if the wave runs in a plane
 * perpendicular to all of them, the order affects only rounding. */
static double complex carry(const struct world *world, const struct tia_radio_path *path, const struct field *field,
                            int polarisation)
{
    double complex e[3];
    double d[3], next[3], start[3], n[3];

    unit_of(path->direction[0], d);
    polarisation_of(world, polarisation, d, start);
    for (int k = 0; k < 3; k++)
        e[k] = start[k];
    for (uint32_t i = 0; i <= path->order; i++) {
        unit_of(path->direction[i], d);
        for (uint32_t w = 0; w < path->wall_count; w++)
            if (path->wall[w].segment == i) {
                unit_of(tia_radio_face(world->radio, path->wall[w].face).normal, n);
                apply(field->transmission[w], n, d, d, e);
            }
        if (i == path->order)
            break;
        unit_of(path->direction[i + 1], next);
        unit_of(tia_radio_face(world->radio, path->face[i]).normal, n);
        apply(field->reflection[i], n, d, next, e);
    }
    polarisation_of(world, polarisation, d, start);
    return along(e, start);
}

static void angles_of(int up, const double d[3], double s, double angles[2])
{
    double v[3] = {s * d[0], s * d[1], s * d[2]};
    double left = up == 1 ? -v[2] : v[1]; /* left of +x, seen from above */

    angles[0] = v[0] == 0 && left == 0 ? 0 : atan2(left, v[0]) * 180 / PI;
    angles[1] = atan2(v[up], hypot(v[0], left)) * 180 / PI;
}

/* Returns the fractional part of a length in wavelengths; `length` has `bits` fractional bits. 10 km at 28 GHz are 10^6
 * wavelengths, whose phase would have an error of 10^-9 as a product of doubles. So the length, the wave number and
 * their product are sums of two doubles each. */
static double part_of_wave(int64_t length, int bits, double frequency)
{
    double high = (double)(length >> 20 << 20), low = (double)(length & 0xfffff);
    double waves = frequency / LIGHT_SPEED, less = fma(-waves, LIGHT_SPEED, frequency) / LIGHT_SPEED;
    double product = high * waves, rest = fma(high, waves, -product) + high * less + low * waves;

    product = ldexp(product, -bits);
    return product - floor(product) + ldexp(rest, -bits);
}

void field_of(const struct world *world, const struct tia_radio_path *path, struct field *field)
{
    double first[3], last[3];

    int bits = TIA_RADIO_LENGTH_BITS + world->scale_bits;

    field->length = ldexp((double)path->length, -bits);
    field->delay = field->length / LIGHT_SPEED;
    unit_of(path->direction[0], first);
    unit_of(path->direction[path->order], last);
    angles_of(world->up, first, 1, field->departure);
    angles_of(world->up, last, -1, field->arrival);
    meet(world, path, field);
    double complex free_space = LIGHT_SPEED / world->frequency / (4 * PI * field->length) *
                                cexp(-2 * PI * I * part_of_wave(path->length, bits, world->frequency));
    for (int p = 0; p < POLARISATIONS; p++)
        field->gain[p] = free_space * carry(world, path, field, p);
}

/* ---- all components ---- */

static double power_of(double complex gain)
{
    return creal(gain) * creal(gain) + cimag(gain) * cimag(gain);
}

void summarise(const struct field *fields, const struct tia_radio_path *paths, unsigned count, struct summary *summary)
{
    for (int p = 0; p < POLARISATIONS; p++) {
        double complex sum = 0;
        double power = 0, first = 0, second = 0, sight = 0;
        for (unsigned i = 0; i < count; i++) {
            double own = power_of(fields[i].gain[p]), late = fields[i].delay - fields[0].delay;
            sum += fields[i].gain[p];
            power += own;
            first += own * late;
            second += own * late * late;
            sight += paths[i].order == 0 && paths[i].wall_count == 0 ? own : 0;
        }
        double mean = power > 0 ? first / power : 0, spread = power > 0 ? second / power - mean * mean : 0;
        summary->coherent[p] = power_of(sum);
        summary->incoherent[p] = power;
        summary->delay_spread[p] = sqrt(fmax(spread, 0));
        summary->rician[p] = sight > 0 ? sight / (power - sight) : 0;
    }
}

double decibels(double power)
{
    return 10 * log10(power);
}
