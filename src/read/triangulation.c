#include "triangulation.h"

#include "math/integer.h"

static int sign(int64_t x)
{
    return (x > 0) - (x < 0);
}

/* Returns |x|. x is a difference of two coordinates: |x| < 2^32, so that the product of two such values fits in 64
 * bits. */
static uint64_t size(int64_t x)
{
    return (uint64_t)(x < 0 ? -x : x);
}

/* Returns 1 if c lies to the left of the line from a to b, 0 if on it, -1 if to the right: the sign of (b - a) x (c -
 * a), exact. */
static int side(const struct polygon_corner *a, const struct polygon_corner *b, const struct polygon_corner *c)
{
    int64_t bx = (int64_t)b->x - a->x, by = (int64_t)b->y - a->y;
    int64_t cx = (int64_t)c->x - a->x, cy = (int64_t)c->y - a->y;
    int first = sign(bx) * sign(cy), second = sign(by) * sign(cx);
    uint64_t p = size(bx) * size(cy), q = size(by) * size(cx);

    if (first != second)
        return first > second ? 1 : -1;
    return p == q ? 0 : p > q ? first : -first;
}

/* Adds a b to a two's complement sum; |a|, |b| < 2^32. */
static void add_product(struct tia_wide *sum, int64_t a, int64_t b)
{
    uint64_t product = size(a) * size(b);

    if ((a < 0) != (b < 0)) {
        sum->high -= sum->low < product;
        sum->low -= product;
    } else {
        sum->low += product;
        sum->high += sum->low < product;
    }
}

static struct tia_wide magnitude(struct tia_wide x)
{
    if (x.high >> 63)
        return (struct tia_wide){~x.high + !x.low, ~x.low + 1};
    return x;
}

static bool is_less(struct tia_wide a, struct tia_wide b)
{
    return a.high != b.high ? a.high < b.high : a.low < b.low;
}

