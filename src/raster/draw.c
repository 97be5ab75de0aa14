#include "depth.h"
#include "rows.h"
#include "target.h"

struct job {
    struct tia_raster_target *target;
    const struct tia_raster_state *state;
    const struct polygon *polygon;
    uint32_t face;
};

/* OpenGL's order makes a comparison the set of its results: less 1, equal 2, greater 4. `order` is -1, 0 or 1. */
static inline bool passes(enum tia_compare test, int order)
{
    return (unsigned)test >> (order + 1) & 1;
}

/* The order of two planes; ties as the state says. */
static int order_of_planes(const struct job *job, int x, int y, uint32_t there)
{
    struct tia_raster_target *t = job->target;

    t->exact++;
    int order = tia_depth_order(job->polygon, &t->planes[there], x, y);
    if (!order && job->state->ties_by_face)
        return job->face < there ? 1 : -1;
    return order;
}

/* 1 where the polygon is nearer than what is there, -1 farther, 0 equal. Asked where nearness alone does not tell. */
static inline int exact_order(const struct job *job, int x, int y, size_t at)
{
    uint32_t there = job->target->face[at];

    if (there == TIA_NO_FACE)
        return 1;
    return there == job->face ? 0 : order_of_planes(job, x, y, there);
}

static inline int order_at(const struct job *job, int64_t z, int x, int y, size_t at)
{
    int64_t difference = z - (int64_t)job->target->nearness[at];

    if (difference > DEPTH_UNSURE)
        return 1;
    return difference < -DEPTH_UNSURE ? -1 : exact_order(job, x, y, at);
}

static inline void put_depth(const struct job *job, int64_t z, size_t at)
{
    job->target->nearness[at] = z < 0 ? 0 : (uint64_t)z; /* a step's error may lead below infinity */
    job->target->face[at] = job->face;
}

static uint8_t operate(enum tia_stencil_op op, uint8_t old, uint8_t reference)
{
    switch (op) {
    case TIA_ZERO:
        return 0;
    case TIA_REPLACE:
        return reference;
    case TIA_INCR:
        return old == 255 ? 255 : (uint8_t)(old + 1);
    case TIA_DECR:
        return old == 0 ? 0 : (uint8_t)(old - 1);
    case TIA_INVERT:
        return (uint8_t)~old;
    case TIA_INCR_WRAP:
        return (uint8_t)(old + 1);
    case TIA_DECR_WRAP:
        return (uint8_t)(old - 1);
    case TIA_KEEP:
        break;
    }
    return old;
}

static inline void put_stencil(struct tia_raster_target *t, const struct tia_stencil *s, enum tia_stencil_op op,
                               size_t at)
{
    if (t->count)
        t->count[at] += op == TIA_INCR_WRAP ? 1 : op == TIA_DECR_WRAP ? UINT32_MAX : 0;
    if (!t->stencil)
        return;
    uint8_t old = t->stencil[at], now = operate(op, old, s->reference);

    t->stencil[at] = (uint8_t)((old & ~s->write) | (now & s->write));
}

static inline bool stencil_passes(const struct tia_raster_target *t, const struct tia_stencil *s, size_t at)
{
    int a = s->reference & s->mask, b = t->stencil[at] & s->mask;

    return passes(s->test, (a > b) - (a < b));
}

static bool depth_passes(const struct job *job, int64_t z, int x, int y, size_t at)
{
    enum tia_compare test = job->state->depth;

    if (test == TIA_ALWAYS || test == TIA_NEVER || !job->target->face)
        return test != TIA_NEVER || !job->target->face;
    return passes(test, -order_at(job, z, x, y, at));
}

static void put_colour(const struct job *job, size_t at)
{
    for (int c = 0; c < 3; c++)
        if (job->state->colour_write[c])
            job->target->colour[3 * at + (size_t)c] = job->state->colour[c];
}

