#include "affine.h"

#include <assimp/matrix4x4.h>
#include <math.h>

/* Largest cosine between the axes of a map that counts as free of shear. */
#define SHEAR 1e-5

struct affine affine_one(void)
{
    return (struct affine){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

struct affine affine_of(const struct aiMatrix4x4 *t)
{
    return (struct affine){{{(double)t->a1, (double)t->a2, (double)t->a3, (double)t->a4},
                            {(double)t->b1, (double)t->b2, (double)t->b3, (double)t->b4},
                            {(double)t->c1, (double)t->c2, (double)t->c3, (double)t->c4}}};
}

struct affine affine_product(const struct affine *a, const struct affine *b)
{
    struct affine product;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) {
            product.m[i][k] = k == 3 ? a->m[i][3] : 0;
            for (int j = 0; j < 3; j++)
                product.m[i][k] += a->m[i][j] * b->m[j][k];
        }
    return product;
}

void affine_vector(const struct affine *a, const double v[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = a->m[i][0] * v[0] + a->m[i][1] * v[1] + a->m[i][2] * v[2];
}

void affine_point(const struct affine *a, const double p[3], double to[3])
{
    affine_vector(a, p, to);
    for (int i = 0; i < 3; i++)
        to[i] += a->m[i][3];
}

static double cofactor(const struct affine *a, int i, int k)
{
    int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    return a->m[i1][k1] * a->m[i2][k2] - a->m[i1][k2] * a->m[i2][k1];
}

void affine_normal(const struct affine *a, const double n[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = cofactor(a, i, 0) * n[0] + cofactor(a, i, 1) * n[1] + cofactor(a, i, 2) * n[2];
}

double affine_determinant(const struct affine *a)
{
    return a->m[0][0] * cofactor(a, 0, 0) + a->m[0][1] * cofactor(a, 0, 1) + a->m[0][2] * cofactor(a, 0, 2);
}

bool affine_is_finite(const struct affine *a)
{
    bool finite = true;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            finite = finite && isfinite(a->m[i][k]);
    return finite;
}

bool affine_split(const struct affine *a, double scale[3], double degrees[3])
{
    double r[3][3];

    for (int k = 0; k < 3; k++) {
        double axis[3] = {a->m[0][k], a->m[1][k], a->m[2][k]};
        scale[k] = vector_length(axis);
        if (!vector_normalise(axis))
            return false;
        for (int i = 0; i < 3; i++)
            r[i][k] = axis[i];
    }
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        if (fabs(r[0][k] * r[0][next] + r[1][k] * r[1][next] + r[2][k] * r[2][next]) > SHEAR)
            return false;
    }
    bool upright = hypot(r[2][1], r[2][2]) > 1e-6; /* else a rotation about z is the same as one about x */
    degrees[0] = upright ? atan2(r[2][1], r[2][2]) : atan2(-r[1][2], r[1][1]);
    degrees[1] = atan2(-r[2][0], hypot(r[2][1], r[2][2]));
    degrees[2] = upright ? atan2(r[1][0], r[0][0]) : 0;
    for (int k = 0; k < 3; k++)
        degrees[k] *= 180 / acos(-1.0);
    return affine_determinant(a) > 0;
}

double vector_length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

bool vector_is_finite(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

bool vector_normalise(double v[3])
{
    double length = vector_length(v);

    if (!(length > 0) || !isfinite(length))
        return false;
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return true;
}

struct box box_empty(void)
{
    return (struct box){{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
}

void box_extend(struct box *box, const double p[3])
{
    for (int i = 0; i < 3; i++) {
        box->min[i] = fmin(box->min[i], p[i]);
        box->max[i] = fmax(box->max[i], p[i]);
    }
}

bool box_is_empty(const struct box *box)
{
    return !(box->min[0] <= box->max[0]);
}
