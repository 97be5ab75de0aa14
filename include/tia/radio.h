/* radio.h - paths of radio waves from a transmitter to a receiver, by mirror reflections at flat faces.
 *
 * Pure geometry, in integers. Corners are rounded once, to Q16.16; after that, the existence of paths is decided
 * exactly: images, points on faces and obstructions are computed in rational numbers with as many digits as they need.
 * Only the reported values are rounded.
 *
 * Faces are boxes' sides, triangles, meshes' triangles, planes and discs without a transform; and the faces of divided
 * curved shapes, in scenes that have `tessellated`. Other objects are left out: they neither reflect nor block. All
 * faces in one plane are one reflector, so that a path through an edge between two of them is found once, at the face
 * of the lowest number. Both sides of a face reflect, but a box is solid: only its outside does.
 *
 * Ties. A face includes its edges: a path that touches an edge of another face is blocked. A path that runs within the
 * plane of a face is not blocked by it. Two successive points may coincide on the line where two planes meet, if the
 * two faces there face each other and the first one's plane has the lower number. So the two paths through the inner
 * edge of a right angle, by either face first, count as one, and at an outer edge there is none.
 */
#ifndef TIA_RADIO_H
#define TIA_RADIO_H

#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_RADIO_ORDER_MAX 8    /* reflections of a path */
#define TIA_RADIO_WALLS_MAX 8    /* walls that a path passes through */
#define TIA_RADIO_LENGTH_BITS 41 /* fraction bits of a path's length */
#define TIA_RADIO_NO_OBJECT UINT32_MAX

struct tia_radio;      /* the faces of a scene */
struct tia_radio_room; /* working memory of a search */

struct tia_radio_counts {
    uint32_t faces, planes; /* number of faces, and of the distinct planes in which they lie */
    uint32_t left_out;      /* number of objects without flat faces */
};

struct tia_radio_face {
    uint32_t object, material; /* indices in the scene */
    uint32_t plane;            /* number of the face's plane */
    bool solid;                /* a side of a box; the normal then points outwards */
    int64_t normal[3];         /* unit normal, Q2.62 */
    tia_q16 thickness;         /* thickness of a box, from this side to the opposite one; else 0 */
};

/* A wall that a path passes through. A box counts once per segment, where it is entered; faces in one plane count once.
 */
struct tia_radio_wall {
    uint32_t face;
    uint32_t segment; /* number of reflections before the wall */
};

/* A path. point[i] and face[i] belong to reflection i; direction[i] is the direction of the segment before it, and
 * direction[order] that of the last segment. */
struct tia_radio_path {
    uint32_t order, wall_count;
    uint32_t face[TIA_RADIO_ORDER_MAX];
    struct tia_vec3 point[TIA_RADIO_ORDER_MAX];      /* rounded to nearest, ties up */
    int64_t direction[TIA_RADIO_ORDER_MAX + 1][3];   /* unit vectors, Q2.62, within 2^-56 */
    int64_t length;                                  /* in units of 2^-TIA_RADIO_LENGTH_BITS, relative error 2^-56 */
    struct tia_radio_wall wall[TIA_RADIO_WALLS_MAX]; /* ordered by segment */
};

/* A search for paths. `from` and `to` differ, except with `everywhere` of tia_radio_shoot. Neither should be inside an
 * object, see tia_radio_inside: the paths would be meaningless. */
struct tia_radio_link {
    struct tia_vec3 from, to;
    uint32_t order; /* largest number of reflections: 0..TIA_RADIO_ORDER_MAX */
    uint32_t walls; /* largest number of walls that a path passes through: 0..TIA_RADIO_WALLS_MAX */

    /* Called for each path, in any order; returns false to stop. */
    bool (*found)(void *ctx, const struct tia_radio_path *path);
    void *ctx;
};

/* Returns the number of bytes for the faces of a scene that tia_scene_check accepts; SIZE_MAX when that number does not
 * fit. */
size_t tia_radio_size(const struct tia_scene *scene);

/* Finds the faces and stores them in `memory`, which must be aligned for uint64_t. They are read-only from then on: any
 * number of threads may use them. TIA_ERR_MEMORY when `size` is too small; TIA_ERR_RANGE, with *fault filled in, when a
 * corner is beyond the range of Q16.16 or a face that is not parallel to an axis is 32768 wide or wider. */
int tia_radio_init(struct tia_radio **radio, void *memory, size_t size, const struct tia_scene *scene,
                   struct tia_fault *fault);

/* Returns the numbers of faces, planes and objects without faces. */
struct tia_radio_counts tia_radio_count(const struct tia_radio *radio);

/* Returns face number `face`; its object is TIA_RADIO_NO_OBJECT when there is no such face. */
struct tia_radio_face tia_radio_face(const struct tia_radio *radio, uint32_t face);

/* Returns an object that has the point inside its box or on one of its faces; TIA_RADIO_NO_OBJECT: none. */
uint32_t tia_radio_inside(const struct tia_radio *radio, struct tia_vec3 point);

/* Returns the number of bytes of a search's working memory. The memory is aligned for uint64_t, and serves one search
 * at a time. */
size_t tia_radio_room_size(void);

/* Returns the number of sequences of planes of up to `order` reflections, no plane twice in a row: all that the image
 * method would have to try without pruning. UINT64_MAX: that number or more. */
uint64_t tia_radio_sequences(const struct tia_radio *radio, uint32_t order);

/* Searches by the image method: tries all sequences of planes, except those that are impossible because a plane, or all
 * of its faces, lies behind the one before it. Returns 0, or TIA_STOPPED when `found` returned false. */
int tia_radio_images(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link);

/* Tries one sequence of `order` planes, at most TIA_RADIO_ORDER_MAX; calls link->found if it gives a path. Returns 0,
 * or TIA_STOPPED when `found` returned false. */
int tia_radio_try(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link,
                  const uint32_t *planes, uint32_t order);

/* ---- shooting and bouncing rays ---- */

#define TIA_RADIO_DENSITY_MAX 2048

/* Returns the number of directions, 10 density^2 + 2: the corners of an icosahedron whose edges are each divided into
 * `density` parts. 0 for densities that are not 1..TIA_RADIO_DENSITY_MAX. */
uint32_t tia_radio_directions(uint32_t density);

/* A ray that passes the receiver: its planes, and its path, whose points are accurate to about 2^-14. */
struct tia_radio_ray {
    uint32_t plane[TIA_RADIO_ORDER_MAX];
    struct tia_radio_path path;
    int64_t miss; /* the squared distance from the receiver, Q32.32 */
};

/* Shoots ray `i` of tia_radio_directions(density) from link->from, and follows it through at most link->order
 * reflections and link->walls walls. Calls `received` when the ray passes the receiver within the radius of the
 * reception sphere: the length of the ray's path times 0.764/density, the largest angle between any direction and the
 * nearest ray. With `everywhere` the receiver is ignored, and `received` is called at each reflection. `received`
 * returns false to stop: the result is then TIA_STOPPED, else 0. */
int tia_radio_shoot(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link,
                    uint32_t density, uint32_t i, bool everywhere,
                    bool (*received)(void *ctx, const struct tia_radio_ray *ray), void *ctx);

#ifdef __cplusplus
}
#endif

#endif
