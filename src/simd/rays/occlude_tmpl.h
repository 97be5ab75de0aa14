/* occlude_tmpl.h - ambient occlusion in packets: the steps of render/ao/ao.c.
 *
 * Parameters: the doubles of isa/isa.h. Defines: occlude(), for the table of lanes.h. */
#ifndef TIA_SIMD_RAYS_OCCLUDE_TMPL_H
#define TIA_SIMD_RAYS_OCCLUDE_TMPL_H

#include "path_state_tmpl.h"

/* Sets the samples of a packet: 0 where occluded, else 1. These values are exact, so that only the decisions can be
 * uncertain. */
static void occlude_packet(struct path_state *f, struct paths *p, unsigned lanes, const struct quads *first)
{
    const struct sure_scene *s = f->gather->scene;
    struct shadow *shadow = &f->shadow;
    struct query *q = &f->query;
    struct shade *h = &f->shade;
    vm unsure;

    for (int k = 0; lanes >> k; k++)
        for (int c = 0; c < 3; c++)
            f->gather->colour[p->r.slot[k]][c] = 1;
    find_first(s, &f->room, q, &p->r.p, lanes, false, 0);
    (void)cancelled(&f->gather->cancel, q->work);
    vm sky = mand(vle(vset(INFINITE), q->t), vle(vset(INFINITE), q->low));
    lanes = sure_of(f, lanes, mnot(mor(sky, vlt(q->t + q->e, q->low))), p->r.slot) & ~mbits(sky);
    if (!lanes)
        return;
    find_surfaces(s, &p->r.p, q, lanes, h);
    lanes = sure_of(f, lanes, h->unsure, p->r.slot);
    shadow->p.o = h->outside;
    shadow->p.eo = h->eoutside;
    shadow->p.d = around(h->normal, h->en, h->exact, cosine_direction(quads_number(first, 2), quads_number(first, 3)),
                         vset(BOUND(LOCAL)), &shadow->p.ed, &unsure);
    shadow->p.from = leaving(h, shadow->p.d, shadow->p.ed, 1, 0);
    shadow->distance = vset(s->paths->reach);
    shadow->edistance = vset(0);
    vd above = v3_dot(shadow->p.d, h->geometric), e = BOUND_OF(ABOVE, shadow->p.ed + h->eg + BOUND(COSINE));
    lanes = sure_of(f, lanes, mor(unsure, vle(vabs(above), e)), p->r.slot);
    unsigned below = lanes & mbits(vlt(above, vset(0))), open = lanes & ~below;
    shadow->blocked = shadow->unsure = mnone();
    if (open) {
        find_hidden(s, &f->room, shadow, open, NULL, &f->blocker);
        (void)cancelled(&f->gather->cancel, shadow->work);
    }
    mark_unsure(f, open & mbits(shadow->unsure), p->r.slot);
    below |= open & mbits(shadow->blocked);
    for (int k = 0; below >> k; k++)
        for (int c = 0; c < 3 && (below >> k & 1); c++)
            f->gather->colour[p->r.slot[k]][c] = 0;
}

static void occlude(struct sure_gather *g, void *memory)
{
    struct path_state *f = memory;
    struct quads first;

    path_open(f, g);
    for (int from = 0; from < g->count && !g->cancel.stopped; from += LANES) {
        unsigned lanes = path_start(f, from, &f->paths, &first);
        occlude_packet(f, &f->paths, lanes, &first);
    }
}

#endif
