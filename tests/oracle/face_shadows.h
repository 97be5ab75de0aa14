/* face_shadows.h - hard shadows of flat faces, in double precision and world coordinates: each face is tested by the
 * method of Moeller and Trumbore (1997). The face on which a ray to a light starts is left out, so no bias is
 * needed. */
#ifndef TESTS_ORACLE_FACE_SHADOWS_H
#define TESTS_ORACLE_FACE_SHADOWS_H

#include "vec.h"

#define ORACLE_NO_FACE UINT32_MAX

struct oracle_face {
    bool plane;                    /* the face is a whole plane, with the normal edge[0] */
    struct oracle_vec at, edge[2]; /* a corner, and the vectors from there to the others */
    uint32_t object;
};

/* Returns the number of faces of a scene of planes, boxes, triangles and meshes; writes them to `faces` if it is not
 * NULL. */
uint32_t oracle_faces(const struct tia_scene *scene, struct oracle_face *faces);

/* Returns the first face that a ray meets, with its distance in *t; ORACLE_NO_FACE and infinity if there is none. */
uint32_t oracle_face_seen(const struct oracle_face *faces, uint32_t count, struct ray ray, double *t);

/* True if sample i of the light reaches the point of `face` at t along the ray `eye`. The samples have the pattern of
 * pixel class 0. */
bool oracle_face_lit(const struct oracle_face *faces, uint32_t count, uint32_t face, struct ray eye, double t,
                     const struct tia_light *light, unsigned i);

#endif
