/* spots_tmpl.h - the positions of visible points in a shadow map, and the distances that do not shadow them, with
 * bounds.
 *
 * Parameters: the doubles of isa/isa.h. Defines: struct spot_map, struct lit_face, open_map(), find_slope(),
 * find_limits(). */
#ifndef TIA_SIMD_SHADOW_SPOTS_TMPL_H
#define TIA_SIMD_SHADOW_SPOTS_TMPL_H

#include "keep_tmpl.h"
#include "shadow/map_light.h"
#include "simd/rays/sight_tmpl.h"

#define LIT_FACES 64
#define BEYOND 16777216.0          /* texels from the middle of a map, to which plain C limits columns and rows */
#define STEEPEST 50.0              /* largest tangent */
#define SMALL_TANGENT (1.0 / 4096) /* what the square root of a small error is rounded up to */

/* A visible face. */
struct lit_face {
    uint32_t face;
    bool turned, known; /* known: its points are in front of the eye */
    double inverse[3], normal[3];
    double slope[2]; /* see find_slope; for parallel rays */
};

/* A map, and the eye's pixels, in doubles. Lengths are in the world's unit. */
struct spot_map {
    struct tia_map_lighting *l;
    const struct tia_map *map;
    const uint32_t *texels[6]; /* of each view */
    struct lit_face face[LIT_FACES];
    double first[3], right[3], down[3], along[3];
    double origin[3], axes[3][3];
    double reach, size; /* bounds of a pixel's row, and of that and of the light's position: see MAP_ROUNDING */
    double density, middle, amount, scale; /* scale: of the map's unit of distances */
    bool orthographic, cube;
    unsigned side;        /* of the filter, if it is a square, else 0 */
    tia_share shares[50]; /* by the number of lit texels in the square */
};

/* Positions in the map: u and v in texels; `number` is that of the view. */
struct spot {
    vd u, v, eu, ev, w, e, number;
    vm sure;
};

static void set_three(double to[3], const int64_t from[3], double unit)
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i] * unit;
}

static void set_reach(struct spot_map *s, const struct tia_raster_grid *grid)
{
    double most = 0, light = 0, along = 0;

    for (int i = 0; i < 3; i++) {
        double row =
            magnitude(s->first[i]) + grid->width * magnitude(s->right[i]) + grid->height * magnitude(s->down[i]);
        most = row > most ? row : most;
        along = magnitude(s->along[i]) > along ? magnitude(s->along[i]) : along;
        light += magnitude(s->origin[i]);
    }
    s->reach = s->orthographic ? along : most;
    s->size = most + light;
}

static void set_square(struct spot_map *s, enum tia_filter filter)
{
    s->side = filter == TIA_FILTER_NONE  ? 1
              : filter == TIA_FILTER_3X3 ? 3
              : filter == TIA_FILTER_5X5 ? 5
              : filter == TIA_FILTER_7X7 ? 7
                                         : 0;
    for (unsigned lit = 0; lit <= s->side * s->side && s->side; lit++)
        s->shares[lit] = (tia_share)tia_map_part(lit, s->side * s->side);
}

static void open_map(struct spot_map *s, struct tia_map_lighting *l)
{
    const struct tia_map *map = l->point.map;
    const struct tia_world *world = &l->world;
    bool constant = l->look->bias == TIA_BIAS_CONSTANT;

    s->l = l;
    s->map = map;
    for (unsigned i = 0; i < map->view_count; i++)
        s->texels[i] = map->view[i].distance;
    s->orthographic = l->view->flat.eye.projection == TIA_ORTHOGRAPHIC;
    s->cube = map->view_count > 1;
    set_three(s->first, world->first, P2M(45));
    set_three(s->right, world->right, P2M(45));
    set_three(s->down, world->down, P2M(45));
    set_three(s->along, world->along, P2M(45));
    set_three(s->origin, map->origin, P2M(28));
    for (int i = 0; i < 3; i++)
        set_three(s->axes[i], map->view[0].axes[i], P2M(62));
    s->density = (double)map->density * P2M(40);
    s->middle = (double)map->size / 2;
    s->amount = (double)l->look->amount * (constant ? P2M(28) : P2M(16));
    s->scale = sure_two_to(TIA_WORLD_BITS - map->coarse);
    set_reach(s, &l->view->flat.grid);
    set_square(s, l->look->filter);
    for (int i = 0; i < LIT_FACES; i++)
        s->face[i].face = TIA_NO_FACE;
}

