/* planes.c - planes with integer coefficients, in a unique form that shows which planes are equal. */
#include "face_planes.h"

#include "math/sort.h"

static uint64_t divisor(uint64_t a, uint64_t b)
{
    while (b != 0) {
        uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static uint64_t size_of(int64_t a)
{
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

/* Divides a vector by the greatest common divisor of its components. Returns false if all are 0. */
static bool reduce(int64_t v[3])
{
    uint64_t g = divisor(divisor(size_of(v[0]), size_of(v[1])), size_of(v[2]));

    for (int k = 0; g > 1 && k < 3; k++)
        v[k] = v[k] < 0 ? -(int64_t)(size_of(v[k]) / g) : (int64_t)(size_of(v[k]) / g);
    return g != 0;
}

static bool below(const int64_t v[3], int bits)
{
    for (int k = 0; k < 3; k++)
        if (size_of(v[k]) >> bits != 0)
            return false;
    return true;
}

static struct radio_wide halves(wide a)
{
    return (struct radio_wide){wide_high(a), wide_low(a)};
}

/* Brings a plane with a reduced normal n to the unique form, and sets the fields that depend on n and `point`. Sets
 * *turned if n was negated. */
static void complete(struct radio_plane *plane, const struct tia_vec3 *point, bool *turned)
{
    int64_t *n = plane->n;
    const int64_t at[3] = {point->x, point->y, point->z};
    int most = 0;

    *turned = n[0] < 0 || (n[0] == 0 && (n[1] < 0 || (n[1] == 0 && n[2] < 0)));
    for (int k = 0; k < 3; k++) {
        n[k] = *turned ? -n[k] : n[k];
        most = size_of(n[k]) > size_of(n[most]) ? k : most;
    }
    plane->d = halves(wide_dot(n, at));
    plane->square = halves(wide_dot(n, n));
    plane->across[0] = (uint8_t)((most + 1) % 3);
    plane->across[1] = (uint8_t)((most + 2) % 3);
}

bool tia_radio_plane_by_corners(struct radio_plane *plane, const struct tia_vec3 corner[3], bool *turned,
                                bool *too_wide)
{
    int64_t a[3], b[3];

    for (int k = 0; k < 3; k++) {
        a[k] = radio_axis(&corner[1], k) - radio_axis(&corner[0], k);
        b[k] = radio_axis(&corner[2], k) - radio_axis(&corner[0], k);
    }
    bool flat = reduce(a) && reduce(b);
    *too_wide = !below(a, 31) || !below(b, 31);
    if (!flat || *too_wide)
        return false;
    for (int k = 0; k < 3; k++)
        plane->n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    if (!reduce(plane->n))
        return false;
    *too_wide = !below(plane->n, 62);
    complete(plane, &corner[0], turned);
    return !*too_wide;
}

void tia_radio_plane_by_normal(struct radio_plane *plane, struct tia_vec3 point, struct tia_dir3 normal, bool *turned)
{
    plane->n[0] = normal.x;
    plane->n[1] = normal.y;
    plane->n[2] = normal.z;
    (void)reduce(plane->n);
    complete(plane, &point, turned);
}

/* ---- equal planes ---- */

#define KEYS 10 /* number of 32-bit sort keys: the normal's components and d */

static uint32_t key(const struct radio_plane *plane, int i)
{
    uint64_t word = i < 6 ? (uint64_t)plane->n[i / 2] : i < 8 ? plane->d.low : (uint64_t)plane->d.high;

    return (uint32_t)(i % 2 ? word >> 32 : word);
}

static bool is_equal(const struct radio_plane *a, const struct radio_plane *b)
{
    for (int i = 0; i < KEYS; i++)
        if (key(a, i) != key(b, i))
            return false;
    return true;
}

static void sort(const struct tia_radio *radio, uint32_t *ids, uint32_t *room, uint32_t *keys)
{
    for (uint32_t f = 0; f < radio->face_count; f++)
        ids[f] = f;
    for (int i = 0; i < KEYS; i++) {
        for (uint32_t f = 0; f < radio->face_count; f++)
            keys[f] = key(&radio->planes[f], i);
        tia_sort_ids(ids, room, radio->face_count, keys);
    }
}

static void add_bounds(struct tia_bounds *to, const struct tia_bounds *more)
{
    to->min.x = more->min.x < to->min.x ? more->min.x : to->min.x;
    to->min.y = more->min.y < to->min.y ? more->min.y : to->min.y;
    to->min.z = more->min.z < to->min.z ? more->min.z : to->min.z;
    to->max.x = more->max.x > to->max.x ? more->max.x : to->max.x;
    to->max.y = more->max.y > to->max.y ? more->max.y : to->max.y;
    to->max.z = more->max.z > to->max.z ? more->max.z : to->max.z;
}

static void gather(struct tia_radio *radio, struct radio_plane *plane)
{
    plane->endless = plane->sides[0] = plane->sides[1] = false;
    plane->bounds = radio->boxes[radio->members[plane->first]];
    for (uint32_t i = 0; i < plane->count; i++) {
        uint32_t f = radio->members[plane->first + i];
        const struct radio_face *face = &radio->faces[f];
        plane->endless |= face->kind == RADIO_WHOLE;
        plane->sides[0] |= !face->solid || !face->turned;
        plane->sides[1] |= !face->solid || face->turned;
        add_bounds(&plane->bounds, &radio->boxes[f]);
    }
}

/* Sorting makes equal planes neighbours, with their faces in rising order. Planes are numbered in the order of their
 * first faces. */
void tia_radio_join_planes(struct tia_radio *radio, uint32_t *room)
{
    uint32_t count = radio->face_count, *ids = room, *first = room + count, *size = first + count;

    sort(radio, ids, first, size);
    for (uint32_t i = 0, start = 0; i < count; i++) {
        if (!is_equal(&radio->planes[ids[i]], &radio->planes[ids[start]]))
            start = i;
        size[ids[start]] = i - start + 1;
        first[ids[i]] = ids[start];
    }
    uint32_t planes = 0, members = 0;
    for (uint32_t f = 0; f < count; f++) {
        if (first[f] != f) {
            radio->faces[f].plane = radio->faces[first[f]].plane;
            continue;
        }
        radio->planes[planes] = radio->planes[f]; /* planes <= f */
        radio->planes[planes].first = members;
        radio->planes[planes].count = 0;
        radio->faces[f].plane = planes++;
        members += size[f];
    }
    radio->plane_count = planes;
    for (uint32_t f = 0; f < count; f++) {
        struct radio_plane *plane = &radio->planes[radio->faces[f].plane];
        radio->members[plane->first + plane->count++] = f;
    }
    for (uint32_t p = 0; p < planes; p++)
        gather(radio, &radio->planes[p]);
}
