/* surface_tmpl.h - the points where rays hit surfaces: normals, materials, textures.
 *
 * Parameters: the doubles of isa/isa.h. Defines: find_surfaces(), turn(), mirrored_at(), off_surface(), leaving(),
 * struct shade. */
#ifndef TIA_SIMD_RAYS_SURFACE_TMPL_H
#define TIA_SIMD_RAYS_SURFACE_TMPL_H

#include "smooth_tmpl.h"
#include "texture_tmpl.h"
#include "walk_tmpl.h"

struct shade {
    struct v3 point, local, outside, geometric, normal, viewer;
    vd ep, elocal, eoutside, eg, en, ev, facing, efacing;
    vd across; /* length of the direction's part in the plane in which the normal is off; at most 1 */
    union {
        struct {
            vd colour[3], specular[3], mirror[3], refraction[3], emission[3], flat[3], exponent;
        };
        vd column[SURE_COLUMNS]; /* as those of struct sure_material */
    };
    vd ecolour;
    vm glossy, refracts, fresnel, back;
    vm unsure;
    vm exact; /* the normal's coordinates have the sign of the fixed-point ones, or are 0 where those are */
    const struct sure_object *object[LANES]; /* NULL in unused lanes */
    vd id, part;                             /* index and element of the query */
    uint32_t index[LANES], element[LANES], material[LANES];
    const double *instance[LANES]; /* each points to a struct sure_instance */
};

#define INSTANCE_AT(field) (int)(offsetof(struct sure_instance, field) / sizeof(double))

/* Returns the material of an object's element: cells of a grid have their own. */
LANE_OP uint32_t material_at(const struct sure_object *o, uint32_t element)
{
    return o->material + (o->kind == SURE_GRID ? o->grid->from->cells[element / 6] - 1u : 0);
}

LANE_OP void find_objects(const struct sure_scene *s, const struct query *q, unsigned lanes, struct shade *h)
{
    double ids[LANES], elements[LANES];

    h->id = vsel(mof(lanes), q->id, vset(0));
    h->part = vsel(mof(lanes), q->element, vset(0));
    vstore(ids, h->id);
    vstore(elements, h->part);
    for (int k = 0; k < LANES; k++) {
        bool on = lanes >> k & 1;
        h->index[k] = (uint32_t)ids[k];
        h->element[k] = (uint32_t)elements[k];
        h->object[k] = on ? &s->object[h->index[k]] : NULL;
        h->material[k] = on ? material_at(h->object[k], h->element[k]) : 0;
    }
}

/* Sets a material's columns in the lanes that have it; `groups` are the groups of columns that any lane needs. */
LANE_OP void set_columns(struct shade *h, const struct sure_material *m, uint32_t groups, vm lanes)
{
    for (int i = 0; i < SURE_COLUMNS; i++)
        if (groups >> i / 3 & 1)
            h->column[i] = vsel(lanes, vset(m->column[i]), h->column[i]);
}

/* Sets a material's columns in all lanes. */
LANE_OP void spread_columns(struct shade *h, const struct sure_material *m)
{
    for (int i = 0; i < SURE_COLUMNS; i++)
        h->column[i] = vset(m->column[i]);
}

/* Sets the materials; returns the lanes whose material has a texture. */
static unsigned find_materials(const struct sure_scene *s, unsigned lanes, struct shade *h)
{
    unsigned glossy = 0, refracts = 0, fresnel = 0, unknown = 0, textured = 0, same;
    uint32_t groups = 0;

    spread_columns(h, &s->materials[h->material[__builtin_ctz(lanes)]]);
    for (int k = 0; k < LANES; k++)
        groups |= lanes >> k & 1 ? s->materials[h->material[k]].groups : 0;
    for (unsigned left = lanes; left; left &= ~same) {
        uint32_t material = h->material[__builtin_ctz(left)];
        const struct sure_material *m = &s->materials[material];
        same = 0;
        for (int k = 0; k < LANES; k++)
            same |= (unsigned)(h->material[k] == material) << k & left;
        if (left != lanes)
            set_columns(h, m, groups, mof(same));
        glossy |= m->is_specular ? same : 0;
        refracts |= m->refracts ? same : 0;
        fresnel |= m->fresnel ? same : 0;
        unknown |= m->known ? 0 : same;
        textured |= m->texture ? same : 0;
    }
    h->glossy = mof(glossy);
    h->refracts = mof(refracts);
    h->fresnel = mof(fresnel);
    h->unsure = mof(unknown);
    return textured;
}

