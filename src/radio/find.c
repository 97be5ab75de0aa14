/* find.c - the image method: from the receiver's images back to the path. */
#include "search.h"

/* Indices into room->exact.number. */
enum { SCRATCH, FROM = 3, TO, BEFORE_FROM, BEFORE_TO, LEFT, RIGHT };

/* Returns -1 if the line from the transmitter's image to the receiver's meets plane i after plane i - 1, 0 if at the
 * same point, else 1. The numbers FROM and TO must be the images' sides of plane i, see tia_radio_side. The line meets
 * a plane at |from| / (|from| + |to|) of the way between the images; their weights are the same for both planes. */
static int order_of(struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    const struct radio_plane *plane = &room->radio->planes[search_plane(room, order, i - 1)];
    struct number *n = room->exact.number;

    tia_radio_side(&n[BEFORE_FROM], plane, &room->exact.sent[i], &n[SCRATCH]);
    tia_radio_side(&n[BEFORE_TO], plane, &room->exact.got[order - i], &n[SCRATCH]);
    tia_number_multiply(&n[LEFT], &n[BEFORE_FROM], &n[TO]);
    tia_number_multiply(&n[RIGHT], &n[FROM], &n[BEFORE_TO]);
    return tia_number_compare_sizes(&n[LEFT], &n[RIGHT]);
}

/* True if a part of a face is on the given side of a plane, 1 or -1; always true for discs and infinite planes. */
static bool reaches_beyond(const struct tia_radio *radio, uint32_t number, const struct radio_plane *plane, int side)
{
    const struct radio_face *face = &radio->faces[number];

    for (uint32_t i = 0; i < face->count && face->kind == RADIO_POLYGON; i++) {
        const struct tia_vec3 *corner = &radio->corners[face->corner[i]];
        const int64_t at[3] = {corner->x, corner->y, corner->z};
        if (wide_sign(wide_difference(wide_dot(plane->n, at), radio_get(plane->d))) == side)
            return true;
    }
    return face->kind != RADIO_POLYGON;
}

/* True if reflections i - 1 and i, which are at the same point of the line where their planes meet, may have this
 * order. `side` is the side of plane i from which the path comes. */
static bool looks_back(const struct tia_radio_room *room, uint32_t order, uint32_t i, int side)
{
    const struct tia_radio *radio = room->radio;
    uint32_t before = search_plane(room, order, i - 1), here = search_plane(room, order, i);

    return before < here && reaches_beyond(radio, room->path.face[i], &radio->planes[before], room->side[i - 1]) &&
           reaches_beyond(radio, room->path.face[i - 1], &radio->planes[here], side);
}

/* True if reflection i is valid: the line from the transmitter's image to the receiver's crosses the plane on a face,
 * after reflection i - 1. If so, also mirrors the transmitter's image. */
static bool reflects(struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    uint32_t number = search_plane(room, order, i);
    const struct radio_plane *plane = &room->radio->planes[number];
    const struct spot *a = &room->exact.sent[i], *b = &room->exact.got[order - i];
    struct number *n = room->exact.number;

    tia_radio_side(&n[FROM], plane, a, &n[SCRATCH]);
    tia_radio_side(&n[TO], plane, b, &n[SCRATCH]);
    int side = n[FROM].sign;
    if (side * n[TO].sign >= 0 || !plane->sides[side < 0])
        return false;
    int turn = i > 0 ? order_of(room, order, i) : -1;
    if (turn > 0)
        return false;
    tia_radio_meet(&room->exact.met, a, b, &n[FROM], &n[TO], &n[SCRATCH]);
    uint32_t face = tia_radio_face_at(room, plane, &room->exact.met, side);
    if (face == TIA_NO_INDEX || !tia_radio_round(&room->exact.met, &room->path.point[i], n))
        return false;
    room->path.face[i] = face;
    room->side[i] = side;
    if (turn == 0 && !looks_back(room, order, i, side))
        return false;
    tia_radio_mirror(&room->exact.sent[i + 1], plane, a, &n[FROM], n);
    return true;
}

/* ---- reporting a path ---- */

/* Writes the vector from sent[i] to got[order - i], times both weights and times 2^-shift, which makes it fit in 62
 * bits. Returns shift. */
static int vector_of(struct tia_radio_room *room, uint32_t order, uint32_t i, int64_t v[3])
{
    const struct spot *a = &room->exact.sent[i], *b = &room->exact.got[order - i];
    struct number *n = room->exact.number;
    int most = 0;

    for (int k = 0; k < 3; k++) {
        tia_number_multiply(&n[k + 1], &b->x[k], &a->w);
        tia_number_multiply(&n[0], &a->x[k], &b->w);
        tia_number_add(&n[k + 1], &n[0], -1);
        most = tia_number_bits(&n[k + 1]) > most ? tia_number_bits(&n[k + 1]) : most;
    }
    for (int k = 0; k < 3; k++) {
        v[k] = (int64_t)tia_number_part(&n[k + 1], most - 61);
        v[k] = n[k + 1].sign < 0 ? -v[k] : v[k];
    }
    return most - 61;
}

/* Returns the path's length: the length of the vector from the transmitter to the receiver's last image. Root and
 * weights have 61 or 62 bits; the total relative error is below 2^-57. */
static int64_t length_of(struct tia_radio_room *room, uint32_t order)
{
    int64_t v[3];
    int shift = vector_of(room, order, 0, v);
    int64_t root = wide_sqrt(wide_dot(v, v)); /* below 2^63 */
    struct number *n = room->exact.number;

    tia_number_multiply(&n[0], &room->exact.sent[0].w, &room->exact.got[order].w);
    int digits = tia_number_bits(&n[0]) - 62;
    int64_t weight = (int64_t)tia_number_part(&n[0], digits);
    /* root 2^shift / (weight 2^digits) in units of 2^-16 */
    int more = 60 - (TIA_RADIO_LENGTH_BITS - 16 + shift - digits);
    int64_t ratio = wide_quotient(root, weight, 60);
    return more <= 0 ? ratio << -more : (ratio + (INT64_C(1) << (more - 1))) >> more;
}

/* Stores the path in room->found. Unused elements are 0, so that equal paths have equal bytes. */
static void report(struct tia_radio_room *room, uint32_t order)
{
    struct tia_radio_path *path = &room->path, *found = &room->found;

    *found = (struct tia_radio_path){.order = order, .wall_count = path->wall_count};
    for (uint32_t i = 0; i < path->wall_count; i++)
        found->wall[i] = path->wall[i];
    for (uint32_t i = 0; i < order; i++) {
        found->face[i] = path->face[i];
        found->point[i] = path->point[i];
    }
    for (uint32_t i = 0; i <= order; i++) {
        int64_t v[3];
        (void)vector_of(room, order, i, v);
        (void)wide_normalise(v, found->direction[i]);
    }
    found->length = length_of(room, order);
}

bool tia_radio_find(struct tia_radio_room *room, uint32_t order)
{
    tia_radio_spot(&room->exact.sent[0], room->link->from);
    for (uint32_t i = 0; i < order; i++)
        if (!reflects(room, order, i))
            return false;
    room->path.wall_count = 0;
    for (uint32_t i = 0; i <= order; i++)
        if (!tia_radio_pass(room, order, i))
            return false;
    report(room, order);
    return true;
}
