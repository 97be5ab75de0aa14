/* mirror_images.c - images of points in planes, and intersections of lines and planes, in rational numbers. */
#include "search.h"

void tia_radio_spot(struct spot *out, struct tia_vec3 point)
{
    for (int k = 0; k < 3; k++)
        tia_number_set(&out->x[k], radio_axis(&point, k));
    tia_number_set(&out->w, 1);
}

void tia_radio_side(struct number *side, const struct radio_plane *plane, const struct spot *at, struct number *room)
{
    tia_number_times_wide(side, &at->w, radio_get(plane->d));
    side->sign = -side->sign;
    for (int k = 0; k < 3; k++) {
        if (plane->n[k] == 0)
            continue;
        tia_number_times(room, &at->x[k], plane->n[k]);
        tia_number_add(side, room, 1);
    }
}

/* The image is x (n.n) - 2 (n.x - d w) n over w (n.n). */
void tia_radio_mirror(struct spot *out, const struct radio_plane *plane, const struct spot *at,
                      const struct number *side, struct number room[2])
{
    wide square = radio_get(plane->square);

    for (int k = 0; k < 3; k++) {
        tia_number_times_wide(&out->x[k], &at->x[k], square);
        if (plane->n[k] == 0)
            continue;
        tia_number_times(&room[0], side, plane->n[k]);
        tia_number_add(&out->x[k], &room[0], -1);
        tia_number_add(&out->x[k], &room[0], -1);
    }
    tia_number_times_wide(&out->w, &at->w, square);
}

/* The distances of a and b from the plane are |from| / (a.w |n|) and |to| / (b.w |n|), so the intersection is |to| a +
 * |from| b, coordinates and weights alike. */
void tia_radio_meet(struct spot *out, const struct spot *a, const struct spot *b, const struct number *from,
                    const struct number *to, struct number *room)
{
    for (int k = 0; k < 4; k++) {
        struct number *sum = k < 3 ? &out->x[k] : &out->w;
        tia_number_multiply(sum, to, k < 3 ? &a->x[k] : &a->w);
        tia_number_multiply(room, from, k < 3 ? &b->x[k] : &b->w);
        sum->sign *= to->sign;
        tia_number_add(sum, room, from->sign);
    }
}

bool tia_radio_round(const struct spot *at, struct tia_vec3 *point, struct number room[2])
{
    int64_t v[3];

    for (int k = 0; k < 3; k++) {
        v[k] = tia_number_quotient(&at->x[k], &at->w, room);
        if (v[k] < INT32_MIN || v[k] > INT32_MAX)
            return false;
    }
    *point = (struct tia_vec3){(tia_q16)v[0], (tia_q16)v[1], (tia_q16)v[2]};
    return true;
}

/* ---- faces ---- */

/* Computes w times the distance of the point x/w from a corner c along axis k: x - c w. */
static void from_corner(struct number *out, const struct spot *at, const struct tia_vec3 *corner, int k,
                        struct number *room)
{
    tia_number_copy(out, &at->x[k]);
    tia_number_times(room, &at->w, radio_axis(corner, k));
    tia_number_add(out, room, -1);
}

/* Returns the side of the edge a -> b on which the point is, 1, 0 or -1, in the projection to the axes `across`. */
static int side_of_edge(const struct spot *at, const struct tia_vec3 *a, const struct tia_vec3 *b,
                        const uint8_t across[2], struct number room[3])
{
    int u = across[0], v = across[1];

    from_corner(&room[0], at, a, v, &room[1]);
    tia_number_times(&room[1], &room[0], radio_axis(b, u) - radio_axis(a, u));
    from_corner(&room[0], at, a, u, &room[2]);
    tia_number_times(&room[2], &room[0], radio_axis(b, v) - radio_axis(a, v));
    tia_number_add(&room[1], &room[2], -1);
    return room[1].sign;
}

static bool on_polygon(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3])
{
    bool left = false, right = false;

    for (unsigned i = 0; i < face->count && !(left && right); i++) {
        const struct tia_vec3 *a = &radio->corners[face->corner[i]];
        const struct tia_vec3 *b = &radio->corners[face->corner[(i + 1) % face->count]];
        int side = side_of_edge(at, a, b, radio->planes[face->plane].across, room);
        left |= side > 0;
        right |= side < 0;
    }
    return !(left && right);
}

static bool on_disc(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                    struct number room[3])
{
    tia_number_times(&room[0], &at->w, face->radius);
    tia_number_multiply(&room[2], &room[0], &room[0]);
    for (int k = 0; k < 3; k++) {
        from_corner(&room[0], at, &radio->corners[face->corner[0]], k, &room[1]);
        tia_number_multiply(&room[1], &room[0], &room[0]);
        tia_number_add(&room[2], &room[1], -1);
    }
    return room[2].sign >= 0;
}

bool tia_radio_on_face(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3])
{
    return face->kind == RADIO_POLYGON ? on_polygon(radio, face, at, room)
           : face->kind == RADIO_DISC  ? on_disc(radio, face, at, room)
                                       : true;
}

static bool in_box(const struct tia_bounds *box, const struct tia_vec3 *p)
{
    return p->x >= box->min.x && p->x <= box->max.x && p->y >= box->min.y && p->y <= box->max.y && p->z >= box->min.z &&
           p->z <= box->max.z;
}

/* Tests a triangle's bounding box first: rounding to nearest never moves a point out of it, since its corners are
 * integers. The sides of a rotated box are slightly off their plane, and so are their bounding boxes: for these only
 * the exact test counts. */
uint32_t tia_radio_face_at(struct tia_radio_room *room, const struct radio_plane *plane, const struct spot *at,
                           int side)
{
    const struct tia_radio *radio = room->radio;
    bool asks_boxes = plane->count > 4;
    struct tia_vec3 near = {0, 0, 0};

    if (asks_boxes && !tia_radio_round(at, &near, &room->exact.number[0]))
        return TIA_NO_INDEX;
    for (uint32_t i = 0; i < plane->count; i++) {
        uint32_t f = radio->members[plane->first + i];
        const struct radio_face *face = &radio->faces[f];
        if (face->solid && (side > 0) == face->turned)
            continue;
        if (asks_boxes && face->kind == RADIO_POLYGON && face->count == 3 && !in_box(&radio->boxes[f], &near))
            continue;
        if (tia_radio_on_face(radio, face, at, &room->exact.number[0]))
            return f;
    }
    return TIA_NO_INDEX;
}
