/* plain_tmpl.h - the hits on faces that the rasteriser has found; packets of such hits that need no general shading:
 * flat faces that spawn no rays, all of one material, or background.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: find_seen(), shade_plain().
 *
 * A face's point is at the distance z from the eye, along the line of sight n, so that t = z/(D.-n). z is that of the
 * rasteriser's plane, whose corners were rounded, so the point may be off the object's surface by far more than the
 * fixed-point roundings that struct origin allows. So rays from there start on no object. */
#ifndef TIA_SIMD_RAYS_PLAIN_TMPL_H
#define TIA_SIMD_RAYS_PLAIN_TMPL_H

#include "sight_tmpl.h"
#include "tracer_tmpl.h"

/* Sets the query's distances to those of points whose distances along the line of sight are given. Returns the lanes
 * that are certain. */
LANE_OP vm meet_sights(const struct sure_scene *s, const struct packet *p, const struct sight *z, struct query *q)
{
    vd slope = -v3_dot(p->d, v3_set(s->camera.n)), eslope = BOUND_OF(PLANE_SLOPE, p->ed + BOUND(PLANE_WAY));
    vm fine = mand(z->fine, vlt(vset(BOUND(PLANE_STEEP)) + BOUND(SIGHT_KNOWN) * eslope, slope));
    vd inverse = 1 / vsel(fine, slope, vset(1));

    q->t = z->z * inverse;
    q->e = BOUND_OF(SIGHT_DISTANCE, (z->e + q->t * eslope) * inverse * BOUND(SIGHT_QUOTIENT)) + BOUND(QUOTIENT_UNIT) +
           q->t * BOUND(QUOTIENT);
    q->ep = BOUND_OF(POINT, q->e + p->eo + q->t * p->ed + BOUND(POINT_UNITS));
    return mand(fine, vlt(q->t + q->e, vset(65536))); /* NUM_LENGTH_FAR: farther points count as background */
}

/* Sets the query to the hits that the lanes' faces give. Returns the lanes that are undecided. */
static vm find_seen(const struct sure_scene *s, const struct packet *p, const struct sure_seen_face *const seen[LANES],
                    vd x, vd y, struct query *q)
{
    static const struct sure_seen_face none = {.inverse = {0, 0, 1}};
    const double *face[LANES];
    double id[LANES], element[LANES];
    unsigned sky = 0, curved = 0;

    for (int k = 0; k < LANES; k++) {
        const struct sure_seen_face *f = seen[k] ? seen[k] : &none;
        face[k] = f->inverse;
        id[k] = seen[k] ? (double)f->object : -1;
        element[k] = f->element;
        sky |= (unsigned)!seen[k] << k;
        curved |= (unsigned)(f->object == TIA_NO_OBJECT) << k;
    }
    struct sight z = sight_of(s->camera.orthographic, v3_gather(face, 0), x, y);
    vm fine = meet_sights(s, p, &z, q);

    q->t = vsel(mof(sky), vset(INFINITE), q->t);
    q->low = vset(INFINITE);
    q->id = vload(id);
    q->element = vload(element);
    return mor(mof(curved & ~sky), mand(mnot(mof(sky)), mnot(fine)));
}

/* ---- packets of plain faces ---- */

/* Multiplies the colours by those of a checkered plane, whose axes are the world's; see texture_colour(). */
static void checker(const struct sure_object *o, const struct sure_material *m, struct shade *h)
{
    struct v3 v = v3_sub(h->point, v3_set(o->at));
    vd odd = vset(0), round = v3_sum(v) * BOUND(UV_ALONG);
    vd e = BOUND_OF(UV_FLAT, (h->ep + round + BOUND(UV_ALONG_UNITS)) * vset(o->unit)) + BOUND(UV_UNITS) +
           BOUND(UV_ROUNDING);

    for (int i = 0; i < 2; i++) {
        vd uv = v3_dot(v, v3_set(o->axes[i])) * vset(o->unit), place = (uv - m->offset[i]) * m->repeat[i];
        vd off = BOUND_OF(TEXEL_PLACE,
                          (e + (vabs(uv) + __builtin_fabs(m->offset[i])) * BOUND(TEXEL_ROUNDING)) * m->repeat[i]) +
                 BOUND(TEXEL_UNITS);
        vd cell = vfloor(place - off), half = 0.5 * cell;
        vm sure = mand(vle(vfloor(place + off), cell), vlt(vabs(place) + off, vset(1073741824.0)));
        h->unsure = mor(h->unsure, mnot(sure));
        odd = vabs(odd - (cell - 2 * vfloor(half)));
    }
    vm second = vlt(vset(0.5), odd);
    for (int c = 0; c < 3; c++)
        h->colour[c] = h->colour[c] * vsel(second, vset(m->cells[1][c]), vset(m->cells[0][c]));
    h->ecolour = vset(BOUND(TEXEL_COLOUR));
}

#define NORMAL_AT (int)(offsetof(struct sure_seen_face, normal) / sizeof(double))

LANE_OP struct v3 gather_faces(const struct sure_seen_face *const face[LANES], int i)
{
    const double *row[LANES];

    for (int k = 0; k < LANES; k++)
        row[k] = (const double *)(const void *)face[k];
    return v3_gather(row, i);
}

