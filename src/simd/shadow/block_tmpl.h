/* block_tmpl.h - a block of pixels for exact shadow rays: its visible points, and the shaft between them and the light.
 *
 * Parameters: the doubles of isa/isa.h. Defines: struct shaft_block, set_points(), set_box(), set_shaft(), meets(). */
#ifndef TIA_SIMD_SHADOW_BLOCK_TMPL_H
#define TIA_SIMD_SHADOW_BLOCK_TMPL_H

#include "bounds/rays.h"
#include "keep_tmpl.h"
#include "shadow/shadow_rays.h"

#define SHAFT_COLUMNS 16
#define SHAFT_ROWS 8
#define SHAFT_FACES 32 /* faces and casters that are kept from block to block */
#define PLANES (TIA_SIDES + 1)
#define TINY 1e-30

/* A caster's planes, see shadow/occluder.h, in doubles: the hidden points are on the positive side of all. */
struct shaft_caster {
    uint32_t face;
    unsigned planes, ready; /* planes: 0 if the face hides nothing */
    double x[PLANES], y[PLANES], c[PLANES], m[PLANES], unit[PLANES];
};

/* A visible face: s = x i + y j + c at pixel (i, j). */
struct shaft_face {
    uint32_t face;
    bool turned, known; /* known: the plane is in front of the eye */
    double x, y, c;
};

/* The points of a block and the light, in units of the casters' boxes. `far` are the largest distances along the shaft:
 * 1 at a light, no limit for parallel rays. Along each axis, at the distance t from the points to the light, the shaft
 * is between low + t to_low and high + t to_high; the inverses of these steps are kept. */
struct shaft {
    double low[3], high[3], per_low[3], per_high[3], far;
};

struct shaft_block {
    struct tia_shadow_rays *rays;
    struct shaft_caster caster[SHAFT_FACES];
    struct shaft_face face[SHAFT_FACES];
    int x0, y0, x1, y1;
    uint32_t open[SHAFT_ROWS]; /* for each row, the pixels from whose points no face is known to hide the light */
    double s[SHAFT_ROWS][SHAFT_COLUMNS + LANES];
    double sum;             /* S, see RAY_SIDE */
    struct shaft_face seen; /* the face that the first open pixels show */
    bool only;              /* all open pixels show it */
    struct shaft shaft;
    uint32_t last; /* the last face that hid the light from a pixel */
};

/* ---- visible points ---- */

static const struct shaft_face *shaft_face_of(struct shaft_block *b, uint32_t face)
{
    const struct tia_flat_scene *flat = b->rays->flat;
    const struct tia_raster_plane *plane = &flat->planes[face];
    struct shaft_face *own = &b->face[face % SHAFT_FACES];

    if (own->face == face)
        return own;
    double det = tia_sure_double(plane->det);
    own->face = face;
    own->turned = tia_flat_is_turned(flat, face, b->rays->light);
    own->known = det > 0;
    own->x = tia_sure_double(plane->x) / det;
    own->y = tia_sure_double(plane->y) / det;
    own->c = tia_sure_double(plane->c) / det;
    return own;
}

/* Sets s in a run of pixels that show one face. */
static void set_run(struct shaft_block *b, const struct shaft_face *face, int y, int x0, int x1)
{
    double *to = &b->s[y - b->y0][x0 - b->x0];
    double sum = magnitude(face->x) * b->x1 + magnitude(face->y) * b->y1 + magnitude(face->c);

    for (int x = x0; x < x1; x += LANES, to += LANES)
        vstore(to, face->x * (lane_numbers() + (double)x) + (face->y * y + face->c));
    b->open[y - b->y0] |= ((1u << (x1 - x0)) - 1) << (x0 - b->x0);
    b->sum = sum > b->sum ? sum : b->sum;
}

/* Returns the number of runs of open pixels. */
static int set_points(struct shaft_block *b)
{
    const struct tia_raster_target *t = &b->rays->tile->target;
    int runs = 0;

    b->sum = 0;
    for (int y = b->y0; y < b->y1; y++) {
        b->open[y - b->y0] = 0;
        for (int x = b->x0, count; x < b->x1; x += count) {
            const uint32_t *face = &t->face[target_index(t, x, y)];
            count = same_faces(face, b->x1 - x);
            if (*face == TIA_NO_FACE)
                continue;
            const struct shaft_face *own = shaft_face_of(b, *face);
            if (!own->turned)
                continue;
            b->only = !runs || (b->only && own->face == b->seen.face);
            if (!runs++)
                b->seen = *own;
            if (own->known)
                set_run(b, own, y, x, x + count);
            for (int i = x; i < x + count && !own->known; i++)
                tia_shadow_rays_pixel(b->rays, i, y);
        }
    }
    return runs;
}