static void add_texture(const struct sure_scene *s, struct shade *h, int k)
{
    const struct sure_material *m = &s->materials[h->material[k]];
    struct texture_point p = {h->object[k],
                              h->element[k],
                              {lane_of(h->local.x, k), lane_of(h->local.y, k), lane_of(h->local.z, k)},
                              lane_of(h->elocal, k)};
    double rgb[3], e, lanes[LANES];

    if (!texture_colour(m, &p, rgb, &e)) {
        h->unsure = mor(h->unsure, mof(1u << k));
        return;
    }
    for (int c = 0; c < 3; c++) {
        vstore(lanes, h->colour[c]);
        lanes[k] *= rgb[c];
        h->colour[c] = vload(lanes);
    }
    vstore(lanes, h->ecolour);
    lanes[k] = e;
    h->ecolour = vload(lanes);
}

static void find_textures(const struct sure_scene *s, unsigned textured, struct shade *h)
{
    h->ecolour = vset(0);
    for (; textured; textured &= textured - 1)
        add_texture(s, h, __builtin_ctz(textured));
}

/* Converts the points to the axes of their objects; returns the lanes on instances, whose axes are not the world's. */
static unsigned find_local(struct shade *h)
{
    static const struct sure_instance none = {
        .axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .inverse = {1, 1, 1}, .least = 1, .most = 1};
    unsigned placed = 0;

    h->local = h->point;
    h->elocal = h->ep;
    for (int k = 0; k < LANES; k++) {
        bool is = h->object[k] && h->object[k]->placed;
        placed |= (unsigned)is << k;
        h->instance[k] = (const double *)(const void *)(is ? h->object[k]->placed : &none);
    }
    if (!placed)
        return 0;
    const double *const *p = h->instance;
    struct v3 v = v3_sub(h->point, v3_gather(p, 0));
    vd e = BOUND_OF(LOCAL_PLACE, h->ep + v3_sum(v) * BOUND(LOCAL_POINT) + BOUND(LOCAL_UNITS));
    struct v3 local = {v3_dot(v, v3_gather(p, INSTANCE_AT(axes))) * vgather(p, INSTANCE_AT(inverse)),
                       v3_dot(v, v3_gather(p, INSTANCE_AT(axes) + 3)) * vgather(p, INSTANCE_AT(inverse) + 1),
                       v3_dot(v, v3_gather(p, INSTANCE_AT(axes) + 6)) * vgather(p, INSTANCE_AT(inverse) + 2)};
    h->local = v3_sel(mof(placed), local, h->local);
    h->elocal = vsel(mof(placed),
                     BOUND_OF(LOCAL_OVER_SCALE, e / vgather(p, INSTANCE_AT(least))) + BOUND(POINT_UNIT) +
                         v3_sum(local) * BOUND(LOCAL_SCALED),
                     h->elocal);
    return placed;
}

/* Returns a normal in the world: n_i / s_i along the axes, normalised. */
static struct v3 world_normal(const struct shade *h, struct v3 n, vd e, vd *ew)
{
    const double *const *p = h->instance;
    struct v3 m = {n.x * vgather(p, INSTANCE_AT(inverse)), n.y * vgather(p, INSTANCE_AT(inverse) + 1),
                   n.z * vgather(p, INSTANCE_AT(inverse) + 2)};

    m = v3_unit(m, BOUND_OF(WORLD_NORMAL, (e + BOUND(WORLD_SCALED)) / vgather(p, INSTANCE_AT(least))), ew);
    *ew = *ew + BOUND(WORLD_ROUNDING);
    return v3_add(
        v3_scale(v3_gather(p, INSTANCE_AT(axes)), m.x),
        v3_add(v3_scale(v3_gather(p, INSTANCE_AT(axes) + 3), m.y), v3_scale(v3_gather(p, INSTANCE_AT(axes) + 6), m.z)));
}

static void place_normals(struct shade *h, unsigned placed)
{
    vd e;
    struct v3 n = world_normal(h, h->geometric, h->eg, &e);

    h->geometric = v3_sel(mof(placed), n, h->geometric);
    h->eg = vsel(mof(placed), e, h->eg);
    n = world_normal(h, h->normal, h->en, &e);
    h->normal = v3_sel(mof(placed), n, h->normal);
    h->en = vsel(mof(placed), e, h->en);
    h->exact = mand(h->exact, mnot(mof(placed)));
}

/* Sets the normals of spheres, which point away from the centre. */
static void round_normals(struct shade *h, unsigned lanes)
{
    static const double zero[3];
    const double *at[LANES];
    unsigned sphere = 0;
    vd e;

    for (int k = 0; k < LANES; k++) {
        bool is = lanes >> k & 1 && h->object[k]->kind == SURE_SPHERE;
        sphere |= (unsigned)is << k;
        at[k] = is ? h->object[k]->at : zero;
    }
    if (!sphere)
        return;
    struct v3 n = v3_unit(v3_sub(h->local, v3_gather(at, 0)), BOUND_OF(ROUND_NORMAL, h->elocal), &e);
    h->geometric = v3_sel(mof(sphere), n, h->geometric);
    h->eg = vsel(mof(sphere), e, h->eg);
}

