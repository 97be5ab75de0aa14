/* src/simd/rays, a ray at a time, where its bounds matter: at the edges of shapes, with the fixed-point ray off by as
 * much as the bounds allow. In pictures it hardly ever is: there no test would notice that most of a bound is missing.
 *
 * A fixed-point ray, chosen by halving between two with different hits, is moved by up to eo and turned by up to ed; a
 * certain result for the moved one must be true of the other. */
#include "render/whitted/shade.h"

#define SURE_CHECK
#include "float_modes.h"
#include "ray_edges.h"

static bool is_refracted[QUEUE_SIZE];

static void check_push(int item, bool refracted)
{
    is_refracted[item] = refracted;
}

/* Hooks for whole pictures, which are unused here, see test_ray_bounds.c. */
static void check_camera(const struct sure_block *b, const struct rays *r)
{
    (void)b;
    (void)r;
}

static void check_pop(int item)
{
    (void)item;
}

static void check_met(const struct rays *r, const struct query *q)
{
    (void)r;
    (void)q;
}

static void check_surface(const struct shade *h)
{
    (void)h;
}

static void check_own(const struct lit *lit)
{
    (void)lit;
}

static void check_shadow(unsigned lanes)
{
    (void)lanes;
}

enum { DISTANCE, POINT, GEOMETRIC, NORMAL, COLOUR, OWN, BOUNCE, BOUNDS };
static const char *const names[BOUNDS] = {
    "distance", "point", "geometric normal", "normal", "texture", "light of a surface", "rays it spawns"};
static double used[BOUNDS];
static unsigned long surely, open, differing;

/* ---- comparisons ---- */

static void use(int what, double gap, double bound)
{
    double part = gap / bound;

    used[what] = part > used[what] || isnan(part) ? part : used[what];
}

static double gap3(struct v3 a, const double b[3])
{
    return sqrt((a.x - b[0]) * (a.x - b[0]) + (a.y - b[1]) * (a.y - b[1]) + (a.z - b[2]) * (a.z - b[2]));
}

static double object_of(const struct hit *hit)
{
    return hit->light != TIA_NO_OBJECT    ? LIGHT_ID + hit->light
           : hit->object != TIA_NO_OBJECT ? (double)hit->object
                                          : -1;
}

/* Compares the certified ray's hit with the fixed-point one's; true if both are certainly the same object. */
static bool compare_hit(const struct ray *ray, struct packet *p, struct query *q, struct hit *hit)
{
    double at[3];

    find_nearest(scene, &lights.room, q, p, 1);
    meet(ray, hit);
    double object = object_of(hit);
    bool sky = q->t >= INFINITE && q->low >= INFINITE, sure = sky || q->t + q->e < q->low;
    surely += sure;
    open += !sure;
    if (!sure)
        return false;
    if (object != q->id || (object >= 0 && object < LIGHT_ID && q->element != hit->element)) {
        differing++;
        return false;
    }
    if (object < 0)
        return false;
    use(DISTANCE, fabs(sure_length(hit->t) - q->t), q->e);
    sure_point(at, num_point_at(ray->origin, ray->direction, hit->t));
    use(POINT, gap3(v3_along(p->o, p->d, q->t), at), q->ep + P2M(47));
    return object < LIGHT_ID;
}

/* Compares the light at a point close to the ray's hit. */
static void compare_shadow(const struct ray *ray, const struct packet *p, double distance, double e)
{
    struct shadow shadow = {.p = *p, .distance = distance + e * random_double(), .edistance = e};
    num_length through[3], limit = (num_length)(distance / SURE_UNIT);
    uint32_t blocker = TIA_NO_OBJECT, known = TIA_NO_OBJECT;

    if (distance < e)
        return;
    find_shadow(scene, &lights.room, &shadow, 1, &blocker);
    surely += !shadow.unsure;
    open += shadow.unsure;
    if (shadow.unsure)
        return;
    bool lit = ray_transmittance(view, ray, limit, &known, through);
    differing += lit != !shadow.blocked;
    for (int c = 0; c < 3 && lit && !shadow.blocked; c++)
        differing += fabs(sure_length(through[c]) - shadow.through[c]) > shadow.ethrough + SURE_UNIT;
}

static void compare_surface(const struct shade *h, const struct shading *shading)
{
    double v[3];

    sure_point(v, shading->point);
    use(POINT, gap3(h->point, v), h->ep);
    sure_dir(v, shading->geometric);
    use(GEOMETRIC, gap3(h->geometric, v), h->eg);
    sure_dir(v, shading->normal);
    use(NORMAL, gap3(h->normal, v), h->en);
    for (int c = 0; c < 3; c++)
        use(COLOUR, fabs(sure_length(shading->colour[c]) - h->colour[c]), h->ecolour + P2M(44));
}

static void compare_light(const struct shade *h, const struct shading *shading, struct path *path)
{
    const num_length whole[3] = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE};
    struct cancel never = {0};
    struct lit lit = {
        .cancel = &never, .room = &lights, .unsure = mnone(), .eown = most3(h->flat) * h->efacing + P2M(42)};
    uint32_t blocker = TIA_NO_OBJECT;
    const uint8_t class[1] = {(uint8_t)path->class};
    num_length colour[3] = {0, 0, 0};

    for (int c = 0; c < 3; c++)
        lit.own[c] = h->emission[c] + h->flat[c] * vmax(h->facing, 0);
    for (uint32_t n = 0; n < scene->light_count; n++)
        add_light(scene, n, h, 1, false, class, &blocker, &lit);
    surely += !lit.unsure;
    open += lit.unsure;
    if (lit.unsure)
        return;
    shade_light(path, shading, whole, colour);
    for (int c = 0; c < 3; c++)
        use(OWN, fabs(sure_length(colour[c]) - lit.own[c]), lit.eown);
}