static void draw_pixel(const struct job *job, const struct tia_stencil *s, int64_t z, int x, int y)
{
    struct tia_raster_target *t = job->target;
    size_t at = target_index(t, x, y);

    if (t->stencil && !stencil_passes(t, s, at)) {
        put_stencil(t, s, s->fail, at);
        return;
    }
    bool seen = depth_passes(job, z, x, y, at);
    if (t->stencil || t->count)
        put_stencil(t, s, seen ? s->zpass : s->zfail, at);
    if (seen && t->face && job->state->depth_write)
        put_depth(job, z, at);
    if (seen && t->colour)
        put_colour(job, at);
}

static inline const struct tia_stencil *stencil_of(const struct job *job)
{
    return job->polygon->front ? &job->state->front : &job->state->back;
}

static void general_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;
    const struct tia_stencil *s = stencil_of(job);
    struct depth_run run = tia_depth_run(job->polygon, y, x0, x1);

    for (int x = x0; x < x1; x++) {
        draw_pixel(job, s, run.steady ? (int64_t)run.z : tia_depth_at(job->polygon, x, y), x, y);
        run.z += run.step;
    }
}

static inline bool is_unsure(int64_t difference)
{
    return (uint64_t)difference + DEPTH_UNSURE <= 2 * DEPTH_UNSURE;
}

/* Depth alone, the nearest wins. */
static void nearest_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;
    struct depth_run run = tia_depth_run(job->polygon, y, x0, x1);
    size_t at = target_index(job->target, x0, y);
    uint64_t *there = job->target->nearness, z = run.z, step = run.step;
    uint32_t *faces = job->target->face, face = job->face;

    if (!run.steady) {
        for (int x = x0; x < x1; x++, at++) {
            int64_t at_pixel = tia_depth_at(job->polygon, x, y);
            if (order_at(job, at_pixel, x, y, at) > 0)
                put_depth(job, at_pixel, at);
        }
        return;
    }
    for (int x = x0; x < x1; x++, at++, z += step) {
        int64_t difference = (int64_t)(z - there[at]);
        if (difference < -DEPTH_UNSURE || (difference <= DEPTH_UNSURE && exact_order(job, x, y, at) <= 0))
            continue;
        there[at] = (int64_t)z < 0 ? 0 : z; /* a step's error may lead below infinity */
        faces[at] = face;
    }
}

/* Pixels that are counted: where the polygon is nearer, or where it is not. */
struct counting {
    const struct job *job;
    uint64_t flip;   /* all bits: where it is nearer */
    uint32_t step;   /* 1 or -1 */
    uint32_t *count; /* or the stencil buffer, when this is NULL */
    uint8_t *stencil;
};

static inline void count_one(const struct counting *c, size_t at, uint32_t step)
{
    if (c->count)
        c->count[at] += step;
    else
        c->stencil[at] = (uint8_t)(c->stencil[at] + step);
}

/* The difference's sign bit tells, the other way round when nearer ones count. What is not written to is in no
 * structure here, since a byte that is written may be any. */
static void count_steady(const struct counting *c, struct depth_run run, int y, int x0, int x1)
{
    size_t at = target_index(c->job->target, x0, y);
    const uint64_t *there = c->job->target->nearness;
    uint64_t flip = c->flip, z = run.z, step = run.step;
    uint32_t one = c->step, *count = c->count;

    for (int x = x0; x < x1; x++, at++, z += step) {
        uint64_t difference = z - there[at];
        if (is_unsure((int64_t)difference))
            difference = exact_order(c->job, x, y, at) > 0 ? 1 : UINT64_MAX;
        count[at] += (uint32_t)((int64_t)(difference ^ flip) >> 63) & one;
    }
}