#define ROUND_AT(field) (int)(offsetof(struct sure_round, field) / sizeof(double))

/* Sets the normals of the sides of cylinders and cones: the direction away from the axis, tilted by the slope. Their
 * parts across and along the axis have the lengths cosine and sine, so their length is 1 but for roundings. A
 * cylinder's point is off by f' ep at most across the axis (cylinder_tmpl.h), where f' <= f + ed is the length of the
 * fixed-point direction's part across it. That bound has 4 u t to spare; doubles also round by 2 u of the point and 4 u
 * of its way from the base. The normal is off across the axis only, but for 2^-48. */
static void side_normals(struct shade *h, unsigned lanes)
{
    static const struct sure_round none;
    const double *at[LANES];
    unsigned side = 0, straight = 0;
    vd e;

    for (int k = 0; k < LANES; k++) {
        bool is = lanes >> k & 1 && h->object[k]->kind == SURE_ROUND && h->element[k] == ROUND_SIDE;
        const struct sure_round *round = is ? h->object[k]->round : &none;
        side |= (unsigned)is << k;
        straight |= (unsigned)(is && round->sine == 0 && !h->object[k]->placed) << k;
        at[k] = (const double *)(const void *)round;
    }
    if (!side)
        return;
    struct v3 axis = v3_gather(at, 0), a0 = v3_gather(at, ROUND_AT(across)), a1 = v3_gather(at, ROUND_AT(across) + 3);
    struct v3 v = v3_sub(h->local, v3_gather(at, ROUND_AT(base)));
    vd cosine = vgather(at, ROUND_AT(cosine)), sine = vgather(at, ROUND_AT(sine));
    vd y0 = v3_dot(h->viewer, a0), y1 = v3_dot(h->viewer, a1);
    h->across = vsel(mof(straight), vmin(vsqrt(y0 * y0 + y1 * y1) + h->ev + BOUND(SIDE_ACROSS), vset(1)), vset(1));
    struct v3 out = {v3_dot(v, a0), v3_dot(v, a1), vset(0)};
    out = v3_unit(out,
                  BOUND_OF(SIDE_NORMAL, h->across * h->elocal) +
                      (v3_sum(h->local) + 2 * v3_sum(v)) * BOUND(SIDE_POINT) + BOUND(SIDE_UNITS),
                  &e);
    struct v3 n = v3_sub(v3_add(v3_scale(a0, out.x * cosine), v3_scale(a1, out.y * cosine)), v3_scale(axis, sine));
    h->geometric = v3_sel(mof(side), n, h->geometric);
    h->eg = vsel(mof(side), e + BOUND(SIDE_ROUNDING), h->eg);
}

/* Sets the smooth normals of the lanes `smooth`. */
static void smooth_normals(struct shade *h, struct smooth_faces *faces, unsigned smooth)
{
    struct smooth_normal n = smooth_normal_at(faces, h->local, h->elocal, h->geometric);
    vm m = mof(smooth);

    h->normal = v3_sel(m, n.normal, h->normal);
    h->en = vsel(m, n.e, h->en);
    h->unsure = mor(h->unsure, mand(m, mnot(n.fine)));
}

/* Returns the normal of a plane, cap, box or face, perhaps in `room`. *turned is set if it must be negated. */
static const double *flat_normal(const struct shade *h, int k, bool *turned, struct sure_flat *room)
{
    static const double axes[6][3] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
    const struct sure_object *o = h->object[k];

    *turned = o->kind == SURE_ROUND && h->element[k] != ROUND_TOP;
    if (o->kind == SURE_MESH)
        return sure_flat_of(o->mesh, h->element[k], room)->normal;
    if (o->kind == SURE_TRIANGLE)
        return o->face->normal;
    if (o->kind == SURE_ROUND)
        return o->round->axis;
    return o->kind == SURE_BOX || o->kind == SURE_GRID ? axes[h->element[k] % 6] : o->normal;
}

LANE_OP bool is_round(const struct shade *h, int k)
{
    enum sure_kind kind = h->object[k]->kind;

    return kind == SURE_SPHERE || (kind == SURE_ROUND && h->element[k] == ROUND_SIDE);
}

LANE_OP bool is_smooth(const struct shade *h, int k)
{
    const struct sure_object *o = h->object[k];

    return o->kind == SURE_MESH && o->faces->faces[h->element[k]].corner[0].normal != TIA_NO_INDEX;
}

