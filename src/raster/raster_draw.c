#include "depth.h"
#include "polygon_rows.h"
#include "runs.h"
#include "target.h"

struct job {
    struct tia_raster_target *target;
    const struct tia_raster_state *state;
    const struct polygon *polygon;
    uint32_t face;
    const struct tia_raster_runs *runs;
    struct raster_polygon shared; /* data that all runs share */
    uint32_t *equal;              /* a face whose plane is the polygon's, or TIA_NO_FACE */
};

/* True if the test passes; `order` is -1, 0 or 1. The number of a comparison, as in OpenGL, is a set of bits: less 1,
 * equal 2, greater 4. */
static inline bool passes(enum tia_compare test, int order)
{
    return (unsigned)test >> (order + 1) & 1;
}

/* Returns the order of the polygon and a face with the same plane. */
static inline int order_of_equal(const struct job *job, uint32_t there)
{
    job->target->exact++;
    return !job->state->ties_by_face ? 0 : job->face < there ? 1 : -1;
}

/* Returns the order of the polygon and face `there` by their planes; if these are equal, the state's ties_by_face
 * decides. */
static int order_of_planes(const struct job *job, int x, int y, uint32_t there)
{
    struct tia_raster_target *t = job->target;

    if (there == *job->equal)
        return order_of_equal(job, there);
    int order = tia_depth_order(job->polygon, &t->planes[there], x, y);
    if (order) {
        t->exact++;
        return order;
    }
    *job->equal = there; /* planes that are equal at one pixel are equal at all, see tia_depth_order() */
    return order_of_equal(job, there);
}

/* Returns 1 if the polygon is nearer than the face stored at the pixel, -1 if farther, 0 if equal; for pixels where
 * nearness does not decide. */
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
    job->target->nearness[at] = z < 0 ? 0 : (uint64_t)z; /* errors may lead below 0, that is, infinity */
    job->target->face[at] = job->face;
}

static uint8_t operate(enum tia_stencil_op op, uint8_t old, uint8_t reference)
{
    switch (op) {
    case TIA_STENCIL_ZERO:
        return 0;
    case TIA_STENCIL_REPLACE:
        return reference;
    case TIA_STENCIL_INCR:
        return old == 255 ? 255 : (uint8_t)(old + 1);
    case TIA_STENCIL_DECR:
        return old == 0 ? 0 : (uint8_t)(old - 1);
    case TIA_STENCIL_INVERT:
        return (uint8_t)~old;
    case TIA_STENCIL_INCR_WRAP:
        return (uint8_t)(old + 1);
    case TIA_STENCIL_DECR_WRAP:
        return (uint8_t)(old - 1);
    case TIA_STENCIL_KEEP:
        break;
    }
    return old;
}

static inline void put_stencil(struct tia_raster_target *t, const struct tia_stencil *s, enum tia_stencil_op op,
                               size_t at)
{
    if (t->count)
        t->count[at] += op == TIA_STENCIL_INCR_WRAP ? 1 : op == TIA_STENCIL_DECR_WRAP ? UINT32_MAX : 0;
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

    if (test == TIA_COMPARE_ALWAYS || test == TIA_COMPARE_NEVER || !job->target->face)
        return test != TIA_COMPARE_NEVER || !job->target->face;
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
    struct depth_run run = depth_run(job->polygon, y, x0, x1);

    for (int x = x0; x < x1; x++) {
        draw_pixel(job, s, run.steady ? (int64_t)run.z : tia_depth_at(job->polygon, x, y), x, y);
        run.z += run.step;
    }
}

static bool is_nearer(const void *ctx, size_t at)
{
    const struct job *job = ctx;
    const struct tia_raster_target *t = job->target;
    uint32_t there = t->face[at];

    if (there == job->face || there == TIA_NO_FACE)
        return there == TIA_NO_FACE;
    if (there == *job->equal)
        return order_of_equal(job, there) > 0;
    int x = (int)(t->area.x + at % t->pitch), y = (int)(t->area.y + at / t->pitch);
    return order_of_planes(job, x, y, there) > 0;
}

/* Draws a run by one of job->runs; in parts where nearness is clamped. */
static void kernel_run(const struct job *job, raster_run_kernel *draw, int y, int x0, int x1)
{
    struct depth_run run = depth_run(job->polygon, y, x0, x1);

    if (run.steady) {
        draw(&job->shared, target_index(job->target, x0, y), x1 - x0, run.z);
        return;
    }
    struct raster_polygon part = job->shared;
    for (int x = x0, end; x < x1; x = end) {
        end = tia_depth_part(job->polygon, y, x, x1, &run);
        part.step = run.step;
        draw(&part, target_index(job->target, x, y), end - x, run.z);
    }
}

/* Draws depth alone, keeping the nearest face. */
static void nearest_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;

    kernel_run(job, job->runs->nearest, y, x0, x1);
}

/* Draws a face of a shadow volume, with counts in words. */
static void counting_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;

    kernel_run(job, job->runs->add, y, x0, x1);
}

