/* affine.h - affine maps in double precision, and boxes. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_AFFINE_H
#define TOOLS_SCENE_MODEL_ASSIMP_AFFINE_H

#include <stdbool.h>

struct aiMatrix4x4;

/* x' = m[][0..2] x + m[][3] */
struct affine {
    double m[3][4];
};

struct box {
    double min[3], max[3]; /* min > max: empty */
};

struct affine affine_one(void);
struct affine affine_of(const struct aiMatrix4x4 *matrix);
/* First b, then a. */
struct affine affine_product(const struct affine *a, const struct affine *b);
void affine_point(const struct affine *a, const double p[3], double to[3]);
void affine_vector(const struct affine *a, const double v[3], double to[3]);
/* Maps a normal vector of a surface: by the cofactors, which exist where there is no inverse. */
void affine_normal(const struct affine *a, const double n[3], double to[3]);
double affine_determinant(const struct affine *a);
bool affine_is_finite(const struct affine *a);

/* Splits a map without mirroring and shear into a scale along the axes, and rotations about x, then y, then z, in
 * degrees. Returns false for other maps. */
bool affine_split(const struct affine *a, double scale[3], double degrees[3]);

double vector_length(const double v[3]);
bool vector_is_finite(const double v[3]);
/* Divides by the length. Returns false if that is 0 or not finite. */
bool vector_normalise(double v[3]);

struct box box_empty(void);
void box_extend(struct box *box, const double p[3]);
bool box_is_empty(const struct box *box);

#endif
