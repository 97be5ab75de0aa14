#include "edges.h"

#include "math/sort.h"

/* ---- points ---- */

size_t tia_weld_room(uint32_t points)
{
    return 3 * (size_t)points * sizeof(uint32_t);
}

static uint32_t coordinate(const struct tia_vec3 *p, int axis)
{
    return (uint32_t)(axis == 0 ? p->x : axis == 1 ? p->y : p->z);
}

static bool are_equal(const struct tia_vec3 *a, const struct tia_vec3 *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

void tia_weld(uint32_t *first, const struct tia_vec3 *points, uint32_t count, void *room)
{
    uint32_t *ids = room, *other = ids + count, *keys = other + count;

    for (uint32_t i = 0; i < count; i++)
        ids[i] = i;
    for (int axis = 0; axis < 3; axis++) {
        for (uint32_t i = 0; i < count; i++)
            keys[i] = coordinate(&points[i], axis);
        tia_sort_ids(ids, other, count, keys);
    }
    for (uint32_t i = 0; i < count; i++)
        first[ids[i]] = i > 0 && are_equal(&points[ids[i]], &points[ids[i - 1]]) ? first[ids[i - 1]] : ids[i];
}

/* ---- edges ---- */

size_t tia_edges_room(uint32_t faces)
{
    return 4 * (size_t)TIA_SIDES * (size_t)faces * sizeof(uint32_t);
}

struct edges {
    const struct tia_flat_face *faces;
    uint32_t *across, *ids, *other, *low, *high; /* low, high: the ends of edge e, the lower index first */
    uint32_t count;
};

static uint32_t start(const struct edges *edges, uint32_t e)
{
    return edges->faces[e / TIA_SIDES].corner[e % TIA_SIDES];
}

static bool join_ends(const struct edges *edges, uint32_t a, uint32_t b)
{
    return edges->low[a] == edges->low[b] && edges->high[a] == edges->high[b];
}

static void list(struct edges *edges, uint32_t face)
{
    const struct tia_flat_face *f = &edges->faces[face];
    unsigned sides = tia_face_sides(f);

    for (unsigned k = 0; k < sides; k++) {
        uint32_t a = f->corner[k], b = f->corner[k + 1 < sides ? k + 1 : 0], e = TIA_SIDES * face + k;
        edges->across[e] = a == b ? e : TIA_NO_EDGE; /* an edge without length is across from itself */
        edges->low[e] = a < b ? a : b;
        edges->high[e] = a < b ? b : a;
        if (a != b)
            edges->ids[edges->count++] = e;
    }
}

/* Pairs the edges ids[from .. to - 1], which all have the same ends: each edge towards the higher index with one
 * towards the lower. False: an edge remains unpaired. */
static bool pair(const struct edges *edges, uint32_t from, uint32_t to)
{
    uint32_t up = from, down = from;

    for (;;) {
        while (up < to && start(edges, edges->ids[up]) != edges->low[edges->ids[up]])
            up++;
        while (down < to && start(edges, edges->ids[down]) == edges->low[edges->ids[down]])
            down++;
        if (up == to || down == to)
            return up == down;
        edges->across[edges->ids[up]] = edges->ids[down];
        edges->across[edges->ids[down]] = edges->ids[up];
        up++;
        down++;
    }
}

bool tia_edges_join(uint32_t *across, const struct tia_flat_face *faces, uint32_t count, void *room,
                    struct cancel *cancel)
{
    uint32_t most = TIA_SIDES * count, *ids = room;
    struct edges edges = {faces, across, ids, ids + most, ids + 2 * (size_t)most, ids + 3 * (size_t)most, 0};
    bool closed = true;

    for (uint32_t f = 0; f < count && !cancelled(cancel, 1); f++)
        list(&edges, f);
    if (!cancelled(cancel, edges.count))
        tia_sort_ids(edges.ids, edges.other, edges.count, edges.high);
    if (!cancelled(cancel, edges.count))
        tia_sort_ids(edges.ids, edges.other, edges.count, edges.low);
    for (uint32_t i = 0, next; i < edges.count && !cancelled(cancel, 1); i = next) {
        for (next = i + 1; next < edges.count && join_ends(&edges, edges.ids[i], edges.ids[next]); next++)
            ;
        closed = pair(&edges, i, next) && closed;
    }
    return closed;
}