/* Draws a face of a shadow volume, with counts in the stencil. */
static void stencil_run(void *ctx, int y, int x0, int x1)
{
    const struct job *job = ctx;
    struct depth_run run = depth_run(job->polygon, y, x0, x1);
    size_t at = target_index(job->target, x0, y);
    uint8_t *stencil = job->target->stencil;

    for (int x = x0; x < x1; x++, at++, run.z += run.step) {
        int64_t z = run.steady ? (int64_t)run.z : tia_depth_at(job->polygon, x, y);
        if ((order_at(job, z, x, y, at) > 0) == job->shared.nearer)
            stencil[at] = (uint8_t)(stencil[at] + job->shared.one);
    }
}

/* Prepares the data that the runs share. */
static void share(struct job *job)
{
    const struct tia_raster_target *t = job->target;
    const struct tia_stencil *s = stencil_of(job);
    bool nearer = s->zfail == TIA_STENCIL_KEEP;
    uint32_t one = (nearer ? s->zpass : s->zfail) == TIA_STENCIL_DECR_WRAP ? UINT32_MAX : 1;

    job->runs = t->runs ? t->runs : &tia_raster_runs_plain;
    job->shared = (struct raster_polygon){t->nearness, t->face,   t->count, (uint64_t)job->polygon->depth.step,
                                          job->face,   nearer,    one,      is_nearer,
                                          job,         job->equal};
}

static bool counts(enum tia_stencil_op op)
{
    return op == TIA_STENCIL_INCR_WRAP || op == TIA_STENCIL_DECR_WRAP;
}

static bool is_counting(const struct job *job)
{
    const struct tia_raster_target *t = job->target;
    const struct tia_raster_state *state = job->state;
    const struct tia_stencil *s = stencil_of(job);
    bool one = (s->zfail == TIA_STENCIL_KEEP && counts(s->zpass)) || (s->zpass == TIA_STENCIL_KEEP && counts(s->zfail));

    return one && s->test == TIA_COMPARE_ALWAYS && s->write == 255 && state->depth == TIA_COMPARE_LESS &&
           !state->depth_write && !t->stencil != !t->count && t->face &&
           (!t->colour || !(state->colour_write[0] || state->colour_write[1] || state->colour_write[2]));
}

static bool never_counts(const struct tia_stencil *s)
{
    return !counts(s->zfail) && !counts(s->zpass);
}

static bool is_depth_alone(const struct tia_raster_target *t, const struct tia_raster_state *s)
{
    return s->depth == TIA_COMPARE_LESS && s->depth_write && t->face && !t->stencil && !t->colour &&
           (!t->count || (never_counts(&s->front) && never_counts(&s->back)));
}

/* True if all enums are valid: each has eight values, so all are valid if their OR is below 8. */
static bool is_state(const struct tia_raster_state *s)
{
    return ((unsigned)s->depth | (unsigned)s->front.test | (unsigned)s->front.fail | (unsigned)s->front.zfail |
            (unsigned)s->front.zpass | (unsigned)s->back.test | (unsigned)s->back.fail | (unsigned)s->back.zfail |
            (unsigned)s->back.zpass) <= TIA_COMPARE_ALWAYS;
}

static bool is_valid(const struct tia_raster_target *t, const struct tia_raster_state *s,
                     const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    return t && t->grid && s && corners && is_state(s) && count >= 3 && count <= TIA_RASTER_CORNERS &&
           (!s->depth_write || !t->face || face < t->face_count);
}

int tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                    const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    struct polygon p;
    uint32_t equal = TIA_NO_FACE;
    struct job job = {.target = target, .state = state, .polygon = &p, .face = face, .equal = &equal};
    int status;

    if (!is_valid(target, state, corners, count, face))
        return TIA_ERR_ARGUMENT;
    status = tia_polygon_init(&p, target->grid, target->area, corners, count);
    if (status || !p.count || (p.front ? state->skip_front : state->skip_back))
        return status;
    if (state->ahead && target->grid->projection == TIA_ORTHOGRAPHIC)
        tia_polygon_cut_ahead(&p);
    if (state->depth_write && target->face && !target->planes_known)
        tia_depth_plane(&p, &target->planes[face]);
    share(&job);
    tia_polygon_rows(&p,
                     is_depth_alone(target, state) ? nearest_run
                     : !is_counting(&job)          ? general_run
                     : target->count               ? counting_run
                                                   : stencil_run,
                     &job);
    return TIA_OK;
}

int tia_raster_plane_init(struct tia_raster_plane *plane, const struct tia_raster_grid *grid,
                          const struct tia_raster_vertex *corners, unsigned count)
{
    struct polygon p;

    if (!plane || !grid)
        return TIA_ERR_ARGUMENT;
    *plane = (struct tia_raster_plane){.det = {0, 0}};
    if (!corners || count < 3 || count > TIA_RASTER_CORNERS)
        return TIA_ERR_ARGUMENT;
    struct tia_tile all = {0, 0, grid->width, grid->height};
    int status = tia_polygon_init(&p, grid, all, corners, count);
    if (!status && p.count)
        tia_depth_plane(&p, plane);
    return status;
}
