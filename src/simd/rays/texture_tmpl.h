/* texture_tmpl.h - colours of textures, lane by lane: surface coordinates with their bounds, then a cell or a texel.
 *
 * Parameters: struct v3 of vector_tmpl.h; the rest is scalar. Defines: texture_colour(), along(), struct
 * texture_point. */
#ifndef TIA_SIMD_RAYS_TEXTURE_TMPL_H
#define TIA_SIMD_RAYS_TEXTURE_TMPL_H

#include "math/atan2.h"
#include "render/geometry/round.h"
#include "sure_faces.h"
#include "vector_tmpl.h"

/* A point in the axes of its object, and the element that was hit. */
struct texture_point {
    const struct sure_object *object;
    uint32_t element;
    double at[3], e;
};

/* Surface coordinates within e. */
struct coordinates {
    double uv[2], e;
};

LANE_OP double along(const double v[3], const double axis[3])
{
    return v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
}

LANE_OP double size_of(const double v[3])
{
    return __builtin_fabs(v[0]) + __builtin_fabs(v[1]) + __builtin_fabs(v[2]);
}

static void flat_coordinates(const struct texture_point *p, struct coordinates *c)
{
    const struct sure_object *o = p->object;
    const double v[3] = {p->at[0] - o->at[0], p->at[1] - o->at[1], p->at[2] - o->at[2]};
    bool disc = o->kind == SURE_DISC;
    double scale = disc ? 0.5 / o->radius : o->unit;

    for (int i = 0; i < 2; i++)
        c->uv[i] = (along(v, o->axes[i]) + (disc ? o->radius : 0)) * scale;
    c->e = BOUND_OF(UV_FLAT, (p->e + size_of(v) * BOUND(UV_ALONG) + BOUND(UV_ALONG_UNITS)) * scale) + BOUND(UV_UNITS) +
           BOUND(UV_ROUNDING);
}

/* Sets coordinates on a face of a box with this minimum and size, see box_uv(). */
static void box_coordinates(const struct texture_point *p, const double min[3], const double size[3], uint32_t face,
                            struct coordinates *c)
{
    double v[3], least = size[0];

    for (int i = 0; i < 3; i++) {
        v[i] = p->at[i] - min[i];
        least = size[i] < least ? size[i] : least;
    }
    v[2] = face == 1 || face == 3 ? size[2] - v[2] : v[2];
    v[0] = face == 4 ? size[0] - v[0] : v[0];
    c->uv[0] = face / 2 == 0 ? v[2] / size[2] : v[0] / size[0];
    c->uv[1] = face / 2 == 1 ? v[2] / size[2] : v[1] / size[1];
    c->e = BOUND_OF(UV_BOX, (p->e + (size_of(p->at) + size_of(min) + size_of(size)) * BOUND(UV_BOX_ROUNDING) +
                             BOUND(UV_ALONG_UNITS)) /
                                least) +
           BOUND(UV_UNIT) + BOUND(UV_ROUNDING);
}

static void grid_coordinates(const struct texture_point *p, struct coordinates *c)
{
    const struct sure_grid *g = p->object->grid;
    uint32_t cell = p->element / 6, row = cell / g->from->size[0];
    const double at[3] = {cell % g->from->size[0], row % g->from->size[1], row / g->from->size[1]};
    double min[3], size[3];

    for (int i = 0; i < 3; i++) {
        min[i] = g->corner[i] + g->edge * at[i];
        size[i] = g->edge;
    }
    box_coordinates(p, min, size, p->element % 6, c);
}

/* Sets the barycentric coordinates, as smooth_normals() does. Their bound is three times that of a part, as the
 * fixed-point code may clamp some to 0. If the mesh has coordinates of its own, these are interpolated. False: the face
 * is too small. */
