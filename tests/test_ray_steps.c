/* The light at a point, and the rays that it spawns, in src/simd/rays: each step by itself, at the far end of its bound
 * (see ray_steps.h). */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"

enum { TRIES = 20000 };
#define WITHIN .9999L /* used part of a bound */

static struct light_room lights;

/* ---- lights ---- */

static void try_spot(struct used *soft, struct used *hard, bool is_hard)
{
    const struct ray_light from = {.kind = TIA_SPOT_LIGHT};
    struct real axis = real_random(), aside = real_aside(axis), to, theirs;
    double width = is_hard ? 0 : ldexp(1, -(int)(random_bits() % 18) - 2), eto = some_size(4, 40);
    struct sure_light l = {.from = &from, .normal = {(double)axis.v[0], (double)axis.v[1], (double)axis.v[2]}};
    struct falloff f = {1, 0, 0};

    l.outer = 0.6 * random_double();
    l.inner = l.outer + width;
    long double c = l.outer + width * (long double)some_part() + (is_hard ? 3 * eto * random_double() : 0);
    long double s = sqrtl(1 - c * c), turn = eto * WITHIN * (long double)some_sign();
    to = real_along(real_along((struct real){{0, 0, 0}}, axis, -c), aside, s);
    theirs = real_turned(to, real_along(real_along((struct real){{0, 0, 0}}, axis, s), aside, c), turn);
    spot_falloff(&l, v3_of(to), eto, &f);
    long double exact = -real_dot(theirs, axis), part = is_hard ? exact >= l.inner : (exact - l.outer) / width;
    part = part < 0 ? 0 : part > 1 ? 1 : part;
    if (f.unsure)
        hard->open++;
    else
        use(is_hard ? hard : soft, f.factor - part, f.e + P2M(45));
}

TEST(spots)
{
    struct used soft = {.name = "spot light's falloff"}, hard = {.name = "spot light's edge"};

    for (int i = 0; i < 2 * TRIES; i++)
        try_spot(&soft, &hard, i % 2);
    check_used(&soft);
    check_used(&hard);
}

struct fading {
    struct ray_light from;
    struct sure_light light;
};

static void make_fading(struct fading *to, double at)
{
    struct fading f = {.from = {.kind = TIA_POINT_LIGHT, .fades = true}};

    f.light.unit = ldexp(1, (int)(random_bits() % 6) - 3);
    f.light.constant = random_bits() % 2 ? some_part() : 0;
    f.light.linear = random_bits() % 2 ? 2 * some_part() : 0;
    f.light.quadratic = random_bits() % 2 || f.light.linear == 0 ? 2 * some_part() : 0;
    if (random_bits() % 8 == 0 && at > 0.01) { /* close to where the fixed-point result is 0 */
        double d = at * f.light.unit;
        f.light.constant = f.light.linear = 0;
        f.light.quadratic = 131072 * (1 + 0.001 * random_double()) / (d * d);
    }
    *to = f;
    to->light.from = &to->from;
}

static long double attenuated(const struct sure_light *l, long double distance)
{
    long double d = distance * l->unit, sum = l->constant + d * (l->linear + d * l->quadratic);

    return sum >= 131072 ? 0 : 1 / sum;
}

static void try_attenuation(struct used *u)
{
    double d = 8 * some_part(), ed = d * some_size(4, 40), e0 = some_size(2, 40);
    struct fading given;
    struct falloff f = {some_part(), e0, 0};
    long double turn = (long double)some_sign(), spot = f.factor + e0 * WITHIN * turn;

    make_fading(&given, d);
    attenuate(&given.light, d, ed, &f);
    if (f.unsure)
        u->open++;
    else
        use(u, spot * attenuated(&given.light, d - ed * WITHIN * turn) - f.factor, f.e);
}

static void try_distance(struct used *u)
{
    double d = 8 * some_part() + 0.01, ew = d * some_size(5, 40);
    struct fading given;
    struct real to = real_random();
    struct sample s = {.way = v3_scale(v3_of(to), d), .to = v3_of(to), .ew = ew};

    make_fading(&given, d);
    find_falloff(&given.light, &s);
    if (s.falloff.unsure)
        u->open++;
    else
        use(u, attenuated(&given.light, d + ew * WITHIN * (long double)some_sign()) - s.falloff.factor, s.falloff.e);
}

TEST(attenuation)
{
    struct used at = {.name = "attenuation"}, from = {.name = "attenuation from a point"};

    for (int i = 0; i < TRIES; i++) {
        try_attenuation(&at);
        try_distance(&from);
    }
    check_used(&at);
    check_used(&from);
}

/* Returns a point; *theirs receives the fixed-point one, at most *ep away. In half of the cases two of its coordinates
 * relative to the light are nearly equal in size. */
static struct real some_point(struct real *theirs, const double at[3], double *ep)
{
    struct real n = real_random(), off = real_random(), point;
    long double far = ldexpl(1 + (long double)some_part(), -(int)(random_bits() % 6));
    bool near = random_bits() % 2;