static void count_run(const struct counting *c, int y, int x0, int x1)
{
    const struct job *job = c->job;
    struct depth_run run = tia_depth_run(job->polygon, y, x0, x1);
    size_t at = target_index(job->target, x0, y);

    if (run.steady && c->count) {
        count_steady(c, run, y, x0, x1);
        return;
    }
    for (int x = x0; x < x1; x++, at++, run.z += run.step) {
        int64_t z = run.steady ? (int64_t)run.z : tia_depth_at(job->polygon, x, y);
        if ((order_at(job, z, x, y, at) > 0) == (c->flip != 0))
            count_one(c, at, c->step);
    }
}

/* What shadow volumes do all the time. */
static void counting_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;
    const struct tia_stencil *s = stencil_of(job);
    bool nearer = s->zfail == TIA_KEEP;
    struct counting c = {job, nearer ? UINT64_MAX : 0, 1, job->target->count, job->target->stencil};

    if ((nearer ? s->zpass : s->zfail) == TIA_DECR_WRAP)
        c.step = UINT32_MAX;
    count_run(&c, y, x0, x1);
}

static bool counts(enum tia_stencil_op op)
{
    return op == TIA_INCR_WRAP || op == TIA_DECR_WRAP;
}

static bool is_counting(const struct job *job)
{
    const struct tia_raster_target *t = job->target;
    const struct tia_raster_state *state = job->state;
    const struct tia_stencil *s = stencil_of(job);
    bool one = (s->zfail == TIA_KEEP && counts(s->zpass)) || (s->zpass == TIA_KEEP && counts(s->zfail));

    return one && s->test == TIA_ALWAYS && s->write == 255 && state->depth == TIA_LESS && !state->depth_write &&
           !t->stencil != !t->count && t->face &&
           (!t->colour || !(state->colour_write[0] || state->colour_write[1] || state->colour_write[2]));
}

static bool never_counts(const struct tia_stencil *s)
{
    return !counts(s->zfail) && !counts(s->zpass);
}

static bool is_depth_alone(const struct tia_raster_target *t, const struct tia_raster_state *s)
{
    return s->depth == TIA_LESS && s->depth_write && t->face && !t->stencil && !t->colour &&
           (!t->count || (never_counts(&s->front) && never_counts(&s->back)));
}

static bool is_valid(const struct tia_raster_target *t, const struct tia_raster_state *s, unsigned count, uint32_t face)
{
    return count >= 3 && count <= TIA_RASTER_CORNERS && (!s->depth_write || !t->face || face < t->face_count);
}

int tia_draw_polygon(struct tia_raster_target *target, const struct tia_raster_state *state,
                     const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    struct polygon p;
    struct job job = {target, state, &p, face};
    int status;

    if (!is_valid(target, state, count, face))
        return TIA_ERR_ARGUMENT;
    status = tia_polygon_init(&p, target->lattice, target->area, corners, count);
    if (status || !p.count || (p.front ? state->skip_front : state->skip_back))
        return status;
    if (state->ahead && target->lattice->projection == TIA_ORTHOGRAPHIC)
        tia_polygon_cut_ahead(&p);
    if (state->depth_write && target->face && !target->planes_known)
        tia_depth_plane(&p, &target->planes[face]);
    tia_polygon_rows(&p,
                     is_depth_alone(target, state) ? nearest_run
                     : is_counting(&job)           ? counting_run
                                                   : general_run,
                     &job);
    return TIA_OK;
}

int tia_raster_plane_init(struct tia_raster_plane *plane, const struct tia_lattice *lattice,
                          const struct tia_raster_vertex *corners, unsigned count)
{
    struct tia_tile all = {0, 0, lattice->width, lattice->height};
    struct polygon p;

    *plane = (struct tia_raster_plane){.det = {0, 0}};
    if (count < 3 || count > TIA_RASTER_CORNERS)
        return TIA_ERR_ARGUMENT;
    int status = tia_polygon_init(&p, lattice, all, corners, count);
    if (!status && p.count)
        tia_depth_plane(&p, plane);
    return status;
}