static tia_q16 coordinate(const struct tia_vec3 *v, int axis)
{
    return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

/* Returns twice the signed area of the polygon projected to the axes u and v, exact. */
static struct tia_wide area_in(const struct polygon_corner *corners, uint32_t count, int u, int v)
{
    struct tia_wide sum = {0, 0};
    int64_t u0 = coordinate(&corners[0].point, u), v0 = coordinate(&corners[0].point, v);

    for (uint32_t i = 1; i + 1 < count; i++) {
        const struct tia_vec3 *a = &corners[i].point, *b = &corners[i + 1].point;
        add_product(&sum, coordinate(a, u) - u0, coordinate(b, v) - v0);
        add_product(&sum, -(coordinate(a, v) - v0), coordinate(b, u) - u0);
    }
    return sum;
}

/* Projects along the axis that gives the largest area; swaps the other two if the polygon would run clockwise. */
static void project(struct polygon_corner *corners, uint32_t count)
{
    struct tia_wide largest = area_in(corners, count, 0, 1);
    int u = 0, v = 1;

    for (int axis = 1; axis < 3; axis++) {
        struct tia_wide area = area_in(corners, count, axis, (axis + 1) % 3);
        if (is_less(magnitude(largest), magnitude(area))) {
            largest = area;
            u = axis;
            v = (axis + 1) % 3;
        }
    }
    bool clockwise = largest.high >> 63;
    for (uint32_t i = 0; i < count; i++) {
        corners[i].x = coordinate(&corners[i].point, clockwise ? v : u);
        corners[i].y = coordinate(&corners[i].point, clockwise ? u : v);
    }
}

/* Removes a corner from the polygon's counts. */
static void uncount(struct polygon *polygon, const struct polygon_corner *c)
{
    polygon->not_convex -= c->orientation < 1;
    polygon->flat -= !c->orientation;
    polygon->candidates -= c->ear != 0;
}

/* Computes the orientation of corner i from its current neighbours, and marks its `ear` as unknown. */
static void classify(struct polygon *polygon, uint32_t i)
{
    struct polygon_corner *c = &polygon->corners[i];

    uncount(polygon, c);
    c->orientation = (int8_t)side(&polygon->corners[c->prev], c, &polygon->corners[c->next]);
    c->ear = -1;
    polygon->not_convex += c->orientation < 1;
    polygon->flat += !c->orientation;
    polygon->candidates++;
}

void tia_polygon_begin(struct polygon *polygon, struct polygon_corner *corners, uint32_t count)
{
    *polygon = (struct polygon){.corners = corners, .left = count, .at = 1};
    project(corners, count);
    for (uint32_t i = 0; i < count; i++) {
        corners[i].prev = i ? i - 1 : count - 1;
        corners[i].next = i + 1 < count ? i + 1 : 0;
        corners[i].orientation = 1;
        corners[i].ear = 0;
    }
    for (uint32_t i = 0; i < count; i++)
        classify(polygon, i);
}

static bool coincide(const struct polygon_corner *a, const struct polygon_corner *b)
{
    return a->x == b->x && a->y == b->y;
}

/* True if corner q lies inside the counterclockwise triangle a, b, c or on its edges, so that its tip b cannot be cut
 * off. Corners at the same point as a or c do not count; there are some where a bridge leads to a hole and back. An
 * edge from such a corner into the triangle cannot cross the edges a b and b c, so it ends at a corner inside, which
 * counts. */
static bool blocks(const struct polygon_corner *q, const struct polygon_corner *a, const struct polygon_corner *b,
                   const struct polygon_corner *c)
{
    return side(a, b, q) >= 0 && side(b, c, q) >= 0 && side(c, a, q) >= 0 && !coincide(q, a) && !coincide(q, c);
}

static int32_t least(int32_t a, int32_t b, int32_t c)
{
    int32_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c)
{
    int32_t ab = a > b ? a : b;
    return ab > c ? ab : c;
}

/* True if corner i is an ear: it is convex and no other corner blocks it. Only corners that are not convex need to be
 * tested: if a convex corner lies in the triangle, so does a corner that is not convex. */
static bool is_ear(const struct polygon *polygon, uint32_t i)
{
    const struct polygon_corner *corners = polygon->corners, *b = &corners[i], *a = &corners[b->prev],
                                *c = &corners[b->next];
    int32_t left = least(a->x, b->x, c->x), right = most(a->x, b->x, c->x);
    int32_t low = least(a->y, b->y, c->y), high = most(a->y, b->y, c->y);

    if (b->orientation < 1)
        return false;
    if (!polygon->not_convex)
        return true;
    for (const struct polygon_corner *q = &corners[c->next]; q != a; q = &corners[q->next])
        if (q->orientation < 1 && q->x >= left && q->x <= right && q->y >= low && q->y <= high && blocks(q, a, b, c))
            return false;
    return true;
}

/* Finds the next corner with the given orientation. Returns false if there is none. */
static bool find_orientation(const struct polygon *polygon, int orientation, uint32_t *found)
{
    uint32_t i = polygon->at;

    for (uint32_t n = 0; n < polygon->left; n++, i = polygon->corners[i].next)
        if (polygon->corners[i].orientation == orientation) {
            *found = i;
            return true;
        }
    return false;
}

/* Finds an ear. A polygon without an ear is not simple; for it, returns a collinear corner, which covers no area, else
 * a convex corner, else any corner. Cutting off an ear can change only its two neighbours. So the number of tests is
 * linear in the number of corners, and the total time is quadratic. */
static uint32_t find_ear(struct polygon *polygon)
{
    uint32_t i = polygon->at;

    for (; polygon->candidates; i = polygon->corners[i].next) {
        struct polygon_corner *c = &polygon->corners[i];
        if (c->ear > 0 || (c->ear < 0 && is_ear(polygon, i)))
            return i;
        polygon->candidates -= c->ear != 0;
        c->ear = 0;
    }
    i = polygon->at;
    if (!polygon->flat || !find_orientation(polygon, 0, &i))
        (void)find_orientation(polygon, 1, &i);
    return i;
}

bool tia_polygon_next(struct polygon *polygon, uint32_t triangle[3])
{
    if (polygon->left < 3)
        return false;
    uint32_t i = find_ear(polygon);
    struct polygon_corner *tip = &polygon->corners[i], *prev = &polygon->corners[tip->prev],
                          *next = &polygon->corners[tip->next];

    triangle[0] = tip->prev;
    triangle[1] = i;
    triangle[2] = tip->next;
    polygon->left--;
    uncount(polygon, tip);
    prev->next = tip->next;
    next->prev = tip->prev;
    classify(polygon, tip->prev);
    classify(polygon, tip->next);
    /* continue after the neighbour: cutting off every other corner gives better triangles than a fan; but if this
     * corner was no ear, only its neighbours can be ears now */
    polygon->at = tip->ear ? next->next : tip->prev;
    return true;
}