static bool face_coordinates(const struct texture_point *p, struct coordinates *c)
{
    const struct sure_object *o = p->object;
    const struct sure_face whole = o->kind == SURE_MESH ? sure_face_of(o->mesh, p->element) : *o->face, *f = &whole;
    const struct tia_corner *corner = o->kind == SURE_MESH ? o->faces->faces[p->element].corner : NULL;
    double x = __builtin_fabs(f->normal[0]), y = __builtin_fabs(f->normal[1]), z = __builtin_fabs(f->normal[2]);
    int main = x >= y && x >= z ? 0 : y >= z ? 1 : 2, a = (main + 1) % 3, b = (main + 2) % 3;
    double w[3], v[3][3], far = 0;

    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            v[i][k] = f->at[i][k] - p->at[k];
        far = size_of(v[i]) > far ? size_of(v[i]) : far;
    }
    for (int i = 0; i < 3; i++) {
        const double *s = v[(i + 1) % 3], *t = v[(i + 2) % 3];
        w[i] = s[a] * t[b] - s[b] * t[a];
    }
    double sum = w[0] + w[1] + w[2], ew = BOUND_OF(UV_FACE_AREA, f->extent * p->e) + far * far * BOUND(SMOOTH_ROUNDING);
    if (!(BOUND(UV_FACE_KNOWN) * ew < __builtin_fabs(sum)))
        return false;
    double part = BOUND_OF(UV_FACE, 3 * (ew / __builtin_fabs(sum) + BOUND(SMOOTH_PART)));
    c->uv[0] = w[1] / sum;
    c->uv[1] = w[2] / sum;
    c->e = part + BOUND(UV_UNIT);
    if (!corner || corner[0].uv == TIA_NO_INDEX)
        return true;
    double spread = 0, most = 0, uv[3][2];
    for (int i = 0; i < 3; i++) {
        const struct tia_uv *given = &o->faces->uvs[corner[i].uv];
        uv[i][0] = (double)given->u * SURE_Q16;
        uv[i][1] = (double)given->v * SURE_Q16;
        for (int k = 0; k < 2; k++) {
            spread += __builtin_fabs(uv[i][k] - uv[0][k]);
            most += __builtin_fabs(uv[i][k]);
        }
    }
    double one = c->uv[0], two = c->uv[1];
    for (int k = 0; k < 2; k++)
        c->uv[k] = uv[0][k] * (1 - one - two) + uv[1][k] * one + uv[2][k] * two;
    c->e = BOUND_OF(UV_MESH, part * spread) + most * BOUND(UV_FACE_SUM) + BOUND(UV_UNITS);
    return true;
}

/* Computes atan2(y, x)/(2 pi) by the fixed-point function. The vector (x, y) has a length of 1 or less and is within e,
 * so its angle is within e over its length. False if this is too large, and near the jump at 1/2. */
static bool angle_of(double y, double x, double e, double *angle, double *bound)
{
    double size = __builtin_sqrt(x * x + y * y), full = (double)(INT64_C(1) << 62);

    if (!(BOUND(ANGLE_KNOWN) * e < size) || size < BOUND(ANGLE_LEAST) || size > 1.0625 ||
        (x < 0 && __builtin_fabs(y) <= BOUND_OF(ANGLE_SEAM, e)))
        return false;
    *angle = sure_cosine(tia_atan2((int64_t)(y * full * 0.75), (int64_t)(x * full * 0.75)));
    *bound = BOUND_OF(ANGLE, BOUND(ANGLE_TURN) * e / size + BOUND(ANGLE_ROUNDING));
    return true;
}

static bool sphere_coordinates(const struct texture_point *p, struct coordinates *c)
{
    const double *at = p->object->at, v[3] = {p->at[0] - at[0], p->at[1] - at[1], p->at[2] - at[2]};
    double size = __builtin_sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]),
           e = BOUND_OF(UV_SPHERE_TURN, BOUND(UV_CHORD) * p->e / size + BOUND(UV_SPHERE_ROUNDING));
    double aside = __builtin_sqrt(v[0] * v[0] + v[2] * v[2]), u, w, eu, ew;

    if (!(BOUND(ANGLE_KNOWN) * p->e < size) || !angle_of(v[2] / size, v[0] / size, e, &u, &eu) ||
        !angle_of(aside / size, v[1] / size, e + BOUND(UV_POLE), &w, &ew))
        return false;
    c->uv[0] = 0.5 - u;
    c->uv[1] = 1 - 2 * w;
    c->e = BOUND_OF(UV_SPHERE, eu + BOUND_OF(UV_SPHERE_HEIGHT, 2 * ew) + BOUND(UV_UNITS));
    return true;
}

/* Sets coordinates of cylinders and cones. Caps are discs, see cap_uv(). */
static bool round_coordinates(const struct texture_point *p, struct coordinates *c)
{
    const struct sure_round *k = p->object->round;
    const double v[3] = {p->at[0] - k->base[0], p->at[1] - k->base[1], p->at[2] - k->base[2]};
    double right = along(v, k->across[0]), down = along(v, k->across[1]),
           e = BOUND_OF(UV_ROUND_PLACE, p->e + size_of(v) * BOUND(UV_ALONG) + BOUND(UV_ALONG_UNITS));
    double radius = p->element == ROUND_BASE ? k->base_radius : k->top_radius, size, u, eu;

    if (p->element != ROUND_SIDE) {
        bool upright = k->axis[0] == 0 && k->axis[2] == 0, base = p->element == ROUND_BASE;
        c->uv[0] = (radius + (base && !upright ? -right : right)) / (2 * radius);
        c->uv[1] = (radius - (base && upright ? -down : down)) / (2 * radius);
        c->e = BOUND_OF(UV_CAP, e / (2 * radius)) + BOUND(UV_UNITS) + BOUND(UV_ROUNDING);
        return true;
    }
    size = __builtin_sqrt(right * right + down * down);
    if (!(BOUND(ANGLE_KNOWN) * e < size) ||
        !angle_of(down / size, right / size,
                  BOUND_OF(UV_ROUND_TURN, BOUND(UV_CHORD) * e / size + BOUND(UV_ROUND_ROUNDING)), &u, &eu))
        return false;
    c->uv[0] = 0.5 - u;
    c->uv[1] = along(v, k->axis) / k->length;
    c->e = eu + BOUND_OF(UV_HEIGHT, e / k->length) + BOUND(UV_UNITS) + BOUND(UV_ROUNDING);
    return true;
}