/* ---- positions ---- */

/* Returns the visible points relative to the light; *e receives the error of each coordinate. */
LANE_OP struct v3 points_at(const struct spot_map *s, const struct sight *z, vd x, vd y, vd *e)
{
    struct v3 row = v3_add(v3_set(s->first), v3_add(v3_scale(v3_set(s->right), x), v3_scale(v3_set(s->down), y)));
    struct v3 p = s->orthographic ? v3_along(row, v3_set(s->along), z->z) : v3_scale(row, z->z);

    *e = BOUND_OF(MAP_POINT, s->reach * z->e) + BOUND(MAP_ROUNDING) * (vset(s->size) + s->reach * z->z) +
         BOUND(MAP_UNIT);
    return v3_sub(p, v3_set(s->origin));
}

/* Chooses the view of a cube, along the largest coordinate; sets u, v and w to the coordinates in that view. */
LANE_OP void face_cube(struct spot *spot, struct v3 d, vd e)
{
    vd x = vabs(d.x), y = vabs(d.y), z = vabs(d.z), more = vmax(x, y);
    vm by_y = vlt(x, y), by_z = vlt(more, z);
    vd along = vsel(by_z, d.z, vsel(by_y, d.y, d.x));

    spot->sure = mand(vlt(2 * e, vabs(z - more)), mor(by_z, vlt(2 * e, vabs(y - x))));
    spot->number = vsel(by_z, vset(4), vsel(by_y, vset(2), vset(0))) + vsel(vlt(along, vset(0)), vset(1), vset(0));
    spot->u = vsel(by_z, d.x, vsel(by_y, d.z, d.y));
    spot->v = vsel(by_z, d.y, vsel(by_y, d.x, d.z));
    spot->w = vabs(along);
}

/* Divides u and v by w. Behind a light all points are beyond the map. */
LANE_OP void project(struct spot *spot)
{
    vm front = vlt(BOUND(MAP_FRONT) * spot->e, spot->w), behind = vlt(spot->w, -spot->e);
    vd inverse = 1 / vsel(front, spot->w, vset(1)), least = inverse * BOUND(MAP_QUOTIENT);

    spot->sure = mand(spot->sure, mor(front, behind));
    spot->u = vsel(behind, vset(2 * BEYOND), spot->u * inverse);
    spot->v = vsel(behind, vset(2 * BEYOND), spot->v * inverse);
    vd ahead = vsel(behind, vset(0), spot->e * least);
    spot->eu = BOUND_OF(MAP_TANGENT, (1 + vabs(spot->u)) * ahead + P2M(28));
    spot->ev = BOUND_OF(MAP_TANGENT, (1 + vabs(spot->v)) * ahead + P2M(28));
    spot->w = vsel(behind, vset(1), spot->w);
}

LANE_OP vd limited(vd a)
{
    return vmax(vmin(a, vset(BEYOND)), vset(-BEYOND));
}

/* Finds the position in the map of points relative to the light, whose coordinates have the error e. */
LANE_OP struct spot find_spots(const struct spot_map *s, struct v3 d, vd e)
{
    struct spot spot = {.number = vset(0), .sure = vle(vset(0), vset(0))};

    if (s->cube) {
        face_cube(&spot, d, e);
    } else {
        spot.u = v3_dot(v3_set(s->axes[0]), d);
        spot.v = v3_dot(v3_set(s->axes[1]), d);
        spot.w = v3_dot(v3_set(s->axes[2]), d);
    }
    spot.e = BOUND_OF(MAP_ALONG, 2 * e) + BOUND(MAP_UNIT);
    spot.eu = spot.ev = spot.e;
    if (!s->map->parallel)
        project(&spot);
    spot.eu = s->density * (spot.eu + BOUND(MAP_TEXELS) * vabs(spot.u)) + BOUND(MAP_COLUMN);
    spot.ev = s->density * (spot.ev + BOUND(MAP_TEXELS) * vabs(spot.v)) + BOUND(MAP_COLUMN);
    spot.u = s->middle + limited(spot.u * s->density);
    spot.v = s->middle - limited(spot.v * s->density);
    return spot;
}

