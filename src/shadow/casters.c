#include "casters.h"

#include "math/align.h"
#include "math/wide.h"
#include "scene/bvh/tree.h"

#define BOX_BITS 26
#define SEGMENT_BITS 28 /* longer segments are cut, so that products of two differences have fewer than 62 bits */
#define FAR_BITS 58
#define MOVED 48 /* largest movement: 8 by rounding the point, 1/2 by each of at most 36 halvings at either end */

/* ---- building ---- */

uint64_t tia_casters_size(uint64_t faces)
{
    return ALIGN(faces * sizeof(uint32_t)) + TREE_NODES(faces) * sizeof(struct tia_bvh_node) +
           ALIGN(faces * sizeof(struct tia_bounds));
}

static bool is_bounded(const struct tia_flat_scene *flat, uint32_t face)
{
    const struct tia_flat_face *f = &flat->faces[face];

    for (unsigned k = 0; k < tia_face_sides(f); k++)
        if (tia_flat_is_direction(flat, &flat->points[f->corner[k]]))
            return false;
    return true;
}

static void find_box(const struct tia_flat_scene *flat, uint32_t face, int64_t low[3], int64_t high[3])
{
    const struct tia_flat_face *f = &flat->faces[face];

    tia_flat_affine(flat, &flat->points[f->corner[0]], low);
    tia_flat_affine(flat, &flat->points[f->corner[0]], high);
    for (unsigned k = 1; k < tia_face_sides(f); k++) {
        int64_t p[3];
        tia_flat_affine(flat, &flat->points[f->corner[k]], p);
        for (int i = 0; i < 3; i++) {
            low[i] = p[i] < low[i] ? p[i] : low[i];
            high[i] = p[i] > high[i] ? p[i] : high[i];
        }
    }
}

static int find_shift(const struct tia_flat_scene *flat, struct cancel *cancel)
{
    uint64_t all = 0;

    for (uint32_t i = 0; i < flat->point_count && !cancelled(cancel, 1); i++) {
        int64_t p[3];
        tia_flat_affine(flat, &flat->points[i], p);
        for (int k = 0; k < 3; k++)
            all |= tia_flat_is_direction(flat, &flat->points[i]) ? 0 : (uint64_t)(p[k] < 0 ? -p[k] : p[k]);
    }
    int bits = all ? 64 - (int)tia_clz64(all) : 0;
    return bits > BOX_BITS ? bits - BOX_BITS : 0;
}

/* Returns a box in units of 2^shift, enlarged by MOVED on every side. Three units more allow for rounding down MOVED,
 * the box's upper corner and the segment's ends. */
static struct tia_bounds enlarged(const int64_t low[3], const int64_t high[3], int shift)
{
    int64_t more = (MOVED >> shift) + 3;

    return (struct tia_bounds){
        {(int32_t)((low[0] >> shift) - more), (int32_t)((low[1] >> shift) - more), (int32_t)((low[2] >> shift) - more)},
        {(int32_t)((high[0] >> shift) + more), (int32_t)((high[1] >> shift) + more),
         (int32_t)((high[2] >> shift) + more)}};
}

/* Bounded faces fill the items from the front, unbounded faces from the back. */
int tia_casters_build(struct tia_casters *casters, void *memory, const struct tia_flat_scene *flat,
                      struct cancel *cancel)
{
    uint32_t count = flat->face_count, first = 0, last = count, *items = memory;
    struct tia_bvh_node *nodes = (void *)((char *)memory + ALIGN((uint64_t)count * sizeof *items));
    struct tia_bounds *boxes = (void *)(nodes + TREE_NODES((uint64_t)count));

    casters->shift = find_shift(flat, cancel);
    for (uint32_t i = 0; i < count && !cancelled(cancel, 1); i++) {
        int64_t low[3], high[3];
        if (!is_bounded(flat, i)) {
            items[--last] = i;
            continue;
        }
        find_box(flat, i, low, high);
        boxes[first] = enlarged(low, high, casters->shift);
        items[first++] = i;
    }
    casters->unbounded = items + last;
    casters->unbounded_count = count - last;
    const struct bvh_items all = {items, boxes, 1, 1};
    uint32_t used = tia_bvh_build_range(nodes, &all, (struct bvh_range){0, first, 0}, cancel);
    casters->tree = (struct tia_bvh_tree){nodes, items, used, first};
    return cancel->stopped ? TIA_STOPPED : TIA_OK;
}

/* ---- the ends ---- */

/* Gives a r 2^-places, rounded down; r is below 2^63. False when the result is not below 2^FAR_BITS in magnitude. */
static bool scaled(int64_t a, int64_t r, int places, int64_t *out)
{
    wide product = wide_product(a, r);
    int bits = wide_bits(wide_size(product));

    *out = 0;
    if (bits - places > FAR_BITS)
        return false;
    if (bits)
        *out = places > 127 ? 0
               : places < 1 ? (int64_t)(wide_low(product) << -places)
                            : wide_down(product, (unsigned)places);
    return true;
}

/* Returns 1/a, with *places fraction bits; a > 0. */
static int64_t inverse(int64_t a, int *places)
{
    unsigned zeros = tia_clz64((uint64_t)a);

    *places = 126 - (int)zeros;
    return wide_reciprocal((uint64_t)a << zeros);
}

/* Gives the visible point, D/s, or in orthographic views (D.x, D.y, s) 2^fraction/D.w. False: the point is too far
 * away. */
