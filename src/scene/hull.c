/* hull.c - tight boxes around shapes.
 *
 * A point p in the shape's own axes is at position + R S p in the world, where R is the rotation and S the scale. The
 * coordinate of R S p along the world's axis k is w.p, where w is row k of R S. So a shape's extent along k is its
 * extent along w in its own axes: r |w| for a sphere, the sum of |w_i c_i| for a box with the corners (+-c_0, +-c_1,
 * +-c_2), r |w x N| / |N| for a disc.
 *
 * Rows are Q11.52, since scales are at most 2^10; sums are Q31.32. A length is rounded up by at most 2^-30 of itself.
 * All other rounding errors together are far below 2^-16, the margin that tia_bounds_with_margin adds.
 */
#include "hull.h"

#include "math/integer.h"
#include "math/rotation.h"

/* A length: mantissa 2^exponent. */
struct length {
    uint64_t mantissa;
    int exponent;
};

#define ONE (INT64_C(1) << 52)

void tia_frame_prepare(struct frame *frame, const struct tia_transform *t)
{
    if (!t) {
        *frame = (struct frame){{{ONE, 0, 0}, {0, ONE, 0}, {0, 0, ONE}}, {0, 0, 0}};
        return;
    }
    const tia_q16 scale[3] = {t->scale.x, t->scale.y, t->scale.z};
    int64_t axes[3][3];

    tia_rotation_axes(t->rotation, axes);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            frame->rows[k][i] = tia_scaled_product(axes[i][k], scale[i], 62 + 16 - 52);
    frame->position[0] = t->position.x * (INT64_C(1) << 16);
    frame->position[1] = t->position.y * (INT64_C(1) << 16);
    frame->position[2] = t->position.z * (INT64_C(1) << 16);
}

static void include(struct hull *hull, int k, int64_t value, int64_t reach)
{
    if (value - reach < hull->min[k])
        hull->min[k] = value - reach;
    if (value + reach > hull->max[k])
        hull->max[k] = value + reach;
}

/* Products of Q.52 and Q.16 are rounded to Q.32. */
int64_t tia_frame_place(const struct frame *frame, int k, struct tia_vec3 p)
{
    const int64_t *w = frame->rows[k];
    return frame->position[k] + tia_scaled_product(w[0], p.x, 36) + tia_scaled_product(w[1], p.y, 36) +
           tia_scaled_product(w[2], p.z, 36);
}

int64_t tia_frame_place_finely(const struct frame *frame, int k, const int64_t p[3])
{
    const int64_t *w = frame->rows[k];
    return frame->position[k] + tia_scaled_product(w[0], p[0], 52) + tia_scaled_product(w[1], p[1], 52) +
           tia_scaled_product(w[2], p[2], 52);
}

static uint64_t size_of(int64_t x)
{
    return (uint64_t)(x < 0 ? -x : x);
}

/* Returns |v| rounded up or down, with a relative error of at most 2^-30. Components of v are below 2^62. */
static struct length measure(const int64_t v[3], bool up)
{
    uint64_t all = size_of(v[0]) | size_of(v[1]) | size_of(v[2]), square = 0;

    if (!all)
        return (struct length){0, 0};
    int shift = 33 - (int)tia_clz64(all); /* the largest component then has 31 bits */
    for (int i = 0; i < 3; i++) {
        uint64_t size = size_of(v[i]), rest = shift > 0 && up ? (UINT64_C(1) << shift) - 1 : 0;
        size = shift > 0 ? (size + rest) >> shift : size << -shift;
        square += size * size; /* three squares of at most 2^62 */
    }
    uint64_t root = tia_sqrt64(square);
    return (struct length){root + (up && root * root < square), shift};
}

/* Returns a/b, rounded up. The mantissas have at most 32 bits; b's has at least 31. */
static struct length ratio(struct length a, struct length b)
{
    return (struct length){((a.mantissa << 31) + b.mantissa - 1) / b.mantissa, a.exponent - b.exponent - 31};
}

/* Returns radius times length, rounded up, in units of 2^-32. The length is mantissa 2^exponent, in units of 2^-52. */
static int64_t stretch(tia_q16 radius, struct length length)
{
    struct tia_wide p = tia_wide_product((uint32_t)radius, length.mantissa);
    int shift = 36 - length.exponent;

    if (shift <= 0)
        return (int64_t)(p.low << -shift);
    if (shift >= 64)
        return p.high | p.low ? 1 : 0; /* at most 2 units of 2^-32; the margin covers one */
    bool exact = !(p.low & ((UINT64_C(1) << shift) - 1));
    return (int64_t)(p.high << (64 - shift) | p.low >> shift) + !exact;
}

void tia_hull_add_point(struct hull *hull, struct tia_vec3 p)
{
    for (int k = 0; k < 3; k++)
        include(hull, k, tia_frame_place(hull->frame, k, p), 0);
}

