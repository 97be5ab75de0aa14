/* The light that a surface scatters along a path, in src/simd/rays: reflectance over density, random directions and the
 * balance heuristic, each step by itself, at the far end of its bound (see ray_steps.h). */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"
#include "simd/rays/walk_paths_tmpl.h"

enum { TRIES = 100000 };
#define WITHIN .9999L /* used part of a bound */

static long double some_turn(double e)
{
    return e * WITHIN * (long double)some_sign();
}

/* A surface with a diffuse and perhaps a glossy lobe, and a direction over it. */
struct scattering {
    struct shade h;
    struct lobes l;
    struct cosines of;
    struct ve light; /* the density of an emitter, if any */
};

static void make_scattering(struct scattering *to)
{
    bool glossy = random_bits() % 4 != 0;
    double n = exp2(13 * some_part()), grazing = random_bits() % 2 ? some_part() : some_size(0, 12);

    memset(to, 0, sizeof *to);
    to->h.exponent = n;
    to->h.ecolour = some_size(14, 44);
    for (int c = 0; c < 3; c++) {
        to->h.colour[c] = random_bits() % 4 ? some_part() : 0;
        to->h.specular[c] = glossy && random_bits() % 4 ? some_part() : 0;
    }
    to->l.glossy = glossy;
    to->l.chance[CHANCE_GLOSSY] = glossy ? 0.5 * some_part() : 0;
    to->l.chance[CHANCE_DIFFUSE] = 0.5 * some_part();
    to->l.spread = glossy ? some_size(14, 44) : 0;
    to->of.normal = grazing;
    to->of.enormal = ldexp(1, -48) + some_size(14, 44);
    to->of.mirrored = random_bits() % 4 ? 1 - some_part() * 4 / n : random_double();
    to->of.emirrored = ldexp(1, -48) + some_size(14, 44) / n;
    to->light.v = random_bits() % 2 ? exp2(12 * random_double()) : 0;
    to->light.e = to->light.v * some_size(12, 44);
}

/* The same with all numbers at the far ends of their bounds, in long double. */
struct turned {
    long double reflected[3], density, scattered;
};

static void turn_scattering(const struct scattering *s, struct turned *to)
{
    long double x = s->of.normal + some_turn(s->of.enormal), n = s->h.exponent,
                m = s->of.mirrored + some_turn(s->of.emirrored), p = s->l.glossy && m > 0 ? powl(m < 1 ? m : 1, n) : 0;
    long double glossy = s->l.chance[CHANCE_GLOSSY] + some_turn(s->l.glossy ? s->l.spread : 0),
                diffuse = s->l.chance[CHANCE_DIFFUSE] + some_turn(s->l.spread), colour = some_turn(s->h.ecolour);

    to->scattered = diffuse * x + glossy * (n + 1) / 2 * p;
    to->density = to->scattered + s->light.v + some_turn(s->light.e);
    for (int c = 0; c < 3; c++)
        to->reflected[c] = x * (s->h.colour[c] + colour + s->h.specular[c] * (n + 2) / 2 * p);
}

static void try_reflectance(struct used *shares, struct used *densities)
{
    struct scattering s;
    struct turned turned;
    struct response r;

    make_scattering(&s);
    respond(&s.h, &s.l, &s.of, &r);
    turn_scattering(&s, &turned);
    use(densities, turned.scattered - r.density.v, r.density.e);
    vd density = r.density.v + s.light.v, inverse = 1 / density, share = most3(r.rgb) * inverse;
    if (s.of.normal <= s.of.enormal || density <= BOUND(SHARE_KNOWN) * (r.density.e + s.light.e)) {
        shares->open++;
        return;
    }
    vd e = reflectance_error(&s.h, &r, s.light, inverse, share);
    for (int c = 0; c < 3; c++)
        use(shares, turned.reflected[c] / turned.density - r.rgb[c] * inverse, e);
}

TEST(reflectance_over_density)
{
    struct used shares = {.name = "reflectance over density"}, densities = {.name = "density of a direction"};

    for (int i = 0; i < 4 * TRIES; i++)
        try_reflectance(&shares, &densities);
    check_used(&shares);
    check_used(&densities);
}

/* Compares a direction around an axis with that of the fixed-point code, whose axis is turned by the error. */
static void try_direction(struct used *directions, struct used *cosines)
{
    const uint32_t u[2] = {(uint32_t)random_bits(), (uint32_t)random_bits()};
    struct real axis = real_random(), theirs;
    double e = some_size(4, 44);
    int64_t q62[3];
    double to[3];
    vd ed;
    vm unsure;

    theirs = real_turned(axis, real_aside(axis), e * WITHIN);
    const struct num_dir n = {(num_unit)(theirs.v[0] * NUM_UNIT_ONE), (num_unit)(theirs.v[1] * NUM_UNIT_ONE),
                              (num_unit)(theirs.v[2] * NUM_UNIT_ONE)};
    struct v3 local = cosine_direction(u[0], u[1]),
              d = around(v3_of(axis), e + BOUND(CONVERTED), mnone(), local, BOUND(LOCAL), &ed, &unsure);
    tia_sample_cosine(u, q62);
    struct num_dir fixed = ray_around(n, num_dir_of_q62(q62));
    if (any(unsure)) {
        directions->open++;
        return;
    }
    sure_dir(to, fixed);
    use(directions, real_gap((struct real){{to[0], to[1], to[2]}}, d), ed);
    use(cosines, sure_cosine(num_dir_dot(fixed, n)) - local.z, BOUND(LOCAL_COSINE));
}

TEST(random_directions)
{
    struct used directions = {.name = "direction around an axis"},
                cosines = {.name = "cosine of a direction to its axis"};

    for (int i = 0; i < TRIES; i++)
        try_direction(&directions, &cosines);
    check_used(&directions);
    check_used(&cosines);
}

static void try_balance(struct used *u)
{
    struct paths p = {.specular = 0};
    struct ve chosen = {random_bits() % 8 ? exp2(12 * random_double()) : 0, 0};
    const struct sure_paths paths = {.one_of = 1.0 / (int)(1 + random_bits() % 4)};
    vm fine = mnot(mnone());

    p.density.v = exp2(12 * random_double());
    p.density.e = p.density.v * some_size(2, 44);
    chosen.e = chosen.v * some_size(2, 44);
    struct ve weight = weight_of(&paths, &p, chosen, &fine);
    long double q = p.density.v + some_turn(p.density.e),
                other = (chosen.v + some_turn(chosen.e)) * (long double)paths.one_of;
    if (any(fine))
        use(u, q / (q + other) - weight.v, weight.e);
    else
        u->open++;
}

TEST(balance_of_two_strategies)
{
    struct used u = {.name = "balance heuristic's weight"};

    for (int i = 0; i < TRIES; i++)
        try_balance(&u);
    check_used(&u);
}

int main(void)
{
    (void)trace;
    (void)walk_paths;
    (void)occlude;
    float_mode_of_simd();
    RUN(reflectance_over_density);
    RUN(random_directions);
    RUN(balance_of_two_strategies);
    return check_status();
}
