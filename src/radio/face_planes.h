/* face_planes.h - a scene's flat faces, and the planes that they lie in. */
#ifndef TIA_RADIO_FACE_PLANES_H
#define TIA_RADIO_FACE_PLANES_H

#include <tia/bvh.h>
#include <tia/radio.h>

#include "math/wide.h"

/* A 128-bit number that needs an alignment for 64 bits only. */
struct radio_wide {
    int64_t high;
    uint64_t low;
};

static inline wide radio_get(struct radio_wide a)
{
    return wide_of_halves(a.high, a.low);
}

/* A plane n.p = d. The components of n have no common divisor, and the first that is not 0 is positive: so each plane
 * has exactly one such form. */
struct radio_plane {
    int64_t n[3];
    struct radio_wide d, square; /* square: n.n */
    uint32_t first, count;       /* the plane's faces are tia_radio.members[first .. first + count - 1] */
    struct tia_bounds bounds;    /* bounds of the plane's faces */
    bool endless;                /* one of the faces is infinite */
    bool sides[2];               /* true for a side that reflects; sides[0]: n.p > d, sides[1]: n.p < d */
    uint8_t across[2];           /* the two axes on which n is not largest: those of the projection */
};

enum radio_kind { RADIO_WHOLE, RADIO_DISC, RADIO_POLYGON };

struct radio_face {
    enum radio_kind kind;
    uint32_t object, material, plane;
    /* indices into tia_radio.corners; a disc has only its centre, an infinite plane only a point */
    uint32_t corner[4];
    uint8_t count;
    bool solid;
    bool turned; /* the face's own normal is -n */
    tia_q16 radius, thickness;
};

struct tia_radio {
    const struct tia_scene *scene;
    struct radio_plane *planes;
    struct radio_face *faces;
    uint32_t *members; /* face numbers, plane by plane, in rising order */
    struct tia_vec3 *corners;
    struct tia_bounds *boxes; /* boxes of the faces */
    struct tia_bvh_tree tree; /* hierarchy of the faces that have a box */
    uint32_t *endless;
    uint32_t plane_count, face_count, corner_count, endless_count, left_out;
};

static inline int64_t radio_axis(const struct tia_vec3 *v, int k)
{
    return k == 0 ? v->x : k == 1 ? v->y : v->z;
}

/* Computes the plane through three corners. Sets *turned if the normal that follows from the order of the corners is
 * -n. Returns false if the corners are collinear or, with *too_wide set, if a component of the normal or of an edge is
 * too large. */
bool tia_radio_plane_by_corners(struct radio_plane *plane, const struct tia_vec3 corner[3], bool *turned,
                                bool *too_wide);
/* Computes the plane through a point with a normal. Sets *turned if the normal is opposite to n. */
void tia_radio_plane_by_normal(struct radio_plane *plane, struct tia_vec3 point, struct tia_dir3 normal, bool *turned);

/* Removes duplicates from radio->planes, which has one plane for each face, and sets the fields that depend on a
 * plane's faces. `room` is working storage for 3 numbers per face. */
void tia_radio_join_planes(struct tia_radio *radio, uint32_t *room);

/* True if an object has flat faces, or is a disc. */
bool tia_radio_takes(const struct tia_scene *scene, uint32_t object);

#endif
