#include "polygon.h"

#include "math/integer.h"

static int sign(int64_t x)
{
    return (x > 0) - (x < 0);
}

/* |x|, the difference of two coordinates: below 2^32, so that products of two fit 64 bits. */
static uint64_t size(int64_t x)
{
    return (uint64_t)(x < 0 ? -x : x);
}

/* Whether c lies to the left (1) of the line from a to b, on it (0) or to the right (-1): the sign of
 * (b - a) x (c - a), exact. */
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

/* sum += a b in two's complement; |a|, |b| < 2^32. */
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

/* Twice the area, with its sign, that the polygon has along two axes: exact. */
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

/* Leaves the axis out along which the polygon is seen largest; the other two are swapped where it would
 * run clockwise. */
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

/* Takes a corner out of the counts. */
static void forget(struct polygon *polygon, const struct polygon_corner *c)
{
    polygon->not_convex -= c->turn < 1;
    polygon->flat -= !c->turn;
    polygon->candidates -= c->ear != 0;
}

/* The turn at corner i among its present neighbours. Whether it is an ear is no longer known. */
static void look_at(struct polygon *polygon, uint32_t i)
{
    struct polygon_corner *c = &polygon->corners[i];

    forget(polygon, c);
    c->turn = (int8_t)side(&polygon->corners[c->prev], c, &polygon->corners[c->next]);
    c->ear = -1;
    polygon->not_convex += c->turn < 1;
    polygon->flat += !c->turn;
    polygon->candidates++;
}

void tia_polygon_begin(struct polygon *polygon, struct polygon_corner *corners, uint32_t count)
{
    *polygon = (struct polygon){.corners = corners, .left = count, .at = 1};
    project(corners, count);
    for (uint32_t i = 0; i < count; i++) {
        corners[i].prev = i ? i - 1 : count - 1;
        corners[i].next = i + 1 < count ? i + 1 : 0;
        corners[i].turn = 1;
        corners[i].ear = 0;
    }
    for (uint32_t i = 0; i < count; i++)
        look_at(polygon, i);
}

static bool coincide(const struct polygon_corner *a, const struct polygon_corner *b)
{
    return a->x == b->x && a->y == b->y;
}

/* Whether q keeps the tip b of the convex triangle a, b, c from being cut off: it lies in the triangle or
 * on its edge. At a and c it does not - the bridge to a hole goes through the same points twice - for to go from
 * there into the triangle is to cross an edge. */
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

/* A corner is an ear when it is convex and no other one blocks it; convex ones never do, since with one
 * of them in the triangle there is always another that is not. */
static bool is_ear(const struct polygon *polygon, uint32_t i)
{
    const struct polygon_corner *corners = polygon->corners, *b = &corners[i], *a = &corners[b->prev],
                                *c = &corners[b->next];
    int32_t left = least(a->x, b->x, c->x), right = most(a->x, b->x, c->x);
    int32_t low = least(a->y, b->y, c->y), high = most(a->y, b->y, c->y);

    if (b->turn < 1)
        return false;
    if (!polygon->not_convex)
        return true;
    for (const struct polygon_corner *q = &corners[c->next]; q != a; q = &corners[q->next])
        if (q->turn < 1 && q->x >= left && q->x <= right && q->y >= low && q->y <= high && blocks(q, a, b, c))
            return false;
    return true;
}

/* The first corner with that turn. */
static bool find_turn(const struct polygon *polygon, int turn, uint32_t *found)
{
    uint32_t i = polygon->at;

    for (uint32_t n = 0; n < polygon->left; n++, i = polygon->corners[i].next)
        if (polygon->corners[i].turn == turn) {
            *found = i;
            return true;
        }
    return false;
}

/* An ear; where there is none, the polygon is not simple: then what covers nothing, or a convex corner,
 * or any. Cutting an ear off makes none of the others one, or no longer one, but its two neighbours: each
 * is looked at again at most twice, and the time stays within the square of the corners. */
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
    if (!polygon->flat || !find_turn(polygon, 0, &i))
        (void)find_turn(polygon, 1, &i);
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
    forget(polygon, tip);
    prev->next = tip->next;
    next->prev = tip->prev;
    look_at(polygon, tip->prev);
    look_at(polygon, tip->next);
    /* Not the neighbours: every other corner first makes better shapes than a fan. But where there was no ear
     * they are the only ones that may be one. */
    polygon->at = tip->ear ? next->next : tip->prev;
    return true;
}
