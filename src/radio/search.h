/* search.h - the search for paths: images, intersections of a path with planes, and walls in its way. */
#ifndef TIA_RADIO_SEARCH_H
#define TIA_RADIO_SEARCH_H

#include "face_planes.h"
#include "long_number.h"

/* A point x / w; w > 0. */
struct spot {
    struct number x[3], w;
};

#define SEARCH_NUMBERS 12
#define NO_PLANE UINT32_MAX

/* A ray that is traced. */
struct search_ray {
    int64_t at[3], way; /* Q16.16: position, and distance travelled */
    uint32_t last;      /* the plane that it comes from */
    struct tia_radio_ray told;
};

/* Images of a sequence of `order` planes, the first one nearest to the transmitter: sent[i] is the transmitter's after
 * reflections 0..i-1, got[i] the receiver's after the last i of them, the last one first. So the segment after i
 * reflections runs from sent[i] to got[order - i]. */
struct tia_radio_room {
    const struct tia_radio *radio;
    const struct tia_radio_link *link;
    uint32_t plane[TIA_RADIO_ORDER_MAX]; /* planes of the sequence, from the receiver's end */
    int side[TIA_RADIO_ORDER_MAX];       /* side of reflection i's plane that the path comes from */
    struct tia_radio_path path, told;    /* the path during the search; the path found */
    union {                              /* below 32768 bytes: the largest object where a word has 16 bits */
        struct {
            struct spot sent[TIA_RADIO_ORDER_MAX + 1], got[TIA_RADIO_ORDER_MAX + 1];
            struct spot met; /* intersection of a line and a plane */
            struct number number[SEARCH_NUMBERS];
        } exact;
        struct search_ray rays[TIA_RADIO_ORDER_MAX + TIA_RADIO_WALLS_MAX + 2];
    };
};

/* True if the caller's arguments of a search are not NULL, and the link's numbers in their ranges. */
bool tia_radio_can_search(const struct tia_radio *radio, const struct tia_radio_room *room,
                          const struct tia_radio_link *link);

/* True if the link's ends differ. */
bool tia_radio_has_ends(const struct tia_radio_link *link);

/* Returns the plane of reflection i of a sequence of `order`. */
static inline uint32_t search_plane(const struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    return room->plane[order - 1 - i];
}

/* Gives the side of `at`: n.x - d w, which is w |n| times its distance from the plane. `room` is for one number. */
void tia_radio_side(struct number *side, const struct radio_plane *plane, const struct spot *at, struct number *room);

/* Gives the mirror image of `at`; `side` is its side. */
void tia_radio_mirror(struct spot *out, const struct radio_plane *plane, const struct spot *at,
                      const struct number *side, struct number room[2]);

/* Gives the intersection of the line from a to b and a plane; they lie on the sides `from` and `to` of it, which have
 * opposite signs.
 */
void tia_radio_meet(struct spot *out, const struct spot *a, const struct spot *b, const struct number *from,
                    const struct number *to, struct number *room);

void tia_radio_spot(struct spot *out, struct tia_vec3 point);

/* Rounds to nearest, ties up; false: beyond Q16.16. */
bool tia_radio_round(const struct spot *at, struct tia_vec3 *point, struct number room[2]);

/* True if the point, which is in the face's plane, lies on the face or its edge. `room` is for 3 numbers. */
bool tia_radio_on_face(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3]);

/* Returns the first face of a plane that has the point and reflects on the side of that sign; TIA_NO_INDEX: none. */
uint32_t tia_radio_face_at(struct tia_radio_room *room, const struct radio_plane *plane, const struct spot *at,
                           int side);

/* Finds the walls in the way of the segment after i reflections of `order`, whose points are in room->path.
 * False: more than the link allows. */
bool tia_radio_pass(struct tia_radio_room *room, uint32_t order, uint32_t i);

/* True if there is a path by the first `order` planes of the room, from the receiver's end, whose images got[] are set;
 * stores it in room->told. */
bool tia_radio_find(struct tia_radio_room *room, uint32_t order);

/* Gives direction i of tia_radio_directions(density), of length 1, Q2.62. */
int tia_radio_direction(uint32_t density, uint32_t i, int64_t direction[3]);

#endif
