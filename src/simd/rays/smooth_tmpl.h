/* smooth_tmpl.h - smooth normals of the faces of meshes.
 *
 * Parameters: the doubles of isa/isa.h. Defines: smooth_normal_at(), set_smooth_face(). */
#ifndef TIA_SIMD_RAYS_SMOOTH_TMPL_H
#define TIA_SIMD_RAYS_SMOOTH_TMPL_H

#include "sure_faces.h"
#include "vector_tmpl.h"

/* The corners and smooth normals of faces, side by side, and their `extent` as in struct sure_face. */
struct smooth_faces {
    double at[3][3][LANES], normal[3][3][LANES], extent[LANES];
};

LANE_OP struct v3 v3_columns(double (*c)[LANES])
{
    return (struct v3){vload(c[0]), vload(c[1]), vload(c[2])};
}

/* Smooth normals, their error bound, and the lanes whose faces are not too small for one. */
struct smooth_normal {
    struct v3 normal;
    vd e;
    vm fine;
};

/* Returns the normals at the points `local`, within `elocal`, of faces with the normals g: those of the corners,
 * weighted by the opposite areas as seen along the face's main axis. */
LANE_OP struct smooth_normal smooth_normal_at(struct smooth_faces *faces, struct v3 local, vd elocal, struct v3 g)
{
    struct v3 v[3], n[3];
    vd w[3], e, far = vset(0), bend = vset(0); /* bend: |x| + |y| + |z| of the others' differences from the first */

    for (int i = 0; i < 3; i++) {
        v[i] = v3_sub(v3_columns(faces->at[i]), local);
        n[i] = v3_columns(faces->normal[i]);
        far = vmax(far, v3_sum(v[i]));
        bend = bend + v3_sum(v3_sub(n[i], n[0]));
    }
    struct v3 size = {vabs(g.x), vabs(g.y), vabs(g.z)};
    vd largest = vmax(vmax(size.x, size.y), size.z);
    vm is_x = vle(largest, size.x), is_y = mand(mnot(is_x), vle(largest, size.y));
    for (int i = 0; i < 3; i++) {
        struct v3 c = v3_cross(v[(i + 1) % 3], v[(i + 2) % 3]);
        w[i] = vsel(is_x, c.x, vsel(is_y, c.y, c.z));
    }
    vd sum = w[0] + w[1] + w[2],
       ew = BOUND_OF(SMOOTH_AREA, vload(faces->extent) * elocal) + far * far * BOUND(SMOOTH_ROUNDING);
    vm fine = vlt(BOUND(SMOOTH_KNOWN) * ew, vabs(sum));
    vd inverse = 1 / vsel(fine, sum, vset(1)), epart = BOUND_OF(SMOOTH_SHARE, ew * vabs(inverse)) + BOUND(SMOOTH_PART);
    vm clear = vlt(BOUND_OF(SMOOTH_CLEAR, 2 * epart), vmin(vmin(w[0] * inverse, w[1] * inverse), w[2] * inverse));
    struct v3 total =
        v3_add(v3_add(v3_scale(n[0], w[0] * inverse), v3_scale(n[1], w[1] * inverse)), v3_scale(n[2], w[2] * inverse));
    struct v3 unit = v3_unit(
        total, BOUND_OF(SMOOTH_NORMAL, vsel(clear, epart, BOUND(SMOOTH_CUT) * epart) * bend) + BOUND(SMOOTH_SUM), &e);
    return (struct smooth_normal){unit, e, fine};
}

/* Sets lane k to a face of a mesh, or to zeros. */
LANE_OP void set_smooth_face(struct smooth_faces *to, int k, const struct sure_object *o, uint32_t face)
{
    static const struct tia_corner none;
    static const struct tia_vec3 origin;
    static const double zero[3];
    const struct tia_mesh *mesh = o ? o->faces : NULL;
    const struct tia_corner *corner = mesh ? mesh->faces[face].corner : &none;
    struct sure_flat room;

    to->extent[k] = mesh ? (double)sure_flat_of(o->mesh, face, &room)->extent : 0;
    for (int i = 0; i < 3; i++) {
        const struct tia_vec3 *v = mesh ? &mesh->vertices[corner[i].vertex] : &origin;
        const double *n = mesh ? o->mesh->normals[corner[i].normal] : zero;
        to->at[i][0][k] = (double)v->x * SURE_Q16;
        to->at[i][1][k] = (double)v->y * SURE_Q16;
        to->at[i][2][k] = (double)v->z * SURE_Q16;
        to->normal[i][0][k] = n[0];
        to->normal[i][1][k] = n[1];
        to->normal[i][2][k] = n[2];
    }
}

#endif