/* Sets the surfaces of the packet's hits on plain faces of one material, see find_surfaces(). */
LANE_OP void find_plain_surfaces(const struct sure_scene *s, const struct packet *p, const struct query *q,
                                 const struct sure_seen_face *const face[LANES], bool same, struct shade *h)
{
    const struct sure_material *m = &s->materials[face[0]->material];

    h->point = v3_along(p->o, p->d, q->t);
    h->ep = q->ep + (v3_sum(p->o) + q->t) * BOUND(SURFACE_POINT);
    h->viewer = v3_neg(p->d);
    h->ev = p->ed;
    h->unsure = mnone();
    h->ecolour = vset(0);
    for (int c = 0; c < 3; c++) {
        h->colour[c] = vset(m->column[SURE_COLOUR + c]);
        h->specular[c] = vset(m->column[SURE_SPECULAR + c]);
    }
    h->exponent = vset(m->column[SURE_EXPONENT]);
    h->glossy = mof(m->is_specular ? (1u << LANES) - 1 : 0);
    if (m->texture)
        checker(&s->object[face[0]->object], m, h);
    h->geometric = h->normal = same ? v3_set(face[0]->normal) : gather_faces(face, NORMAL_AT);
    h->eg = h->en = vset(BOUND(CONVERTED));
    turn(h);
}

/* True if the packet can be shaded by shade_plain(): all lanes see one material, or only background. */
LANE_OP bool is_plain(const struct sure_scene *s, const struct sure_seen_face *const face[LANES], bool *same)
{
    *same = true;
    for (int k = 1; k < LANES; k++)
        *same = *same && face[k] == face[0];
    if (*same)
        return !face[0] || face[0]->plain;
    for (int k = 0; k < LANES; k++)
        if (!face[k] || !face[k]->plain || face[k]->material != face[0]->material)
            return false;
    return !s->materials[face[0]->material].texture;
}

/* Stores the samples of a packet of pixels of a row. */
LANE_OP void store_samples(struct sure_block *b, int slot, int count, const vd rgb[3], vd error, unsigned unsure)
{
    for (int c = 0; c < 3; c++)
        vstore(&b->colour[c][slot], rgb[c]);
    vstore(&b->error[slot], error);
    for (int k = 0; k < count; k++)
        b->unsure[slot + k] = unsure >> k & 1;
}

static void store_background_run(const struct sure_scene *s, struct sure_block *b, int slot, int count)
{
    vd rgb[3] = {vset(s->background[0]), vset(s->background[1]), vset(s->background[2])};

    store_samples(b, slot, count, rgb, BOUND(COLOUR_UNITS) * (1 + most3(rgb)), 0);
}

/* Shades `count` pixels of a row from (x, y) on, the first of which has this slot. `across` are the pixels' columns in
 * the image, 0..1. Returns false if they need general shading. */
static bool shade_plain(struct work *w, int slot, int x, int y, int count, const double *across)
{
    const struct sure_scene *s = w->block->scene;
    const struct sure_seen *seen = w->block->seen;
    const struct sure_seen_face *const *face = &seen->face[slot];
    struct known_lights known;
    struct lit lit;
    struct packet *p = &w->packet.p;
    struct query *q = &w->query;
    struct shade *h = &w->shade;
    bool same;

    if (!is_plain(s, face, &same))
        return false;
    if (!face[0]) {
        store_background_run(s, w->block, slot, count);
        return true;
    }
    known.seen = seen;
    for (int k = 0; k < LANES; k++)
        known.slot[k] = (uint32_t)(slot + k);
    set_known(&known);
#define COLUMN(k) x + (k)
    vd column = (vd){EACH_LANE(COLUMN)}, row = vset(y);
#undef COLUMN
    camera_rays(&s->camera, vload(across), vset((2.0 * y + 1) / (2.0 * s->camera.height)), p);
    struct sight z =
        sight_of(s->camera.orthographic, same ? v3_set(face[0]->inverse) : gather_faces(face, 0), column, row);
    vm fine = meet_sights(s, p, &z, q);
    const struct sure_material *m = &s->materials[face[0]->material];
    find_plain_surfaces(s, p, q, face, same, h);
    lit_begin(&lit, &w->block->cancel, &w->lights, &known);
    lit.unsure = mor(h->unsure, mnot(fine));
    lit.eown = BOUND_OF(COLOUR_FACING, sure_most3(m->column + SURE_FACING) * h->efacing) + BOUND(COLOUR_UNITS);
    for (int c = 0; c < 3; c++)
        lit.own[c] = m->column[SURE_EMISSION + c] + m->column[SURE_FACING + c] * vmax(h->facing, vset(0));
    for (uint32_t n = 0; n < s->light_count; n++)
        add_light(s, n, h, mnot(mnone()), false, w->class, &w->blocker[0], &lit);
    store_samples(w->block, slot, count, lit.own, BOUND_OF(COLOUR_OWN, lit.eown) + BOUND(COLOUR_UNITS),
                  mbits(lit.unsure));
    return true;
}

#endif
