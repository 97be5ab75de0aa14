/* shrink.c - the search for the fewest triangles in the simplest states. */
#include <stdlib.h>
#include <string.h>

#include "trial.h"

struct search {
    trial_drawer *drawer;
    void *ctx;
    struct pixels exact, found;
    unsigned first;
    bool failed;
};

/* True if a pixel still differs. */
static bool shows(struct search *s, const struct trial *trial)
{
    if (!trial_exact(NULL, trial, &s->exact) || !s->drawer(s->ctx, trial, &s->found))
        s->failed = true;
    return !s->failed && trial_differs(&s->exact, &s->found, &s->first) > 0;
}

/* Replaces *trial by `changed` if that still shows a difference. */
static bool keep(struct search *s, struct trial *trial, const struct trial *changed)
{
    if (memcmp(trial, changed, sizeof *trial) == 0 || !shows(s, changed))
        return false;
    *trial = *changed;
    return true;
}

/* Removes one triangle after the other, as long as one can be removed. */
static bool remove_triangles(struct search *s, struct trial *trial)
{
    bool any = false;

    for (unsigned i = trial->count; i-- > 0;) {
        struct trial changed = *trial;
        memmove(changed.triangles + i, changed.triangles + i + 1, (trial->count - i - 1) * sizeof *changed.triangles);
        changed.count--;
        any |= keep(s, trial, &changed);
    }
    return any;
}

static const struct tia_stencil plain = {.test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255};

/* Makes one part of a state simpler. */
static void simplify(struct tia_raster_state *state, unsigned step)
{
    struct tia_stencil *side = step % 2 ? &state->front : &state->back;

    switch (step / 2) {
    case 0:
        state->skip_front = state->skip_back = false;
        break;
    case 1:
        *side = plain;
        break;
    case 2:
        state->depth = TIA_COMPARE_ALWAYS;
        break;
    case 3:
        state->depth_write = true;
        memset(state->colour_write, true, sizeof state->colour_write);
        break;
    case 4:
        side->mask = side->write = 255;
        break;
    case 5:
        side->test = TIA_COMPARE_ALWAYS;
        break;
    case 6:
        side->fail = TIA_STENCIL_KEEP;
        break;
    case 7:
        side->zfail = TIA_STENCIL_KEEP;
        break;
    default:
        side->zpass = TIA_STENCIL_KEEP;
        break;
    }
}

static bool simplify_states(struct search *s, struct trial *trial)
{
    bool any = false;

    for (unsigned i = 0; i < trial->count; i++) {
        for (unsigned step = 0; step < 18; step++) {
            struct trial changed = *trial;
            simplify(&changed.triangles[i].state, step);
            any |= keep(s, trial, &changed);
        }
    }
    return any;
}

/* Moves corners to coarser positions: whole pixels, halves, quarters. */
static bool simplify_corners(struct search *s, struct trial *trial)
{
    bool any = false;

    for (unsigned i = 0; i < 3 * trial->count; i++) {
        for (int32_t step = 256; step >= 16; step /= 2) {
            struct trial changed = *trial;
            struct triangle *triangle = &changed.triangles[i / 3];
            triangle->x[i % 3] = triangle->x[i % 3] / step * step;
            triangle->y[i % 3] = triangle->y[i % 3] / step * step;
            if (keep(s, trial, &changed)) {
                any = true;
                break;
            }
        }
    }
    return any;
}

/* True if the centre of a pixel is on the line of an edge. */
static bool is_tied(const struct triangle *t, unsigned x, unsigned y)
{
    for (int k = 0; k < 3; k++) {
        int64_t dx = t->x[(k + 1) % 3] - t->x[k], dy = t->y[(k + 1) % 3] - t->y[k];
        if (dx * (256 * (int64_t)y + 128 - t->y[k]) == dy * (256 * (int64_t)x + 128 - t->x[k]))
            return true;
    }
    return false;
}

static bool is_plain(const struct tia_stencil *s)
{
    return s->test == TIA_COMPARE_ALWAYS && s->zfail == TIA_STENCIL_KEEP && s->zpass == TIA_STENCIL_KEEP;
}

static bool has_stencil(const struct trial *trial)
{
    for (unsigned i = 0; i < trial->count; i++)
        if (!is_plain(&trial->triangles[i].state.front) || !is_plain(&trial->triangles[i].state.back))
            return true;
    return false;
}

/* Returns the rule: that of what a simplest trial still needs. */
static enum rule rule_of(const struct trial *trial, unsigned x, unsigned y)
{
    bool depth = false;

    for (unsigned i = 0; i < trial->count; i++) {
        if (is_tied(&trial->triangles[i], x, y))
            return RULE_TIES;
        depth |= trial->triangles[i].state.depth != TIA_COMPARE_ALWAYS;
    }
    return has_stencil(trial) ? RULE_STENCIL : depth ? RULE_DEPTH : RULE_EDGES;
}

bool trial_shrink(const struct trial *trial, trial_drawer *drawer, void *ctx, struct finding *finding)
{
    static struct search s; /* static, since it is large for a stack */
    bool again = true;

    s.drawer = drawer;
    s.ctx = ctx;
    s.failed = false;
    finding->trial = *trial;
    while (again && !s.failed) {
        again = remove_triangles(&s, &finding->trial);
        again |= simplify_states(&s, &finding->trial);
        again |= simplify_corners(&s, &finding->trial);
    }
    if (s.failed || !shows(&s, &finding->trial))
        return false;
    finding->x = s.first % SIDE;
    finding->y = s.first / SIDE;
    finding->rule = rule_of(&finding->trial, finding->x, finding->y);
    finding->face[0] = s.exact.face[s.first];
    finding->face[1] = s.found.face[s.first];
    finding->stencil[0] = s.exact.stencil[s.first];
    finding->stencil[1] = s.found.stencil[s.first];
    return true;
}
