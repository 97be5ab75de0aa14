#include "solid.h"

#include "math/integer.h"

/* The stack of operands is the bits of a word, the topmost in bit 0. */
bool tia_solid_holds(const struct tia_solid *solid, uint32_t inside)
{
    uint32_t stack = 0;

    for (uint32_t i = 0; i < solid->step_count; i++) {
        uint32_t upper = stack & 1, lower = stack >> 1 & 1, rest = stack >> 2 << 1;

        switch (solid->steps[i]) {
        case TIA_SOLID_MEMBER:
            stack = stack << 1 | (inside & 1);
            inside >>= 1;
            break;
        case TIA_SOLID_UNION:
            stack = rest | lower | upper;
            break;
        case TIA_SOLID_INTERSECTION:
            stack = rest | (lower & upper);
            break;
        default:
            stack = rest | (lower & ~upper);
        }
    }
    return stack & 1;
}

static const struct tia_bounds everywhere = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};

/* Returns the box of the half-space behind a plane: it is bounded if the plane is perpendicular to an axis. */
static struct tia_bounds behind(const struct tia_plane *plane)
{
    const struct tia_dir3 *n = &plane->normal;
    const struct tia_vec3 *p = &plane->point;
    struct tia_bounds box = everywhere;

    if (!n->y && !n->z)
        *(n->x > 0 ? &box.max.x : &box.min.x) = p->x;
    if (!n->z && !n->x)
        *(n->y > 0 ? &box.max.y : &box.min.y) = p->y;
    if (!n->x && !n->y)
        *(n->z > 0 ? &box.max.z : &box.min.z) = p->z;
    return box;
}

const struct shape_description *tia_solid_member_kind(const struct tia_shape *shape)
{
    switch (shape->kind) {
    case TIA_SPHERE:
        return &tia_sphere_description;
    case TIA_PLANE:
        return &tia_plane_description;
    case TIA_BOX:
        return &tia_box_description;
    case TIA_CYLINDER:
        return shape->cylinder.capped ? &tia_cylinder_description : NULL;
    case TIA_CONE:
        return shape->cone.capped ? &tia_cone_description : NULL;
    case TIA_TORUS:
        return &tia_torus_description;
    case TIA_ROUNDED:
        return &tia_rounded_description;
    default:
        return NULL;
    }
}

bool tia_solid_member_box(const struct tia_scene *scene, const struct tia_shape *member, struct bounds_wide *box)
{
    const struct shape_description *kind = tia_solid_member_kind(member);
    struct frame frame;
    struct hull hull = {&frame, {INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};

    if (!kind || !kind->add_bounds)
        return false;
    tia_frame_prepare(&frame, member->transform ? &scene->transforms[member->transform - 1] : NULL);
    kind->add_bounds(&hull, scene, member);
    for (int k = 0; k < 3; k++) {
        box->min[k] = hull.min[k] >> 16;
        box->max[k] = (hull.max[k] + 0xffff) >> 16;
    }
    return true;
}

static struct tia_bounds member_box(const struct tia_scene *scene, const struct tia_shape *member)
{
    struct bounds_wide wide;

    if (member->kind == TIA_PLANE)
        return behind(&member->plane);
    if (!tia_solid_member_box(scene, member, &wide))
        return everywhere;
    const int64_t *min = wide.min, *max = wide.max;
    return (struct tia_bounds){{tia_saturate_s32(min[0]), tia_saturate_s32(min[1]), tia_saturate_s32(min[2])},
                               {tia_saturate_s32(max[0]), tia_saturate_s32(max[1]), tia_saturate_s32(max[2])}};
}

/* Keeps of a range what it shares with another one; at least one number. */
static void share(tia_q16 *min, tia_q16 *max, tia_q16 other_min, tia_q16 other_max)
{
    *min = other_min > *min ? other_min : *min;
    *max = other_max < *max ? other_max : *max;
    *max = *max < *min ? *min : *max;
}

static void combine(struct tia_bounds *lower, const struct tia_bounds *upper, unsigned step)
{
    if (step == TIA_SOLID_UNION)
        tia_bounds_add(lower, upper);
    if (step != TIA_SOLID_INTERSECTION)
        return;
    share(&lower->min.x, &lower->max.x, upper->min.x, upper->max.x);
    share(&lower->min.y, &lower->max.y, upper->min.y, upper->max.y);
    share(&lower->min.z, &lower->max.z, upper->min.z, upper->max.z);
}

struct tia_bounds tia_solid_box(const struct tia_scene *scene, const struct tia_solid *solid)
{
    struct tia_bounds stack[TIA_SOLID_DEPTH];
    const struct tia_shape *member = solid->members;
    uint32_t depth = 0;

    for (uint32_t i = 0; i < solid->step_count; i++) {
        if (solid->steps[i] == TIA_SOLID_MEMBER) {
            stack[depth++] = member_box(scene, member++);
            continue;
        }
        depth--;
        combine(&stack[depth - 1], &stack[depth], solid->steps[i]);
    }
    return stack[0];
}

bool tia_solid_is_bounded(const struct tia_bounds *b)
{
    return b->min.x > INT32_MIN && b->min.y > INT32_MIN && b->min.z > INT32_MIN && b->max.x < INT32_MAX &&
           b->max.y < INT32_MAX && b->max.z < INT32_MAX;
}
