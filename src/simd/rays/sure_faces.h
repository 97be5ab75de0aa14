/* sure_faces.h - the faces of meshes in doubles, as stored or computed. */
#ifndef TIA_SIMD_RAYS_SURE_FACES_H
#define TIA_SIMD_RAYS_SURE_FACES_H

#include "sure.h"

/* Sets a triangle by its corners. */
void tia_sure_set_face(struct sure_face *to, const struct tia_vec3 corner[3]);

/* Computes what is stored for a face of a mesh. */
void tia_sure_set_flat(struct sure_flat *to, const struct tia_mesh *mesh, uint32_t face);

/* Returns what is stored for a face of a mesh, or computes it in `room`. */
static inline const struct sure_flat *sure_flat_of(const struct sure_tree *tree, uint32_t face, struct sure_flat *room)
{
    if (__builtin_expect(tree->faces != NULL, 1))
        return &tree->faces[face];
    tia_sure_set_flat(room, tree->mesh, face);
    return room;
}

/* Returns a face of a mesh, of which `from` is stored or computed. */
static inline struct sure_face sure_face_from(const struct sure_tree *tree, uint32_t face, const struct sure_flat *from)
{
    const struct tia_corner *corner = tree->mesh->faces[face].corner;
    struct sure_face f;

    for (int i = 0; i < 3; i++) {
        sure_corner(f.at[i], &tree->mesh->vertices[corner[i].vertex]);
        f.normal[i] = from->normal[i];
    }
    f.any = from->extent > 0;
    f.extent = __builtin_fabs((double)from->extent);
    return f;
}

/* Returns a face of a mesh. */
static inline struct sure_face sure_face_of(const struct sure_tree *tree, uint32_t face)
{
    struct sure_flat room;

    return sure_face_from(tree, face, sure_flat_of(tree, face, &room));
}

/* Returns a face's edges. Corners are multiples of 2^-16 and the centre is a multiple of 2^-17, so that only A x B is
 * rounded. */
static inline struct sure_edges sure_edges_of(const struct sure_face *f, const double centre[3])
{
    struct sure_edges e;

    for (int i = 0; i < 3; i++) {
        const double *from = f->at[i], *to = f->at[i < 2 ? i + 1 : 0];
        const double a[3] = {from[0] - centre[0], from[1] - centre[1], from[2] - centre[2]};
        const double b[3] = {to[0] - centre[0], to[1] - centre[1], to[2] - centre[2]};
        for (int k = 0; k < 3; k++) {
            int x = k < 2 ? k + 1 : 0, y = k > 0 ? k - 1 : 2;
            e.edge[i][0][k] = a[x] * b[y] - a[y] * b[x];
            e.edge[i][1][k] = to[k] - from[k];
        }
    }
    return e;
}

#endif