static void compare_rays(const struct queue *queue, int item, const struct ray *ray, const num_length throughput[3])
{
    double n[COLUMNS], v[3];

    for (int i = 0; i < COLUMNS; i++)
        n[i] = queue->number[i][item];
    const struct v3 o = {n[0], n[1], n[2]}, d = {n[3], n[4], n[5]};

    sure_point(v, ray->origin);
    use(BOUNCE, gap3(o, v), n[9]);
    sure_dir(v, ray->direction);
    use(BOUNCE, gap3(d, v), n[10]);
    for (int c = 0; c < 3; c++)
        use(BOUNCE, fabs(sure_length(throughput[c]) - n[6 + c]), n[11]);
}

static void compare_bounces(const struct packet *p, const struct shade *h, const struct shading *shading)
{
    const struct media none = {.count = 0};
    static struct work w;
    struct sure_block block = {.scene = scene};
    struct rays r = {.p = *p, .weight = {1, 1, 1}, .ew = 0};
    struct bounces next;

    w.block = &block;
    w.queue.count = 0;
    bounce(&w, h, 1, &r);
    surely += !block.unsure[0];
    open += block.unsure[0];
    if (block.unsure[0])
        return;
    shade_bounce(view, shading, &none, &next);
    for (int i = 0; i < w.queue.count; i++)
        compare_rays(&w.queue, i, is_refracted[i] ? &next.refracted : &next.reflected,
                     is_refracted[i] ? next.refracts : next.reflects);
}

/* Returns a random direction, often close to the surface with that normal. */
static struct num_dir grazing(struct v3 normal)
{
    const double n[3] = {normal.x, normal.y, normal.z};
    struct real3 d = random_unit();
    long double up = 0, part = 1 - ldexpl(1, -(int)(random_bits() % 13));

    for (int i = 0; i < 3; i++)
        up += d.v[i] * (long double)n[i];
    for (int i = 0; i < 3; i++)
        d.v[i] -= up * part * (long double)n[i];
    return towards(d);
}

/* Compares rays that start at the point: the shapes that they certainly leave, and the faces to which they return. */
static void compare_leaving(const struct shade *h, const struct shading *shading, double sign)
{
    struct ray ray = {num_point_at(shading->point, shading->geometric, sign > 0 ? view->bias : -view->bias),
                      grazing(h->geometric)};
    struct packet p = moved(&ray, 0, random_size(10, 40));
    struct query q;
    struct hit hit;

    p.o = off_surface(scene, h, sign * scene->bias, &p.eo);
    p.from = leaving_or_not(h, p.d, p.ed, sign, scene->bias);
    if (p.from.object >= 0)
        (void)compare_hit(&ray, &p, &q, &hit);
}

static void compare(const struct ray *ray, struct packet *p)
{
    struct path path = {.view = view, .class = (unsigned)random_bits() % 16, .next_reached = PATH_REACHED};
    struct shading shading;
    struct query q;
    struct hit hit;
    struct shade h;

    for (int i = 0; i < PATH_BLOCKERS; i++)
        path.blocker[i] = TIA_NO_OBJECT;
    if (!compare_hit(ray, p, &q, &hit))
        return;
    compare_shadow(ray, p, sure_length(hit.t) + 4 * q.e * random_double(), q.e * fabs(random_double()));
    find_surfaces(scene, p, &q, 1, &h);
    surely += !h.unsure;
    open += h.unsure;
    if (h.unsure)
        return;
    shade_prepare(&path, ray, &hit, &shading);
    compare_surface(&h, &shading);
    compare_light(&h, &shading, &path);
    compare_bounces(p, &h, &shading);
    compare_leaving(&h, &shading, 1);
    compare_leaving(&h, &shading, -1);
}

static void check_world(const struct world *world, int rays)
{
    surely = open = differing = 0;
    memset(used, 0, sizeof used);
    open_world(world);
    for (int i = 0; i < rays && !check_failed; i++) {
        double eo = random_size(5, 46), ed = random_size(5, 46), size = fmax(fmax(eo, ed), 1e-17);
        struct real3 origin = random3(unit * (random_bits() % 2 ? 1.5L : 5));
        struct ray ray = edge_ray(origin, (long double)(size * fabs(random_double())));
        for (int k = 0; k < 4; k++) {
            struct packet p = moved(&ray, eo * (double)unit, ed);
            compare(&ray, &p);
        }
    }
    close_world();
    printf("# %s: %lu sure, %lu open", world->name, surely, open);
    for (int i = 0; i < BOUNDS; i++)
        printf(", %s %.3f", names[i], used[i]);
    printf("\n");
    for (int i = 0; i < BOUNDS; i++)
        CHECK_MSG(used[i] <= 1, "%s: the bound of the %s is exceeded %.2f times", world->name, names[i], used[i]);
    CHECK_MSG(differing == 0, "%s: %lu decisions differ", world->name, differing);
    CHECK(surely > open / 4);
}

TEST(edges)
{
    (void)trace;
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++)
        check_world(&worlds[i], 4000);
}

int main(void)
{
    float_mode_of_simd();
    RUN(edges);
    return check_status();
}
