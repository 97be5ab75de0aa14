/* The oracle's closed shapes against their insides, found by walking along rays. */
#include "check.h"
#include "oracle/shape.h"
#include "random.h"

static struct tia_transform transforms[1];

static bool meets(const struct tia_shape *shape, struct ray ray, struct hit *hit)
{
    struct tia_scene scene = {.shapes = shape, .transforms = transforms, .shape_count = 1, .transform_count = 1};

    return object_hit(&scene, 0, ray, hit);
}

/* True if a point of the shape's own space is inside the closed shapes below. */
static bool is_inside(enum tia_shape_kind kind, struct oracle_vec p)
{
    double out = sqrt(p.x * p.x + p.z * p.z);

    switch (kind) {
    case TIA_SPHERE:
        return length(p) < 1.5;
    case TIA_CYLINDER:
        return out < 1 && fabs(p.y) < 1;
    case TIA_CONE:
        return out < 1 - p.y / 2 && fabs(p.y) < 1;
    default:
        return fabs(p.x) < 1 && fabs(p.y) < 0.5 && fabs(p.z) < 1.5;
    }
}

static const struct tia_shape closed[] = {
    {.kind = TIA_SPHERE, .transform = 1, .sphere = {TIA_VEC3(0, 0, 0), TIA_Q16(1.5)}},
    {.kind = TIA_CYLINDER, .transform = 1, .cylinder = {TIA_VEC3(0, -1, 0), TIA_VEC3(0, 1, 0), TIA_Q16(1), true}},
    {.kind = TIA_CONE,
     .transform = 1,
     .cone = {TIA_VEC3(0, -1, 0), TIA_VEC3(0, 1, 0), TIA_Q16(1.5), TIA_Q16(0.5), true}},
    {.kind = TIA_BOX, .transform = 1, .box = {TIA_VEC3(-1, -0.5, -1.5), TIA_VEC3(1, 0.5, 1.5)}}};

static bool inside_at(const struct tia_shape *shape, struct ray r, double t)
{
    struct oracle_vec p = sub(at(r, t), position(transforms[0].position)), s = position(transforms[0].scale);

    p = transform_turn_back(&transforms[0], p);
    return is_inside(shape->kind, (struct oracle_vec){p.x / s.x, p.y / s.y, p.z / s.z});
}

/* Walks along a ray: up to the hit inside and outside do not change, there they do; the normal points out. */
static bool walk(const struct tia_shape *shape, struct ray r)
{
    bool start = inside_at(shape, r, 0);
    struct hit h;
    bool met = meets(shape, r, &h);
    double end = met ? h.t : 40;

    for (int i = 0; i < 400; i++)
        CHECK_MSG(inside_at(shape, r, end * i / 400) == start, "shape %d: changes before %g", shape->kind, end);
    if (!met)
        return false;
    CHECK_MSG(inside_at(shape, r, h.t + 1e-7) != start, "shape %d: no change at %g", shape->kind, h.t);
    struct ray out = {along(at(r, h.t), -1e-6, h.normal), h.normal};
    CHECK_MSG(inside_at(shape, out, 0) && !inside_at(shape, out, 2e-6), "shape %d: the normal", shape->kind);
    return true;
}

TEST(hits_are_where_the_inside_begins_and_ends)
{
    unsigned hits = 0;

    random_state = 11;
    for (int i = 0; i < 4000; i++) {
        struct tia_transform *t = &transforms[0];
        t->rotation =
            (struct tia_vec3){(tia_q16)(random_double() * TIA_Q16(180)), (tia_q16)(random_double() * TIA_Q16(180)),
                              (tia_q16)(random_double() * TIA_Q16(180))};
        t->scale = (struct tia_vec3){(tia_q16)((random_double() + 1.5) * TIA_Q16(1)),
                                     (tia_q16)((random_double() + 1.5) * TIA_Q16(1)), TIA_Q16(1)};
        t->position = (struct tia_vec3)TIA_VEC3(0.5, -0.25, 0);
        double spread = i % 3 ? 6 : 1;
        struct oracle_vec from = {spread * random_double(), spread * random_double(), spread * random_double()};
        struct oracle_vec to = {random_double(), random_double(), random_double()};
        hits += walk(&closed[i % 4], (struct ray){from, unit(sub(to, from))});
    }
    CHECK_MSG(hits > 2000, "only %u hits", hits);
}

int main(void)
{
    RUN(hits_are_where_the_inside_begins_and_ends);
    return check_status();
}