/* Sets the surface coordinates; false where they are undecided: at poles, along seams, and in faces that are too
 * small. */
static bool coordinates_of(const struct texture_point *p, struct coordinates *c)
{
    const struct sure_object *o = p->object;
    double size[3];

    switch (o->kind) {
    case SURE_PLANE:
    case SURE_DISC:
        flat_coordinates(p, c);
        return true;
    case SURE_BOX:
        for (int i = 0; i < 3; i++)
            size[i] = o->normal[i] - o->at[i];
        box_coordinates(p, o->at, size, p->element, c);
        return true;
    case SURE_GRID:
        grid_coordinates(p, c);
        return true;
    case SURE_MESH:
    case SURE_TRIANGLE:
        return face_coordinates(p, c);
    case SURE_SPHERE:
        return sphere_coordinates(p, c);
    case SURE_ROUND:
        return round_coordinates(p, c);
    default:
        return false;
    }
}

/* Gives the floor of x, which is within e. False if there are two candidates, or if |x| + e is 2^30 or more. */
static bool floor_of(double x, double e, int64_t *n)
{
    double low = __builtin_floor(x - e), high = __builtin_floor(x + e);

    *n = (int64_t)low;
    return low == high && __builtin_fabs(x) + e < 1073741824.0;
}

static const uint8_t *texel_at(const struct tia_texture *t, int64_t x, int64_t y)
{
    x %= t->width;
    y %= t->height;
    x += x < 0 ? t->width : 0;
    y += y < 0 ? t->height : 0;
    return t->texels + 3 * ((size_t)(t->height - 1 - y) * t->width + (size_t)x);
}

/* Interpolates four texels bilinearly. Returns the larger change per texel of any channel, along either axis. */
static double blend_texels(const struct tia_texture *t, const double place[2], double rgb[3])
{
    double x = __builtin_floor(place[0]), y = __builtin_floor(place[1]), right = place[0] - x, up = place[1] - y;
    const uint8_t *texel[4];
    int most = 0;

    for (int i = 0; i < 4; i++)
        texel[i] = texel_at(t, (int64_t)x + i % 2, (int64_t)y + i / 2);
    for (int c = 0; c < 3; c++) {
        double below = texel[0][c] + right * (texel[1][c] - texel[0][c]);
        double above = texel[2][c] + right * (texel[3][c] - texel[2][c]);
        rgb[c] = (below + (above - below) * up) / 255;
        for (int i = 0; i < 4; i++) {
            int from = i < 2 ? 2 * i : i - 2, slope = texel[from + (i < 2 ? 1 : 2)][c] - texel[from][c];
            most = slope > most ? slope : -slope > most ? -slope : most;
        }
    }
    return most / 255.0;
}

/* Gives the colour within *e; false when it is undecided. */
static bool texture_colour(const struct sure_material *m, const struct texture_point *p, double rgb[3], double *e)
{
    const struct tia_texture *t = m->texture;
    struct coordinates c;
    double place[2], off[2];
    int64_t cell[2];
    bool sure = coordinates_of(p, &c), whole = true, bilinear = t->kind != TIA_CHECKER && t->bilinear;

    *e = BOUND(TEXEL_COLOUR);
    for (int i = 0; i < 2 && sure; i++) {
        double texels = t->kind == TIA_CHECKER ? 1 : i ? t->height : t->width;
        place[i] = (c.uv[i] - m->offset[i]) * m->repeat[i] * texels;
        off[i] = BOUND_OF(TEXEL_PLACE,
                          (c.e + (__builtin_fabs(c.uv[i]) + __builtin_fabs(m->offset[i])) * BOUND(TEXEL_ROUNDING)) *
                              m->repeat[i] * texels) +
                 texels * BOUND(TEXEL_UNITS);
        place[i] -= bilinear ? 0.5 : 0;
        whole = floor_of(place[i], off[i], &cell[i]) && whole;
        sure = (whole || bilinear) && __builtin_fabs(place[i]) < 1073741824.0;
    }
    if (!sure)
        return false;
    if (t->kind == TIA_CHECKER) {
        for (int k = 0; k < 3; k++)
            rgb[k] = m->cells[(cell[0] ^ cell[1]) & 1][k];
    } else if (bilinear) {
        double slope = blend_texels(t, place, rgb);
        *e = BOUND_OF(TEXEL_BLEND_PLACE, (off[0] + off[1]) * (whole ? slope : 1)) + BOUND(TEXEL_BLEND);
    } else {
        const uint8_t *texel = texel_at(t, cell[0], cell[1]);
        for (int k = 0; k < 3; k++)
            rgb[k] = texel[k] / 255.0;
    }
    return true;
}

#endif