void tia_hull_add_sphere(struct hull *hull, struct tia_vec3 centre, tia_q16 radius)
{
    for (int k = 0; k < 3; k++) {
        struct length length = measure(hull->frame->rows[k], true);
        include(hull, k, tia_frame_place(hull->frame, k, centre), stretch(radius, length));
    }
}

/* Adds only the two outermost corners along each axis of the world. */
void tia_hull_add_box(struct hull *hull, const struct tia_bounds *b)
{
    if (b->max.x < b->min.x)
        return;
    for (int k = 0; k < 3; k++) {
        const int64_t *w = hull->frame->rows[k];
        bool x = w[0] < 0, y = w[1] < 0, z = w[2] < 0;
        struct tia_vec3 most = {x ? b->min.x : b->max.x, y ? b->min.y : b->max.y, z ? b->min.z : b->max.z};
        struct tia_vec3 least = {x ? b->max.x : b->min.x, y ? b->max.y : b->min.y, z ? b->max.z : b->min.z};
        include(hull, k, tia_frame_place(hull->frame, k, most), 0);
        include(hull, k, tia_frame_place(hull->frame, k, least), 0);
    }
}

/* The products in w x N, of 62-bit and 33-bit factors, lose their lowest 34 bits. If the disc is perpendicular to the
 * axis, the products cancel; the remaining bits are then enough. */
void tia_hull_add_ring(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, tia_q16 tube, const int64_t normal[3])
{
    const struct length whole = measure(normal, false);

    for (int k = 0; k < 3; k++) {
        const int64_t *w = hull->frame->rows[k];
        int64_t cross[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, l = (i + 2) % 3;
            cross[i] = tia_scaled_product(w[j], normal[l], 34) - tia_scaled_product(w[l], normal[j], 34);
        }
        struct length part = measure(cross, true);
        part.exponent += 34;
        int64_t around = tube ? stretch(tube, measure(w, true)) : 0;
        include(hull, k, tia_frame_place(hull->frame, k, centre), stretch(radius, ratio(part, whole)) + around);
    }
}

void tia_hull_add_disc(struct hull *hull, struct tia_vec3 centre, tia_q16 radius, const int64_t normal[3])
{
    tia_hull_add_ring(hull, centre, radius, 0, normal);
}

/* The axis is shifted left until its largest component has 33 bits, so that tia_hull_add_disc loses little
 * precision. */
void tia_hull_add_ends(struct hull *hull, struct tia_vec3 base, struct tia_vec3 top, tia_q16 base_radius,
                       tia_q16 top_radius)
{
    int64_t axis[3] = {(int64_t)top.x - base.x, (int64_t)top.y - base.y, (int64_t)top.z - base.z};
    unsigned room = tia_clz64(size_of(axis[0]) | size_of(axis[1]) | size_of(axis[2])) - 31;

    for (int i = 0; i < 3; i++)
        axis[i] *= INT64_C(1) << room;
    tia_hull_add_disc(hull, base, base_radius, axis);
    tia_hull_add_disc(hull, top, top_radius, axis);
}

void tia_bounds_add(struct tia_bounds *bounds, const struct tia_bounds *more)
{
#define ADD(c)                                                                                                         \
    bounds->min.c = more->min.c < bounds->min.c ? more->min.c : bounds->min.c;                                         \
    bounds->max.c = more->max.c > bounds->max.c ? more->max.c : bounds->max.c
    ADD(x);
    ADD(y);
    ADD(z);
#undef ADD
}

/* Enlarges the bounds so that they include a face. */
static inline void add_face(struct tia_bounds *bounds, const struct tia_mesh *mesh, uint32_t face)
{
    for (int i = 0; i < 3; i++) {
        const struct tia_vec3 *p = &mesh->vertices[mesh->faces[face].corner[i].vertex];
        bounds->min.x = p->x < bounds->min.x ? p->x : bounds->min.x;
        bounds->min.y = p->y < bounds->min.y ? p->y : bounds->min.y;
        bounds->min.z = p->z < bounds->min.z ? p->z : bounds->min.z;
        bounds->max.x = p->x > bounds->max.x ? p->x : bounds->max.x;
        bounds->max.y = p->y > bounds->max.y ? p->y : bounds->max.y;
        bounds->max.z = p->z > bounds->max.z ? p->z : bounds->max.z;
    }
}

struct tia_bounds tia_bounds_of_face(const struct tia_mesh *mesh, uint32_t face)
{
    struct tia_bounds bounds = BOUNDS_NOTHING;

    add_face(&bounds, mesh, face);
    return bounds;
}

struct tia_bounds tia_bounds_of_mesh(const struct tia_mesh *mesh, struct cancel *cancel)
{
    struct tia_bounds bounds = BOUNDS_NOTHING;

    for (uint32_t i = 0; i < mesh->face_count && !cancelled(cancel, 1); i++)
        add_face(&bounds, mesh, i);
    return bounds;
}
