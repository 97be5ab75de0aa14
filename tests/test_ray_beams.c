/* src/simd/rays/beam_tmpl.h: a block of pixels does not see only the background if a box touches one of its rays, and
 * does if the box is away from all of them. Rays and distances are computed in long double. */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"

enum { TRIES = 20000 };

/* A scene of one box, seen by a block of pixels. */
struct look {
    struct sure_scene scene;
    struct ray_view view;
    struct sure_node node;
    struct sure_object object;
    uint32_t item;
    struct sure_block block;
};

/* Sets a camera as ray_camera.c does: a window of height/64 at the distance `away`. */
static void some_camera(struct sure_camera *c)
{
    struct real n = real_random(), u = real_aside(n), v = real_cross(n, u);

    *c = (struct sure_camera){.width = 16 + (int)(random_bits() % 2000), .height = 16 + (int)(random_bits() % 2000)};
    for (int i = 0; i < 3; i++) {
        c->eye[i] = ldexp(random_double(), (int)(random_bits() % 14));
        c->u[i] = (double)u.v[i];
        c->v[i] = (double)v.v[i];
        c->n[i] = (double)n.v[i];
    }
    c->side = 1;
    c->across = c->width / 64.0;
    c->upward = c->height / 64.0;
    c->left = -c->across / 2;
    c->top = c->upward / 2;
    c->away = c->upward / 2 * ldexp(1 + some_part(), (int)(random_bits() % 8) - 2);
}

static struct look *some_look(void)
{
    static struct look l;
    const struct sure_camera *c = &l.scene.camera;

    some_camera(&l.scene.camera);
    l.scene.view = &l.view;
    l.scene.objects = (struct sure_tree){.nodes = &l.node, .items = &l.item, .node_count = 1};
    l.object.kind = SURE_SPHERE;
    l.scene.object = &l.object;
    l.scene.extent = 3 << 14;
    l.block.scene = &l.scene;
    l.block.width = 1 + (int)(random_bits() % SURE_SIDE);
    l.block.height = 1 + (int)(random_bits() % SURE_SIDE);
    l.block.x = (int)(random_bits() % (unsigned)(c->width - l.block.width + 1));
    l.block.y = (int)(random_bits() % (unsigned)(c->height - l.block.height + 1));
    return &l;
}

/* Returns the direction through the place (x, y) of the block, 0..1 inside it. */
static struct real direction(const struct look *l, long double x, long double y)
{
    const struct sure_camera *c = &l->scene.camera;
    long double h = c->left + c->across * (l->block.x + x * l->block.width) / c->width;
    long double v = c->top - c->upward * (l->block.y + y * l->block.height) / c->height;
    struct real d;

    for (int i = 0; i < 3; i++)
        d.v[i] = c->u[i] * h + c->v[i] * v - (long double)c->n[i] * c->away;
    return real_unit(d);
}

/* Sets the box around a point. A box that starts there and extends into all directions at random contains it, too. */
static void set_box(struct look *l, const struct real *point, double size)
{
    for (int i = 0; i < 3; i++) {
        l->node.box[i][0] = nextafterf((float)(point->v[i] - (long double)(size * some_part())), -INFINITY);
        l->node.box[i + 3][0] = nextafterf((float)(point->v[i] + (long double)(size * some_part())), INFINITY);
        l->node.box[i][1] = l->node.box[i + 3][1] = SURE_NOWHERE;
    }
    l->node.index[0] = l->node.index[1] = 0;
    l->node.count[0] = 1;
    l->node.count[1] = 0;
}

static struct real eye_of(const struct look *l)
{
    const double *eye = l->scene.camera.eye;

    return (struct real){{eye[0], eye[1], eye[2]}};
}

/* A point on a ray of the block, most often on one through its edge. */
static struct real some_point(const struct look *l, long double t)
{
    unsigned edge = (unsigned)(random_bits() % 6);
    long double x = some_part(), y = some_part();

    x = edge == 0 ? 0 : edge == 1 ? 1 : x;
    y = edge == 2 ? 0 : edge == 3 ? 1 : y;
    return real_along(eye_of(l), direction(l, x, y), t);
}

TEST(touched)
{
    unsigned long free = 0;

    for (int k = 0; k < TRIES; k++) {
        struct look *l = some_look();
        long double t = ldexp(some_part(), (int)(random_bits() % 20) - 4);
        struct real p = some_point(l, t);
        set_box(l, &p, random_bits() % 2 ? 0 : (double)t * ldexp(some_part(), -(int)(random_bits() % 12)));
        free += sees_background(&l->block);
    }
    CHECK_EQ(free, 0);
}

/* Most boxes a hundredth of the block's width away from its edge are missed, but for those in narrow views far from the
 * origin, whose blocks are hardly wider than the margin; and so is the empty scene. */
TEST(missed)
{
    unsigned long free = 0;

    for (int k = 0; k < TRIES; k++) {
        struct look *l = some_look();
        long double x = random_bits() % 2 ? 1.01L : -.01L, y = some_part();
        struct real p = real_along(eye_of(l), direction(l, random_bits() % 2 ? x : y, x), 4096);
        set_box(l, &p, 0);
        free += sees_background(&l->block);
        l->scene.objects.node_count = 0;
        CHECK(sees_background(&l->block));
    }
    CHECK_MSG(free > TRIES * 3 / 4, "only %lu of %d are missed", free, TRIES);
}

/* What other tests decide: parallel rays, shapes without a box, and lights that are seen. */
TEST(left_to_packets)
{
    struct look *l = some_look();

    l->scene.objects.node_count = 0;
    CHECK(sees_background(&l->block));
    l->scene.camera.orthographic = true;
    CHECK(!sees_background(&l->block));
    l->scene.camera.orthographic = false;
    l->scene.unbounded_count = 1;
    CHECK(!sees_background(&l->block));
    l->scene.unbounded_count = 0;
    l->view.lit = true;
    CHECK(!sees_background(&l->block));
    l->view.lit = false;
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(touched);
    RUN(missed);
    RUN(left_to_packets);
    return check_status();
}