static bool find_point(const struct tia_seen *seen, const struct tia_raster_grid *l, int64_t p[3])
{
    int64_t d[3] = {l->x + (int64_t)l->right * seen->x, l->y - (int64_t)l->down * seen->y, l->w};
    int places, own = 0;
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    int64_t r = inverse(flat ? l->w : seen->nearness, &places);

    if (flat) {
        d[2] = seen->nearness;
        places -= l->fraction;
        own = -seen->exponent;
    } else
        places += seen->exponent;
    return scaled(d[0], r, places, &p[0]) && scaled(d[1], r, places, &p[1]) && scaled(d[2], r, places + own, &p[2]);
}

static int64_t largest(const int64_t p[3])
{
    int64_t most = 0;

    for (int k = 0; k < 3; k++) {
        int64_t size = p[k] < 0 ? -p[k] : p[k];
        most = size > most ? size : most;
    }
    return most;
}

static int bits_of(int64_t a)
{
    return a ? 64 - (int)tia_clz64((uint64_t)a) : 0;
}

/* Gives the segment's end at the light. For a directional light the end is a point outside the root, in the light's
 * direction from the visible point: at least four times as far away as the root and the visible point. */
static void find_light(const struct tia_flat_scene *flat, const struct tia_casters *casters,
                       const tia_flat_light *light, const int64_t from[3], int64_t p[3])
{
    tia_flat_affine(flat, light, p);
    if (!tia_flat_is_direction(flat, light))
        return;
    int root = BOX_BITS + casters->shift + 1, point = bits_of(largest(from));
    int beyond = (point > root ? point : root) + 3 - bits_of(largest(p));
    for (int k = 0; k < 3; k++)
        p[k] = from[k] + p[k] * (INT64_C(1) << (beyond > 0 ? beyond : 0));
}

/* ---- cutting ---- */

static bool meet(const struct tia_bounds *box, int shift, const int64_t a[3], const int64_t b[3])
{
    const int32_t low[3] = {box->min.x, box->min.y, box->min.z}, high[3] = {box->max.x, box->max.y, box->max.z};

    for (int k = 0; k < 3; k++)
        if ((a[k] > b[k] ? a[k] : b[k]) >> shift < low[k] || (a[k] < b[k] ? a[k] : b[k]) >> shift > high[k])
            return false;
    return true;
}

/* Moves the end a, if it is far away, towards b, by cutting off parts that do not meet the root's box. False: no part
 * of the segment meets the box. */
static bool cut(const struct tia_casters *casters, int64_t a[3], const int64_t b[3])
{
    const struct tia_bounds *root = &casters->tree.nodes[0].bounds;
    int64_t most = INT64_C(1) << (SEGMENT_BITS + casters->shift), end[3] = {b[0], b[1], b[2]};

    while (largest(a) >= most) {
        int64_t middle[3] = {(a[0] + end[0]) >> 1, (a[1] + end[1]) >> 1, (a[2] + end[2]) >> 1};
        bool keep = meet(root, casters->shift, a, middle);
        if (!keep && !meet(root, casters->shift, middle, end))
            return false;
        for (int k = 0; k < 3; k++)
            *(keep ? &end[k] : &a[k]) = middle[k];
    }
    return true;
}

enum tia_segment_kind tia_segment_init(struct tia_segment *segment, const struct tia_casters *casters,
                                       const struct tia_seen *seen, const struct tia_flat_scene *flat,
                                       const tia_flat_light *light)
{
    int64_t a[3], b[3];

    if (!casters->tree.node_count)
        return TIA_SEGMENT_MISSES;
    if (!seen->nearness && flat->grid.projection != TIA_ORTHOGRAPHIC)
        return TIA_SEGMENT_FAR;
    if (!find_point(seen, &flat->grid, a))
        return TIA_SEGMENT_FAR;
    find_light(flat, casters, light, a, b);
    if (!cut(casters, a, b) || !cut(casters, b, a))
        return TIA_SEGMENT_MISSES;
    for (int k = 0; k < 3; k++) {
        a[k] >>= casters->shift;
        b[k] >>= casters->shift;
        segment->sum[k] = a[k] + b[k];
        segment->way[k] = b[k] - a[k];
    }
    return TIA_SEGMENT_INSIDE;
}

/* ---- walking ---- */

static int64_t size_of(int64_t a)
{
    return a < 0 ? -a : a;
}

/* True if no separating axis exists between segment and box, among the box's axes and their cross products with the
 * segment. */
static bool touches(const struct tia_segment *s, const struct tia_bounds *box)
{
    const int64_t size[3] = {(int64_t)box->max.x - box->min.x, (int64_t)box->max.y - box->min.y,
                             (int64_t)box->max.z - box->min.z};
    const int64_t c[3] = {s->sum[0] - box->min.x - box->max.x, s->sum[1] - box->min.y - box->max.y,
                          s->sum[2] - box->min.z - box->max.z};
    int64_t way[3];

    for (int k = 0; k < 3; k++) {
        way[k] = size_of(s->way[k]);
        if (size_of(c[k]) > way[k] + size[k])
            return false;
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        if (size_of(c[i] * s->way[j] - c[j] * s->way[i]) > size[i] * way[j] + size[j] * way[i])
            return false;
    }
    return true;
}

static void push(struct tia_segment_walk *w, uint32_t node)
{
    if (touches(&w->segment, &w->casters->tree.nodes[node].bounds))
        w->stack[w->depth++] = node;
}

void tia_segment_walk_start(struct tia_segment_walk *walk, const struct tia_casters *casters)
{
    walk->casters = casters;
    walk->depth = 0;
    push(walk, 0);
}

const struct tia_bvh_node *tia_segment_walk_leaf(struct tia_segment_walk *walk)
{
    while (walk->depth > 0) {
        uint32_t node = walk->stack[--walk->depth];
        const struct tia_bvh_node *at = &walk->casters->tree.nodes[node];
        if (at->count)
            return at;
        push(walk, node + 1);
        push(walk, at->index);
    }
    return NULL;
}
