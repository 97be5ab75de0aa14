/* src/simd/rays, wide nodes: rays find the same in packets, one by one, and in fixed point without a hierarchy. */
#include <stdint.h>

static unsigned alone; /* most rays that leave a packet: 1, the only one, or 0, none */
#define WIDE_LANES alone

#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"
#include "with_hierarchy.h"

#define SPHERES 2500
#define RAYS 1500

static struct tia_sphere spheres[SPHERES];
static const struct tia_material materials[2] = {
    {.colour = {1 << 29, 1 << 29, 1 << 29}, .mirror = {1 << 28, 1 << 28, 1 << 28}},
    {.colour = {1 << 29, 1 << 29, 1 << 29}, .transmission = {3 << 28, 1 << 28, 1 << 29}},
};
static struct tia_shape disc = {
    .kind = TIA_DISC,
    .disc = {.normal = {0, 0, 1 << 30}, .radius = 2 << 16},
};
static const struct ray_view *brute; /* the scene without a hierarchy */
static struct room room;
static struct vec {
    double v[3];
} middle;
static unsigned long decided, hits, blocked, filtered;

static struct tia_vec3 around_middle(double size)
{
    return (struct tia_vec3){(tia_q16)(65536 * (middle.v[0] + size * random_double())),
                             (tia_q16)(65536 * (middle.v[1] + size * random_double())),
                             (tia_q16)(65536 * (middle.v[2] + size * random_double()))};
}

/* Sets a random ray or, in a third of the cases, one along an axis that nearly misses a sphere where its box ends, as a
 * packet of one. */
static struct ray some_ray(struct packet *p)
{
    struct tia_vec3 from = around_middle(4);
    double o[3], d[3];
    unsigned axis = (unsigned)(random_bits() % 18);

    for (unsigned i = 0; i < 3; i++)
        d[i] = axis < 6 ? (i == axis % 3) * (axis < 3 ? 1.0 : -1.0) : random_double();
    if (axis < 6) {
        const struct tia_sphere *s = &spheres[random_bits() % SPHERES];
        const tia_q16 at[3] = {s->centre.x, s->centre.y, s->centre.z};
        tia_q16 *to[3] = {&from.x, &from.y, &from.z};
        for (unsigned i = 0; i < 3; i++)
            *to[i] = i == axis % 3 ? (tia_q16)(at[i] - d[i] * 65536) : at[i];
        *to[(axis + 1) % 3] += (tia_q16)((random_bits() % 2 ? 1 : -1) * (s->radius - 4));
    }
    struct ray r = {.origin = num_point_of(from)};
    r.direction = num_dir_normalised((struct num_dir){(num_unit)(d[0] * (double)NUM_UNIT_ONE),
                                                      (num_unit)(d[1] * (double)NUM_UNIT_ONE),
                                                      (num_unit)(d[2] * (double)NUM_UNIT_ONE)});
    sure_point(o, r.origin);
    sure_dir(d, r.direction);
    *p = (struct packet){.o = {o[0], o[1], o[2]},
                         .d = {d[0], d[1], d[2]},
                         .eo = SURE_UNIT,
                         .ed = BOUND(CONVERTED),
                         .from = {.object = -1}};
    return r;
}

static void check_nearest(const struct sure_scene *s, const struct ray *ray, struct packet *p)
{
    struct query q;
    struct hit hit;

    ray_intersect(brute, ray, &hit);
    find_nearest(s, &room, &q, p, 1);
    if (!(q.t + q.e < q.low || (q.t >= INFINITE && q.low >= INFINITE)))
        return;
    decided++;
    hits += hit.object != TIA_NO_OBJECT;
    CHECK_MSG(q.id == (hit.object == TIA_NO_OBJECT ? -1 : (double)hit.object), "object %.0f in place of %u", q.id,
              hit.object);
    CHECK(hit.object == TIA_NO_OBJECT || fabs(q.t - sure_length(hit.t)) <= q.e);
}

static void check_shadows(const struct sure_scene *s, const struct ray *ray, const struct packet *p)
{
    uint32_t blocker = TIA_NO_OBJECT, first = TIA_NO_OBJECT;
    num_length limit = (num_length)((1 + random_double()) * 4 * (double)NUM_LENGTH_ONE), through[3];
    bool passes = ray_transmittance(brute, ray, limit, &blocker, through);
    struct shadow shadow = {.p = *p, .distance = sure_length(limit)};

    find_shadow(s, &room, &shadow, 1, &first);
    if (shadow.unsure)
        return;
    decided++;
    CHECK_EQ(shadow.blocked, !passes);
    blocked += shadow.blocked;
    filtered += passes && through[0] < NUM_LENGTH_ONE;
    for (int c = 0; c < 3 && passes; c++)
        CHECK(fabs(shadow.through[c] - sure_length(through[c])) <= shadow.ethrough);
}

static void compare(const struct tia_scene *scene, unsigned number)
{
    struct tia_scene bare = *scene;
    size_t size = tia_view_size(scene, 0);
    void *memory[2] = {malloc(size), malloc(size)}, *constants = malloc(tia_sure_size(scene, 0));
    struct tia_view *view[2];

    (void)number;
    bare.bvh = NULL;
    CHECK_EQ(tia_view_init(&view[0], memory[0], size, scene, 0, 16, 16, NULL), TIA_OK);
    CHECK_EQ(tia_view_init(&view[1], memory[1], size, &bare, 0, 16, 16, NULL), TIA_OK);
    view[0]->simd_memory = constants;
    tia_sure_prepare(view[0]);
    tia_sure_set_lights(view[0]);
    brute = view[1]->prepared;
    room.scattered = true;
    decided = hits = blocked = filtered = 0;
    for (int i = 0; i < RAYS; i++) {
        struct packet p, again;
        struct ray ray = some_ray(&p);
        again = p;
        check_nearest(tia_sure_scene(view[0]), &ray, &p);
        check_shadows(tia_sure_scene(view[0]), &ray, &again);
    }
    printf("# %lu of %d decided, %lu hits, %lu blocked, %lu filtered\n", decided, 2 * RAYS, hits, blocked, filtered);
    CHECK(decided * 1000 >= 2UL * RAYS * 995);
    CHECK(hits > RAYS / 10 && blocked > RAYS / 10 && filtered > RAYS / 100);
    free(constants);
    free(memory[0]);
    free(memory[1]);
}

/* Far from the origin, boxes need their margin for the rounding of floats. */
static void check_scenes(void)
{
    static const struct vec middles[] = {{{0.1, -0.2, 0.3}}, {{9000.1, -8000.4, 7000.7}}};

    for (unsigned i = 0; i < 2; i++) {
        middle = middles[i];
        for (int k = 0; k < SPHERES; k++)
            spheres[k] = (struct tia_sphere){around_middle(2), (tia_q16)(2000 + random_bits() % 9000), k % 4 == 0};
        disc.disc.centre = around_middle(1);
        struct tia_scene scene = {.camera = {.eye = around_middle(4), .reference = around_middle(0), .fov = 40 << 16},
                                  .materials = materials,
                                  .material_count = 2,
                                  .spheres = spheres,
                                  .sphere_count = SPHERES,
                                  .shapes = &disc,
                                  .shape_count = 1};
        with_hierarchy(&scene, compare, i);
    }
}

TEST(one_by_one)
{
    alone = 1;
    check_scenes();
}

TEST(in_packets)
{
    alone = 0;
    check_scenes();
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(one_by_one);
    RUN(in_packets);
    return check_status();
}