    *ep = (double)far * some_size(5, 30);
    if (near) {
        n.v[1] = n.v[0] * (long double)some_sign() * (1 + 2 * (long double)(*ep / (double)far) * random_real());
        n = real_unit(n);
        off = real_unit((struct real){{n.v[0] < 0 ? -1 : 1, n.v[1] < 0 ? 1 : -1, 0}});
    }
    for (int i = 0; i < 3; i++)
        point.v[i] = (double)(at[i] + far * n.v[i]);
    *theirs = real_along(point, off, *ep * WITHIN * (long double)some_sign());
    return point;
}

/* Gives axes at right angles to the direction from the centre: one is the direction without its smallest coordinate,
 * rotated. */
static void real_axes(struct real point, const double at[3], struct real axes[2])
{
    struct real n = real_unit(real_along(point, (struct real){{at[0], at[1], at[2]}}, -1));
    long double x = fabsl(n.v[0]), y = fabsl(n.v[1]), z = fabsl(n.v[2]);

    axes[0] = x <= y && x <= z ? (struct real){{0, -n.v[2], n.v[1]}}
              : y <= z         ? (struct real){{n.v[2], 0, -n.v[0]}}
                               : (struct real){{-n.v[1], n.v[0], 0}};
    axes[0] = real_unit(axes[0]);
    axes[1] = real_cross(n, axes[0]);
}

static void try_aim(struct used *aims, struct used *samples, struct used *ways)
{
    static double place[16][2][SURE_PLACES];
    const struct ray_light from = {.kind = TIA_SPHERE_LIGHT, .samples = 1};
    struct sure_light l = {.from = &from, .at = {random_double(), random_double(), random_double()}, .place = place};
    const struct picked first = {.run = false};
    struct shade h = {.ep = 0};
    struct real theirs, axes[2], way = {{l.at[0], l.at[1], l.at[2]}};
    struct sample s;
    struct aim a;

    h.point = v3_of(some_point(&theirs, l.at, &h.ep));
    aim_at(&l, &h, &a);
    if (a.unsure) {
        aims->open++;
        return;
    }
    real_axes(theirs, l.at, axes);
    use(aims, real_gap(axes[0], a.axes[0]), a.e);
    use(aims, real_gap(axes[1], a.axes[1]), a.e);
    place[0][0][0] = random_double();
    place[0][1][0] = random_bits() % 2 ? random_double() : 0;
    sample_of(&l, &a, &h, &first, &s);
    way = real_along(real_along(way, axes[0], place[0][0][0]), axes[1], place[0][1][0]);
    way = real_along(way, theirs, -1);
    use(ways, real_gap(way, s.way), s.ew);
    use(samples, real_gap(real_unit(way), s.to), s.eto);
}

TEST(areas)
{
    struct used aims = {.name = "axes of a sphere light"}, samples = {.name = "direction to a sample"},
                ways = {.name = "way to a sample"};

    for (int i = 0; i < 2 * TRIES; i++)
        try_aim(&aims, &samples, &ways);
    check_used(&aims);
    check_used(&samples);
    check_used(&ways);
}

static void try_shadow(struct used *directions, struct used *distances)
{
    const struct ray_light from = {.kind = TIA_POINT_LIGHT, .samples = 1};
    const struct sure_light l = {.from = &from};
    const struct sure_scene scene = {.bias = P2M(13)};
    struct real normal = real_random(), to = real_random(), off = random_bits() % 2 ? to : real_aside(to);
    double far = 4 * some_part() + 0.1;
    struct shade h = {.eg = some_size(6, 30), .geometric = v3_of(normal)};
    struct sample s = {.way = v3_scale(v3_of(to), far), .to = v3_of(to), .ew = far * some_size(5, 40)};
    struct shadow shadow;

    h.eg = real_dot(off, normal) > 0.9 ? h.eg : 2 * h.eg;
    h.outside = off_surface(&scene, &h, scene.bias, &h.eoutside);
    aim_shadow(&scene, &l, &h, &s, &shadow);
    struct real way = real_along(real_of(s.way), normal, -(long double)scene.bias);
    way = real_along(way, off, (s.ew + h.eg * scene.bias) * WITHIN);
    long double distance = sqrtl(real_dot(way, way));
    use(directions, real_gap(real_unit(way), shadow.p.d), shadow.p.ed);
    use(distances, distance - shadow.distance, shadow.edistance);
}

TEST(shadows)
{
    struct used directions = {.name = "direction of a shadow ray"}, distances = {.name = "length of a shadow ray"};

    for (int i = 0; i < TRIES; i++)
        try_shadow(&directions, &distances);
    check_used(&directions);
    check_used(&distances);
}

/* ---- a surface's reflection ---- */

/* Tests the highlight. The exponent is the scene's, an integer or not; x^e is computed by the fixed-point code, and by
 * the formula where x is off. */