/* ---- the shaft ---- */

/* Gives the points of LANES pixels, in units of the boxes. Returns the lanes whose points are certain. */
LANE_OP vm points_of(const struct shaft_block *b, int x, int y, struct v3 *p)
{
    const struct tia_raster_grid *l = &b->rays->flat->grid;
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    double scale = sure_two_to(-b->rays->casters->shift), unit = (double)(INT64_C(1) << l->fraction) / l->w * scale;
    vd s = vload(&b->s[y - b->y0][x - b->x0]);
    vm near = vlt(vset(BOUND(RAY_NEAR) * b->sum), s);
    vd t = scale / vsel(near, s, vset(1)), sum = vset(b->sum);

    if (flat) {
        near = vle(s, s);
        t = vset(unit);
    }
    p->x = ((double)l->x + (double)l->right * (lane_numbers() + (double)x)) * t;
    p->y = vset((double)l->y - (double)l->down * y) * t;
    p->z = (double)l->w * t;
    vd off = BOUND(RAY_POINT) * v3_sum(*p) * sum / vsel(near, s, vset(1));
    if (flat) {
        p->z = s * unit;
        off = BOUND(RAY_POINT) * (v3_sum(*p) + sum * unit);
    }
    return mand(near, vlt(off, vset(BOUND(RAY_OFF) * scale)));
}

/* Sets the box around the open points; points that are not certain are left to plain C, and are no longer open. */
static void set_box(struct shaft_block *b)
{
    struct v3 low = v3_set((const double[3]){INFINITE, INFINITE, INFINITE}), high = v3_neg(low), p;
    const vd *from[6] = {&low.x, &low.y, &low.z, &high.x, &high.y, &high.z};

    for (int y = b->y0; y < b->y1; y++)
        for (int x = b->x0, column = 0; b->open[y - b->y0] >> column && column < SHAFT_COLUMNS;
             x += LANES, column += LANES) {
            unsigned open = b->open[y - b->y0] >> column & ((1u << LANES) - 1);
            unsigned sure = open & mbits(points_of(b, x, y, &p));
            vm taken = mof(sure);
            low = v3_sel(taken, (struct v3){vmin(low.x, p.x), vmin(low.y, p.y), vmin(low.z, p.z)}, low);
            high = v3_sel(taken, (struct v3){vmax(high.x, p.x), vmax(high.y, p.y), vmax(high.z, p.z)}, high);
            b->open[y - b->y0] &= ~((open & ~sure) << column);
            for (unsigned left = open & ~sure; left; left &= left - 1)
                tia_shadow_rays_pixel(b->rays, x + __builtin_ctz(left), y);
        }
    for (int i = 0; i < 3; i++) {
        b->shaft.low[i] = INFINITE;
        b->shaft.high[i] = -INFINITE;
        for (int k = 0; k < LANES; k++) {
            double least = lane_at(from[i], k), most = lane_at(from[3 + i], k);
            b->shaft.low[i] = least < b->shaft.low[i] ? least : b->shaft.low[i];
            b->shaft.high[i] = most > b->shaft.high[i] ? most : b->shaft.high[i];
        }
    }
}

static double inverse_of(double a)
{
    return 1 / (magnitude(a) < TINY ? TINY : a);
}

static void set_shaft(struct shaft_block *b)
{
    const struct tia_flat_scene *flat = b->rays->flat;
    double scale = sure_two_to(-b->rays->casters->shift);
    bool parallel = tia_flat_is_direction(flat, b->rays->light);
    struct shaft *s = &b->shaft;
    int64_t light[3];

    tia_flat_affine(flat, b->rays->light, light);
    s->far = parallel ? INFINITE : 1;
    for (int i = 0; i < 3; i++) {
        double to = (double)light[i] * scale;
        s->per_low[i] = inverse_of(parallel ? to : to - s->low[i]);
        s->per_high[i] = inverse_of(parallel ? to : to - s->high[i]);
    }
}

/* True if a box meets the shaft, up to roundings that are far smaller than the box's margin. */
static bool meets(const struct shaft *s, const struct tia_bounds *box)
{
    const double low[3] = {box->min.x, box->min.y, box->min.z}, high[3] = {box->max.x, box->max.y, box->max.z};
    double first = 0, last = s->far;

    for (int i = 0; i < 3; i++) {
        double in = (low[i] - s->high[i]) * s->per_high[i], out = (high[i] - s->low[i]) * s->per_low[i];
        if (s->per_high[i] > 0)
            first = in > first ? in : first;
        else
            last = in < last ? in : last;
        if (s->per_low[i] > 0)
            last = out < last ? out : last;
        else
            first = out > first ? out : first;
    }
    return first <= last;
}

#endif
