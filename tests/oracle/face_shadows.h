/* face_shadows.h - hard shadows of flat faces, in double precision and in the world: the rays' test of Moeller and
 * Trumbore (1997) against each face. The face where a ray to a light starts is left out, so there is no bias. */
#ifndef TESTS_ORACLE_FACE_SHADOWS_H
#define TESTS_ORACLE_FACE_SHADOWS_H

#include "vec.h"

#define ORACLE_NO_FACE UINT32_MAX

struct oracle_face {
    bool plane;                    /* the whole plane, with the normal edge[0] */
    struct oracle_vec at, edge[2]; /* a corner, and the vectors from there to the others */
    uint32_t object;
};

/* Returns the number of faces of a scene of planes, boxes, triangles and meshes; fills them in if `faces` is not NULL.
 */
uint32_t oracle_faces(const struct tia_scene *scene, struct oracle_face *faces);

/* Returns the face that a ray meets first, and gives t; or ORACLE_NO_FACE. */
uint32_t oracle_face_seen(const struct oracle_face *faces, uint32_t count, struct ray ray, double *t);

/* True if light of sample i, with the pattern of class 0, arrives at the point of that face that is visible from
 * `eye`. */
bool oracle_face_lit(const struct oracle_face *faces, uint32_t count, uint32_t face, struct ray eye, double t,
                     const struct tia_light *light, unsigned i);

#endif