static void try_highlight(struct used *u, struct used *exact)
{
    tia_q16 exponent = (tia_q16)(65536 * exp2(4 * some_part()));
    num_unit x = (num_unit)(some_part() * (double)NUM_UNIT_ONE);
    struct shade h = {.specular = {1, 1, 1}, .exponent = exponent / 65536.0, .glossy = 1};
    struct sample s = {.eto = some_size(8, 40)};
    bool moved = random_bits() % 2;
    vd rgb[3], e, lambert = 1, el = moved ? some_size(8, 40) : 0;

    s.eto = moved ? s.eto : 0;
    h.ev = moved ? some_size(8, 40) : 0;
    h.efacing = moved ? some_size(8, 40) : 0;
    s.to = (struct v3){1, 0, 0};
    h.viewer = (struct v3){-sure_cosine(x) / 2, 0, 0};
    h.facing = sure_cosine(x) / 4; /* half of it is x */
    reflect_light(&h, &s, lambert, el, 1, rgb, &e);
    if (!moved) {
        use(exact, sure_length(num_power_length(x, exponent)) - rgb[0], e);
        return;
    }
    long double turn = WITHIN * (long double)some_sign(),
                half = 2 * (h.facing + h.efacing * turn) * (lambert + el * turn) - (h.viewer.x - (h.ev + s.eto) * turn);
    half = half < 0 ? 0 : half > 1 ? 1 : half;
    use(u, powl(half, h.exponent) - rgb[0], e);
}

static void try_diffuse(struct used *u)
{
    struct shade h = {.colour = {1, 0.3, 0.1}, .ecolour = some_size(4, 40)};
    struct sample s = {.eto = 0};
    double el = some_size(4, 40), lambert = 1 - el;
    long double turn = WITHIN * (long double)some_sign();
    vd rgb[3], e;

    if (el + h.ecolour > 0)
        reflect_light(&h, &s, lambert, el, 1, rgb, &e);
    if (el + h.ecolour > 0)
        use(u, (1 + h.ecolour * turn) * (lambert + el * turn) - rgb[0], e);
}

TEST(reflected_light)
{
    struct used highlights = {.name = "highlight"}, powers = {.name = "power of a highlight"},
                diffuse = {.name = "diffuse light"};

    for (int i = 0; i < 5 * TRIES; i++)
        try_highlight(&highlights, &powers);
    for (int i = 0; i < TRIES; i++)
        try_diffuse(&diffuse);
    check_used(&highlights);
    check_used(&powers);
    check_used(&diffuse);
}

/* Tests one sample of an unobstructed light, at angles above the surface and below it, lit and dark. */
static void try_sample(struct used *u, bool grazing)
{
    const struct ray_light from = {.kind = TIA_DIRECTIONAL_LIGHT, .samples = 1};
    const struct sure_light l = {.from = &from, .emission = {1, 1, 1}, .brightest = 1};
    const struct sure_scene scene = {.extent = 4};
    struct real to = real_random();
    struct shade h = {.colour = {1, 1, 1}, .eg = some_size(8, 30)};
    struct sample s = {.to = v3_of(to), .eto = grazing ? some_size(8, 30) : 0, .falloff = {some_part(), 0, 0}};
    struct cancel never = {0};
    struct lit lit = {.cancel = &never, .room = &lights};
    uint32_t blocker = TIA_NO_OBJECT;
    long double turn = WITHIN * (long double)some_sign();

    s.falloff.e = grazing ? 0 : s.falloff.factor * some_size(3, 30);
    long double ea = h.eg + s.eto, above = (long double)random_double() * 1.5L * ea;
    h.normal = v3_of(to);
    h.geometric = v3_of(grazing ? real_along(real_aside(to), to, above) : to);
    add_sample(&scene, &l, &h, &s, 1, &blocker, &lit);
    if (lit.unsure) {
        u->open++;
        return;
    }
    long double factor = s.falloff.factor + s.falloff.e * turn;
    bool dark = grazing && above + ea * turn <= 0;
    use(u, (dark ? 0 : factor) - lit.own[0], lit.eown + P2M(45));
}

static void try_ambient(struct used *u)
{
    const struct ray_light from = {.kind = TIA_AMBIENT_LIGHT};
    struct sure_light l = {.from = &from, .emission = {1, 1, 1}, .brightest = 1};
    const struct sure_scene scene = {.lights = &l};
    struct shade h = {.colour = {0.5, 0.5, 0.5}, .ecolour = some_size(3, 30)};
    struct cancel never = {0};
    struct lit lit = {.cancel = &never, .room = &lights};
    const uint8_t class[1] = {0};
    uint32_t blocker = TIA_NO_OBJECT;

    add_light(&scene, 0, &h, 1, false, class, &blocker, &lit);
    use(u, h.ecolour * WITHIN, lit.eown);
}

TEST(samples)
{
    struct used fade = {.name = "light that fades"}, graze = {.name = "light that grazes"},
                ambient = {.name = "ambient light"};

    for (int i = 0; i < TRIES; i++) {
        try_sample(&fade, false);
        try_sample(&graze, true);
        try_ambient(&ambient);
    }
    check_used(&fade);
    check_used(&graze);
    check_used(&ambient);
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(spots);
    RUN(attenuation);
    RUN(areas);
    RUN(shadows);
    RUN(reflected_light);
    RUN(samples);
    return check_status();
}
