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

/* A ray that is traced. */
struct search_ray {
    int64_t at[3], way; /* Q16.16: position, and distance travelled */
    uint32_t last;      /* plane of the last reflection */
    struct tia_radio_ray result;
};

/* Memory of a search, with the images for a sequence of `order` planes, numbered from the transmitter: sent[i] is the
 * transmitter's image after reflections 0..i-1, got[i] the receiver's after the last i reflections, in reverse order.
 * So the segment after i reflections lies on the line from sent[i] to got[order - i]. */
struct tia_radio_room {
    const struct tia_radio *radio;
    const struct tia_radio_link *link;
    uint32_t plane[TIA_RADIO_ORDER_MAX]; /* planes of the sequence, from the receiver's end */
    int side[TIA_RADIO_ORDER_MAX];       /* side from which the path comes to the plane of reflection i: 1 or -1 */
    struct tia_radio_path path, found;   /* the path during the search; the path found */
    union {                              /* below 32768 bytes: the largest object where a word has 16 bits */
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

/* Returns the plane of reflection i of a sequence of `order`. */
static inline uint32_t search_plane(const struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    return room->plane[order - 1 - i];
}

/* Gives the side of a plane on which `at` is: n.x - d w, that is w |n| times the distance, with its sign. `room` is for
 * one number. */
void tia_radio_side(struct number *side, const struct radio_plane *plane, const struct spot *at, struct number *room);

/* Gives the mirror image of `at` in a plane; `side` is that of `at`, from tia_radio_side. */
void tia_radio_mirror(struct spot *out, const struct radio_plane *plane, const struct spot *at,
                      const struct number *side, struct number room[2]);

/* Gives the intersection of a plane and the line from a to b, whose sides of the plane, `from` and `to`, have opposite
 * signs.
 */
void tia_radio_meet(struct spot *out, const struct spot *a, const struct spot *b, const struct number *from,
                    const struct number *to, struct number *room);

void tia_radio_spot(struct spot *out, struct tia_vec3 point);

/* Gives the point in Q16.16, rounded to nearest, ties up; false when it does not fit. */
bool tia_radio_round(const struct spot *at, struct tia_vec3 *point, struct number room[2]);

/* True if the point, which is in the face's plane, lies on the face or its edge. `room` is for 3 numbers. */
bool tia_radio_on_face(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3]);

/* Returns the first face of a plane that contains the point and reflects on the given side, 1 or -1, or
 * TIA_NO_INDEX. */
uint32_t tia_radio_face_at(struct tia_radio_room *room, const struct radio_plane *plane, const struct spot *at,
                           int side);

/* Finds the walls that the segment after i of `order` reflections passes through; its ends are in room->path. False:
 * more walls than the link allows. */
bool tia_radio_pass(struct tia_radio_room *room, uint32_t order, uint32_t i);

/* True if a path has reflections in the room's first `order` planes, which are in order from the receiver, with the
 * images got[] set; stores the path in room->found. */
bool tia_radio_find(struct tia_radio_room *room, uint32_t order);

/* Gives direction i of tia_radio_directions(density), of length 1, Q2.62. Returns a tia_status. */
int tia_radio_direction(uint32_t density, uint32_t i, int64_t direction[3]);

#endif