/* Finds the faces of the lanes `smooth`, and sets their normals. */
static __attribute__((noinline)) void find_smooth_normals(struct shade *h, unsigned smooth)
{
    struct smooth_faces faces;

    for (int k = 0; k < LANES; k++)
        set_smooth_face(&faces, k, smooth >> k & 1 ? h->object[k] : NULL, h->element[k]);
    smooth_normals(h, &faces, smooth);
}

static void find_normals(struct shade *h, unsigned lanes)
{
    static const double none[3];
    const double *flat[LANES];
    struct sure_flat rooms[LANES];
    unsigned smooth = 0, round = 0, back = 0;

    for (int k = 0; k < LANES; k++) {
        bool turned = false;
        flat[k] = none;
        if (lanes >> k & 1) {
            flat[k] = flat_normal(h, k, &turned, &rooms[k]);
            round |= (unsigned)is_round(h, k) << k;
            smooth |= (unsigned)is_smooth(h, k) << k;
        }
        back |= (unsigned)turned << k;
    }
    h->geometric = v3_gather(flat, 0);
    if (back)
        h->geometric = v3_sel(mof(back), v3_neg(h->geometric), h->geometric);
    h->eg = vset(BOUND(CONVERTED));
    h->across = vset(1);
    h->exact = mof(lanes & ~(smooth | round));
    round_normals(h, lanes);
    side_normals(h, lanes);
    h->normal = h->geometric;
    h->en = h->eg;
    if (smooth)
        find_smooth_normals(h, smooth);
}

/* Turns the normals towards the viewer. */
LANE_OP void turn(struct shade *h)
{
    vd side = v3_dot(h->geometric, h->viewer), bound = BOUND_OF(SIDE, h->eg + h->ev + BOUND(COSINE));

    h->back = vlt(side, vset(0));
    h->unsure = mor(h->unsure, vle(vabs(side), bound));
    h->geometric = v3_sel(h->back, v3_neg(h->geometric), h->geometric);
    h->normal = v3_sel(h->back, v3_neg(h->normal), h->normal);
    h->facing = v3_dot(h->normal, h->viewer);
    h->efacing = BOUND_OF(FACING, h->en + h->ev + BOUND(COSINE));
}

/* Returns the mirrored directions. If two mirrors' normals differ by dn, their angle has a sine of dn at most. The part
 * of D in the plane of the normals is mirrored to directions twice that angle apart: 2 dn |that part| at most. */
LANE_OP struct v3 mirrored_at(const struct shade *h, vd *ed)
{
    return v3_unit(v3_sub(v3_scale(h->normal, 2 * h->facing), h->viewer),
                   BOUND_OF(MIRRORED, 2 * h->across * h->en + h->ev) + BOUND(MIRRORED_ROUNDING), ed);
}

/* Returns the origin of rays off the surface, P + bias G. */
LANE_OP struct v3 off_surface(const struct sure_scene *s, const struct shade *h, double bias, vd *eo)
{
    struct v3 o = v3_along(h->point, h->geometric, vset(bias));

    *eo = BOUND_OF(OUTSIDE, h->ep + BOUND_OF(OUTSIDE_NORMAL, h->eg * vset(s->bias)) + BOUND(POINT_UNITS) +
                                v3_sum(o) * BOUND(POINT_ROUNDING));
    return o;
}

/* Classifies rays from the side `sign` G of the surface, in direction d: certainly leaving it, or undecided. */
LANE_OP struct origin leaving(const struct shade *h, struct v3 d, vd ed, double sign, double least)
{
    vm away = vlt(BOUND_OF(LEAVING, h->eg + ed + vset(BOUND(COSINE) + least)), v3_dot(h->geometric, d) * sign);
    vm inside = sign > 0 ? h->back : mnot(h->back);

    return (struct origin){vsel(away, h->id, vset(-1)), h->part, vsel(inside, vset(1), vset(0))};
}

/* Computes the surfaces at the points that the rays of these lanes hit. */
static void find_surfaces(const struct sure_scene *s, const struct packet *p, const struct query *q, unsigned lanes,
                          struct shade *h)
{
    vm m = mof(lanes);
    vd t = vsel(m, q->t, vset(0));

    h->point = v3_along(p->o, p->d, t);
    h->ep = vsel(m, q->ep, vset(0)) + (v3_sum(p->o) + t) * BOUND(SURFACE_POINT);
    h->viewer = v3_neg(p->d);
    h->ev = p->ed;
    find_objects(s, q, lanes, h);
    unsigned textured = find_materials(s, lanes, h), placed = find_local(h);
    find_textures(s, textured, h);
    find_normals(h, lanes);
    if (placed)
        place_normals(h, placed);
    turn(h);
    h->outside = off_surface(s, h, s->bias, &h->eoutside);
}

#endif
