/* search.h - looking for paths: images, the points where a path meets planes, and what is in its way. */
#ifndef TIA_RADIO_SEARCH_H
#define TIA_RADIO_SEARCH_H

#include "faces.h"
#include "number.h"

/* A point, x / w; w > 0. */
struct spot {
    struct number x[3], w;
};

#define SEARCH_NUMBERS 12
#define NO_PLANE UINT32_MAX

/* A ray on its way. */
struct search_ray {
    int64_t at[3], way; /* Q16.16: where it is, and how far that was */
    uint32_t last;      /* the plane that it comes from */
    struct tia_radio_ray told;
};

/* Images of a sequence of `order` planes, the first one nearest to the transmitter: sent[i] is the transmitter's after
 * reflections 0..i-1, got[i] the receiver's after the last i of them, the last one first. So the segment after i
 * reflections runs from sent[i] to got[order - i]. */
struct tia_radio_room {
    const struct tia_radio *radio;
    const struct tia_radio_link *link;
    uint32_t plane[TIA_RADIO_ORDER_MAX]; /* of the sequence, from the receiver's end */
    int side[TIA_RADIO_ORDER_MAX];       /* of reflection i's plane: the one that it comes from */
    struct tia_radio_path path, told;    /* while it is looked for; when it is found */
    union {                              /* an object below 32768 bytes also where a word has 16 bits */
        struct {
            struct spot sent[TIA_RADIO_ORDER_MAX + 1], got[TIA_RADIO_ORDER_MAX + 1];
            struct spot met; /* where a line meets a plane */
            struct number number[SEARCH_NUMBERS];
        } exact;
        struct search_ray rays[TIA_RADIO_ORDER_MAX + TIA_RADIO_WALLS_MAX + 2];
    };
};

/* Whether the caller's arguments of a search are there, and the link's numbers in their ranges. */
bool tia_radio_can_search(const struct tia_radio *radio, const struct tia_radio_room *room,
                          const struct tia_radio_link *link);

/* Whether its ends differ. */
bool tia_radio_has_ends(const struct tia_radio_link *link);

/* Reflection i of a sequence of `order`. */
static inline uint32_t search_plane(const struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    return room->plane[order - 1 - i];
}

/* Where `at` lies: n.x - d w, which is w |n| times its distance from the plane. `room` is for one number. */
void tia_radio_side(struct number *side, const struct radio_plane *plane, const struct spot *at, struct number *room);

/* at, mirrored; `side` is its side. */
void tia_radio_mirror(struct spot *out, const struct radio_plane *plane, const struct spot *at,
                      const struct number *side, struct number room[2]);

/* Where the line from a to b meets the plane that they lie on the sides `from` and `to` of: these have opposite signs.
 */
void tia_radio_meet(struct spot *out, const struct spot *a, const struct spot *b, const struct number *from,
                    const struct number *to, struct number *room);

void tia_radio_spot(struct spot *out, struct tia_vec3 point);

/* To nearest, ties up; false: beyond Q16.16. */
bool tia_radio_round(const struct spot *at, struct tia_vec3 *point, struct number room[2]);

/* Whether a point of the face's plane lies on the face or its edge. `room` is for 3 numbers. */
bool tia_radio_on_face(const struct tia_radio *radio, const struct radio_face *face, const struct spot *at,
                       struct number room[3]);

/* The first face of a plane that has the point and reflects what comes from the side of that sign; TIA_NO_INDEX: none.
 */
uint32_t tia_radio_face_at(struct tia_radio_room *room, const struct radio_plane *plane, const struct spot *at,
                           int side);

/* Finds the walls in the way of the segment after i reflections of `order`, whose points are in room->path.
 * False: more than the link allows. */
bool tia_radio_pass(struct tia_radio_room *room, uint32_t order, uint32_t i);

/* Whether there is a path by the first `order` planes of the room, from the receiver's end, whose images got[] are
 * there; fills in room->told. */
bool tia_radio_find(struct tia_radio_room *room, uint32_t order);

#endif
