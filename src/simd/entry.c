/* entry.c - calls of the SIMD kernels by the library: scratch memory and floating-point environment of a call. */
#include "environment.h"
#include "simd.h"

#define WORKERS_MAX 65536

/* The scratch memory (`room`) of calls that run at the same time, one room behind the other. In the cache line before
 * each room is a flag that the room is in use. */
struct simd_pool {
    char *first;
    size_t stride;
    uint32_t workers;
    bool prepared; /* false: plain C draws everything */
};

/* Returns the pool, which lies just before view->simd_memory. */
static struct simd_pool *pool_of(const struct tia_view *view)
{
    return (struct simd_pool *)(void *)((char *)view->simd_memory - SIMD_ALIGN(sizeof(struct simd_pool)));
}

static size_t stride_of(const struct tia_simd *simd, const struct simd_renderer *part)
{
    return 64 + SIMD_ALIGN(part->room(simd));
}

/* Returns the size in bytes of a view's memory: the rooms, the pool, and the part's own memory. 64 bytes are added,
 * since the caller's memory need not be aligned to 64. */
static size_t size(const struct tia_simd *simd, const struct simd_renderer *part, const struct tia_scene *scene,
                   uint32_t light_capacity, unsigned workers)
{
    size_t own = part->size(scene, light_capacity);
    uint64_t of_workers = (uint64_t)stride_of(simd, part) * (workers < WORKERS_MAX ? workers + !workers : WORKERS_MAX);
    uint64_t all = 64 + SIMD_ALIGN(sizeof(struct simd_pool)) + of_workers + own;

    return own > SIZE_MAX / 2 || all > SIZE_MAX / 2 ? SIZE_MAX : (size_t)all;
}

static const struct simd_renderer *part_of(const struct tia_view *view)
{
    const struct simd_renderer *part = simd_renderer_for(view->simd, view->renderer);

    __asm__("" : "+r"(part)); /* hides the callee from the compiler, so that no computation is moved across the call */
    return part;
}

static uint32_t *room_in_use(const struct simd_pool *pool, uint32_t i)
{
    return (uint32_t *)(void *)(pool->first + i * pool->stride);
}

static void open_pool(struct tia_view *view, void *memory, size_t bytes)
{
    const struct simd_renderer *part = simd_renderer_for(view->simd, view->renderer);
    char *start = (char *)memory + (64 - (uintptr_t)memory % 64) % 64;
    size_t least = size(view->simd, part, view->scene, view->light_capacity, 1);
    struct simd_pool pool = {.first = start, .stride = stride_of(view->simd, part), .prepared = false};
    size_t more = (bytes - least) / pool.stride;

    pool.workers = more < WORKERS_MAX ? 1 + (uint32_t)more : WORKERS_MAX;
    for (uint32_t i = 0; i < pool.workers; i++)
        *room_in_use(&pool, i) = false;
    view->simd_memory = start + pool.workers * pool.stride + SIMD_ALIGN(sizeof pool);
    *pool_of(view) = pool;
}

static void prepare(struct tia_view *view)
{
    struct simd_pool *pool = pool_of(view);
    struct environment caller;

    pool->prepared = pool->prepared && environment_take(&caller);
    if (!pool->prepared)
        return;
    part_of(view)->prepare(view);
    environment_leave(&caller);
}

static void open(struct tia_view *view, void *memory, size_t bytes)
{
    const struct simd_renderer *part = part_of(view);
    struct environment caller;

    open_pool(view, memory, bytes);
    if (!environment_take(&caller))
        return;
    pool_of(view)->prepared = true;
    if (part->open)
        part->open(view);
    environment_leave(&caller);
    prepare(view);
}

/* A call: its room and the environment of its caller. */
struct entry {
    uint32_t *in_use;
    struct environment caller;
};

static bool enter(const struct tia_view *view, struct entry *e)
{
    const struct simd_pool *pool = pool_of(view);

    for (uint32_t i = 0; pool->prepared && i < pool->workers; i++) {
        uint32_t no = false;
        e->in_use = room_in_use(pool, i);
        if (!__atomic_compare_exchange_n(e->in_use, &no, true, false, __ATOMIC_ACQUIRE, __ATOMIC_RELAXED))
            continue;
        if (environment_take(&e->caller))
            return true;
        __atomic_store_n(e->in_use, false, __ATOMIC_RELEASE);
        return false;
    }
    return false;
}

static void *room_of(const struct entry *e)
{
    return (char *)e->in_use + 64;
}

static void leave(const struct entry *e)
{
    environment_leave(&e->caller);
    __atomic_store_n(e->in_use, false, __ATOMIC_RELEASE);
}

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options)
{
    struct entry e;

    if (!enter(view, &e)) {
        tia_simd_light_plain(view, tile, surface, options);
        return;
    }
    part_of(view)->light(view, tile, surface, options, room_of(&e));
    leave(&e);
}

static void sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered)
{
    struct entry e;

    if (!enter(view, &e)) {
        view->renderer->sample(view, tile, first, end, gathered);
        return;
    }
    part_of(view)->sample(view, tile, first, end, gathered, room_of(&e));
    leave(&e);
}

static bool shade(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    struct entry e;

    if (!enter(view, &e))
        return false;
    bool shaded = part_of(view)->shade(view, hits, tile, surface, options, room_of(&e));
    leave(&e);
    return shaded;
}

const struct simd_entries tia_simd_entries = {size, open, prepare, light, sample, shade};
