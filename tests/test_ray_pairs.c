/* src/simd/rays, faces in floats: the errors of a pair's edge areas, as a part of their bound. */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"

/* A mesh of one face around its centre, in a box with these half axes, and a ray. */
struct tried {
    double half[3];
    struct sure_face face;
    struct packet packet;
};

static double some_corner(double half)
{
    return round(65536 * half * random_double()) / 65536;
}

static void some_tried(struct tried *t)
{
    memset(t, 0, sizeof *t);
    t->face.any = true;
    for (int i = 0; i < 3; i++)
        t->half[i] = ldexp(1 + some_part(), -(int)(random_bits() % 6));
    for (int k = 0; k < 9; k++)
        t->face.at[k / 3][k % 3] = some_corner(t->half[k % 3]);
    t->packet.d = v3_of(real_random());
    t->packet.o = v3_scale(v3_of(real_random()), 4 * some_part());
}

/* Changes a value by a large or a very small amount. */
static void change(struct tried *t)
{
    double by = ldexp(random_double(), -(int)(random_bits() % 24));
    int k = (int)(random_bits() % 9);
    struct v3 off = v3_scale(v3_of(real_random()), by);
    double *at = &t->face.at[k / 3][k % 3], to = round(65536 * (*at + by)) / 65536;

    switch (random_bits() % 3) {
    case 0:
        *at = fabs(to) <= t->half[k % 3] ? to : *at;
        break;
    case 1:
        t->packet.d = v3_of(real_unit(real_of(v3_add(t->packet.d, off))));
        break;
    default:
        t->packet.o = v3_add(t->packet.o, off);
    }
}

static long double area_of(const struct sure_face *f, int edge, const struct packet *p)
{
    const double *from = f->at[edge], *to = f->at[(edge + 1) % 3];
    struct real a = {{from[0], from[1], from[2]}}, b = {{to[0], to[1], to[2]}}, o = real_of(p->o);

    return real_dot(real_of(p->d), real_cross(real_along(a, o, -1), real_along(b, o, -1)));
}

/* Returns the largest used part of an area's bound. */
static double used_by(const struct tried *t)
{
    static const uint32_t items[1] = {0};
    struct tia_vec3 vertices[3];
    struct tia_face face = {
        {{0, TIA_NO_INDEX, TIA_NO_INDEX}, {1, TIA_NO_INDEX, TIA_NO_INDEX}, {2, TIA_NO_INDEX, TIA_NO_INDEX}}};
    struct tia_mesh mesh = {.vertices = vertices, .faces = &face};
    const struct sure_flat flat = {.extent = 1};
    struct sure_tree tree = {.faces = &flat, .mesh = &mesh, .items = items, .node_count = 1};
    struct sure_node node = {.count = {1, 0}};
    struct sure_pair made;
    const struct sure_pair *pair = &made;
    struct lines l;
    double most = 0;

    for (int i = 0; i < 3; i++)
        vertices[i] = (struct tia_vec3){(tia_q16)(65536 * t->face.at[i][0]), (tia_q16)(65536 * t->face.at[i][1]),
                                        (tia_q16)(65536 * t->face.at[i][2])};
    tree.extent = t->half[0] + t->half[1] + t->half[2];
    (void)tia_sure_set_pairs(&made, &node, &tree);
    lines_of(&l, &t->packet, &tree);
    vp a = pair_edge(&l, pair->edge[0]), b = pair_edge(&l, pair->edge[1]), c = pair_dot(l.way, pair->whole) - a - b;
    const float area[3] = {a[0], b[0], c[0]}, e = (l.off + l.by * vp_load(pair->size))[0];
    for (int i = 0; i < 3; i++)
        most = fmax(most, fabs((double)(area_of(&t->face, i, &t->packet) - (long double)area[i])) / (double)e);
    return most;
}

/* Searches by climbing: roundings seldom add up, so the worse of two cases is kept. */
static void climb(struct used *u, int steps)
{
    struct tried best, next;
    double most;

    some_tried(&best);
    most = used_by(&best);
    for (int i = 0; i < steps; i++) {
        next = best;
        change(&next);
        double part = used_by(&next);
        best = part > most ? next : best;
        most = fmax(part, most);
        use(u, part, 1);
    }
}

TEST(areas)
{
    struct used u = {.name = "areas of edges"};

    for (int i = 0; i < 40; i++)
        climb(&u, 20000);
    check_used(&u);
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(areas);
    return check_status();
}
