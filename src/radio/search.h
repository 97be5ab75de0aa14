/* search.h - the search for paths: images, intersections of paths with planes, and walls that paths pass through. */
#ifndef TIA_RADIO_SEARCH_H
#define TIA_RADIO_SEARCH_H

#include "face_planes.h"
#include "long_number.h"

/* A point x/w; w, its weight, is above 0. */
struct spot {
    struct number x[3], w;
};

#define SEARCH_NUMBERS 12
#define NO_PLANE UINT32_MAX

/* A ray that is being traced. */
struct search_ray {
    int64_t at[3], way; /* Q16.16: position, and distance travelled */
    uint32_t last;      /* plane of the last reflection */
    struct tia_radio_ray result;
};

/* Working storage of a search. For a sequence of `order` planes, numbered from the transmitter, sent[i] is the
 * transmitter's image after reflections 0..i-1, and got[i] the receiver's image after the last i reflections in reverse
 * order. So the segment after i reflections lies on the line from sent[i] to got[order - i]. */
struct tia_radio_room {
    const struct tia_radio *radio;
    const struct tia_radio_link *link;
    uint32_t plane[TIA_RADIO_ORDER_MAX]; /* planes of the sequence, from the receiver's end */
    int side[TIA_RADIO_ORDER_MAX];       /* side from which the path comes to the plane of reflection i: 1 or -1 */
    struct tia_radio_path path, found;   /* the path during the search; the path found */
    union {                              /* below 32768 bytes, the limit of an object if size_t has 16 bits */
        struct {
            struct spot sent[TIA_RADIO_ORDER_MAX + 1], got[TIA_RADIO_ORDER_MAX + 1];
            struct spot met; /* intersection of a line and a plane */
            struct number number[SEARCH_NUMBERS];
        } exact;
        struct search_ray rays[TIA_RADIO_ORDER_MAX + TIA_RADIO_WALLS_MAX + 2];
    };
};

/* True if a search's arguments are not NULL, and the link's numbers are in range. */
bool tia_radio_can_search(const struct tia_radio *radio, const struct tia_radio_room *room,
                          const struct tia_radio_link *link);

/* True if the link's ends differ. */
bool tia_radio_has_ends(const struct tia_radio_link *link);

/* Returns the plane of reflection i in a sequence of `order` reflections. */
static inline uint32_t search_plane(const struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    return room->plane[order - 1 - i];
}

/* Computes on which side of a plane `at` is: n.x - d w, which is w |n| times the signed distance. `room` is working
 * storage for one number. */
void tia_radio_side(struct number *side, const struct radio_plane *plane, const struct spot *at, struct number *room);

/* Computes the mirror image of `at` in a plane; `side` is the result of tia_radio_side for `at`. */
void tia_radio_mirror(struct spot *out, const struct radio_plane *plane, const struct spot *at,
                      const struct number *side, struct number room[2]);

/* Computes the intersection of a plane and the line from a to b. `from` and `to`, the results of tia_radio_side for a
 * and b, have opposite signs.
 */
void tia_radio_meet(struct spot *out, const struct spot *a, const struct spot *b, const struct number *from,
                    const struct number *to, struct number *room);

void tia_radio_spot(struct spot *out, struct tia_vec3 point);

/* Rounds the point to Q16.16, to nearest, ties up. Returns false if it does not fit. */
bool tia_radio_round(const struct spot *at, struct tia_vec3 *point, struct number room[2]);

/* True if the point, which is in the face's plane, lies on the face or its edge. `room` is working storage for 3
 * numbers. */
bool tia_radio_on_face(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3]);

/* Returns the first face of a plane that contains the point and reflects on the given side, 1 or -1; TIA_NO_INDEX if
 * there is none. */
uint32_t tia_radio_face_at(struct tia_radio_room *room, const struct radio_plane *plane, const struct spot *at,
                           int side);

/* Adds to room->path the walls that the segment after i of `order` reflections passes through; the segment's ends are
 * there already. Returns false if there are more walls than the link allows. */
bool tia_radio_pass(struct tia_radio_room *room, uint32_t order, uint32_t i);

/* True if there is a path with reflections in the first `order` planes of room->plane; the images got[] must be set.
 * Stores the path in room->found. */
bool tia_radio_find(struct tia_radio_room *room, uint32_t order);

/* Writes direction i of tia_radio_directions(density), a unit vector, Q2.62. Returns a tia_status. */
int tia_radio_direction(uint32_t density, uint32_t i, int64_t direction[3]);

#endif
