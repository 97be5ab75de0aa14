/* seen_tmpl.h - a block of pixels whose faces and lights are known: no camera ray and no shadow ray is traced, but for
 * those of mirrored and refracted rays.
 *
 * Parameters: the doubles of isa/isa.h, the hooks of sure_check.h. Defines: shade_seen(), for lanes.h's table,
 * find_seen().
 */
#ifndef TIA_SIMD_RAYS_SEEN_TMPL_H
#define TIA_SIMD_RAYS_SEEN_TMPL_H

#include "plain_tmpl.h"

/* Replaces hits by lights in front of them. Returns the lanes that are undecided. */
static vm find_seen_lights(const struct sure_scene *s, const struct packet *p, struct query *q)
{
    if (!s->view->lit)
        return mnone();
    q->p = p;
    q->active = mnot(mnone());
    q->any = q->solid = false;
    q->groups = NULL;
    q->limit = vset(INFINITE);
    q->e = vsel(vle(vset(INFINITE), q->t), vset(0), q->e);
    meet_lights(s, q);
    vm sky = mand(vle(vset(INFINITE), q->t), vle(vset(INFINITE), q->low));
    return mnot(mor(sky, vlt(q->t + q->e, q->low)));
}

static void see(struct work *w, struct rays *r, unsigned lanes)
{
    const struct sure_scene *s = w->block->scene;
    struct known_lights known = {.seen = w->block->seen};
    const struct sure_seen_face *face[LANES];
    struct query *q = &w->query;
    struct shade *h = &w->shade;
    const double parts = 2 * s->camera.side * s->camera.side;

    for (int k = 0; k < LANES; k++) {
        known.slot[k] = r->slot[k];
        face[k] = known.seen->face[r->slot[k]];
    }
    set_known(&known);
#define COLUMN(k) w->place[0][r->slot[k]]
#define ROW(k) w->place[1][r->slot[k]]
    vm unsure = find_seen(s, &r->p, face, vfloor((vd){EACH_LANE(COLUMN)} / vset(parts)),
                          vfloor((vd){EACH_LANE(ROW)} / vset(parts)), q);
#undef COLUMN
#undef ROW
    drop(&lanes, w, mor(unsure, find_seen_lights(s, &r->p, q)), r);
    add_far(w, &lanes, q, r);
    if (!lanes)
        return;
    find_surfaces(s, &r->p, q, lanes, h);
    drop(&lanes, w, h->unsure, r);
    h->id = vset(-1);
    if (lanes)
        add_own(w, &lanes, h, r, &known);
    if (lanes)
        bounce(w, h, lanes, r);
}

/* Shades the block's samples w->order[0] .. w->order[count - 1]. */
static void shade_listed(struct work *w, struct sure_block *b, int count)
{
    draw(w, b, count, see);
}

/* Lists a slot for packets of any faces. */
LANE_OP void list_slot(struct work *w, int at, int slot, int x, int y)
{
    struct sure_block *b = w->block;

    w->order[at] = (uint16_t)slot;
    w->place[0][slot] = 2 * x + 1;
    w->place[1][slot] = 2 * y + 1;
    w->rays[slot] = w->class[slot] = 0;
    b->unsure[slot] = false;
    b->colour[0][slot] = b->colour[1][slot] = b->colour[2][slot] = b->error[slot] = 0;
}

/* Shades packets along rows where all their faces are plain. Returns the number of the others' slots, which are in
 * w->order. Lanes beyond a row's end spoil slots of the next row, before these are shaded. */
static int shade_rows(struct work *w, struct sure_block *b)
{
    int listed = 0;

    for (int x = 0; x < b->width + LANES; x++)
        w->across[x] = (2.0 * (b->x + x) + 1) / (2.0 * b->scene->camera.width);
    for (int y = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x += LANES) {
            int slot = y * b->width + x, count = b->width - x < LANES ? b->width - x : LANES;
            if (shade_plain(w, slot, b->x + x, b->y + y, count, &w->across[x]))
                continue;
            for (int k = 0; k < count; k++)
                list_slot(w, listed + k, slot + k, b->x + x + k, b->y + y);
            listed += count;
        }
    return listed;
}

static void shade_seen(struct sure_block *b, void *memory)
{
    struct work *w = memory;

    b->across = b->width;
    b->rows = 1;
    if (b->samples == 1 && !b->scene->view->lit) {
        work_begin(w, b);
        w->in_order = false;
        shade_listed(w, b, shade_rows(w, b));
        return;
    }
    work_open(w, b);
    for (int i = 0; i < SURE_SLOTS; i++)
        w->class[i] = 0;
    shade_listed(w, b, b->width * b->height * b->samples);
}

#endif