/* ---- limits ---- */

/* Gives the least and the largest 1 + tangent of the angle between the normal and the direction to the light. With the
 * dot product h of the normal and the way W to the light, the square of the tangent t is |W|^2/h^2 - 1. Where h is off
 * by less than h/32, that square is off by e = 2.2 (t^2 + 1) off/h at most; so t is off by e/t, and by sqrt(e). */
LANE_OP void find_slope(const struct spot_map *s, const double normal[3], struct v3 d, vd e, vd slope[2])
{
    struct v3 way = d;
    vd off = BOUND_OF(MAP_TURN, 4 * e);

    if (s->map->parallel) {
        way = v3_set(s->axes[2]);
        off = vset(0);
    }
    vd h = -v3_dot(v3_set(normal), way), square = v3_dot(way, way);
    off += BOUND(MAP_COSINE) * v3_sum(way);
    vm known = vlt(32 * off, h);
    vd inverse = 1 / vsel(known, h * h, vset(1)), secant = square * inverse, t = vsqrt(vmax(secant - 1, vset(0)));
    vd change = BOUND_OF(MAP_SECANT, 2.2 * secant * off * h * inverse);
    vm small = vlt(t, vset(1.0 / 16));
    known = mand(known, mor(mnot(small), vlt(change, vset(SMALL_TANGENT * SMALL_TANGENT))));
    vd et = vsel(small, vset(SMALL_TANGENT), 16 * change) + BOUND(MAP_SLOPE);
    slope[0] = 1 + vsel(known, vmin(t, vset(STEEPEST)) - et, vset(-BOUND(MAP_SLOPE)));
    slope[1] = 1 + vsel(known, vmin(t + et, vset(STEEPEST + BOUND(MAP_SLOPE))), vset(STEEPEST + BOUND(MAP_SLOPE)));
}

/* The smallest distances that do not shadow the points, in the map's unit: their lower and upper bounds. */
LANE_OP vd least_of(const struct spot_map *s, vd limit)
{
    vd scaled = vmax(vmin(limit * s->scale, vset(TIA_MAP_FAR)), vset(0));

    return -vfloor(-scaled);
}

/* Finds the positions of the points, moved along the normal if the bias says so, and their limits. */
LANE_OP struct spot find_limits(const struct spot_map *s, const struct lit_face *face, struct v3 d, vd e, vd least[2])
{
    enum tia_bias kind = s->l->look->bias;
    struct spot spot = find_spots(s, d, e);
    vd bias = vset(kind == TIA_BIAS_CONSTANT ? s->amount : 0), off = vset(0), slope[2] = {vset(1), vset(1)};

    if (kind == TIA_BIAS_SLOPE || kind == TIA_BIAS_NORMAL) {
        vd texel = (s->map->parallel ? vset(1) : spot.w) / vset(s->density);
        bias = s->amount * texel;
        off = BOUND_OF(MAP_BIAS, s->amount * ((s->map->parallel ? vset(0) : spot.e) / vset(s->density) +
                                              4 * SURE_EPS * texel + P2M(28))) +
              BOUND(MAP_UNIT);
    }
    if (kind == TIA_BIAS_NORMAL) {
        vm sure = spot.sure;
        spot = find_spots(s, v3_along(d, v3_set(face->normal), bias), e + off + BOUND(MAP_UNIT));
        spot.sure = mand(spot.sure, sure);
        bias = off = vset(0);
    }
    if (kind == TIA_BIAS_SLOPE && s->map->parallel) {
        slope[0] = vset(face->slope[0]);
        slope[1] = vset(face->slope[1]);
    } else if (kind == TIA_BIAS_SLOPE)
        find_slope(s, face->normal, d, e, slope);
    vd unit = spot.e + BOUND_OF(MAP_LIMIT, 2 * P2M(28));
    least[0] = least_of(s, spot.w - unit - (bias + off) * slope[1]);
    least[1] = least_of(s, spot.w + unit - (bias - off) * slope[0]);
    return spot;
}

#endif
