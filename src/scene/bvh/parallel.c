/* parallel.c - a tree built by several threads.
 *
 * One thread repeatedly splits the largest part of the items, until there are enough parts; the passes over a part's
 * items are divided among the threads. Then each part's tree is built by one thread, in nodes reserved for the part: a
 * tree of n items has at most 2n - 1 nodes, so the first node of each part is known in advance. Finally the gaps
 * between the trees are closed. For any number of threads, the nodes are bit for bit those of tia_bvh_build_range.
 */
#include "objects.h"
#include "split.h"

#define PARTS 64      /* number of parts, enough that threads seldom wait for the last one */
#define CHUNKS 32     /* a part's items are processed in this many chunks in parallel */
#define LEAST 16384   /* a tree of fewer items does not repay waking the threads */
#define SMALLEST 2048 /* a part of at most this many items is not split further */

/* The totals of one chunk of a part's items. Chunks are stored in the memory of the nodes, none of which is in use yet:
 * CHUNKS * sizeof(struct chunk) < LEAST * sizeof(struct tia_bvh_node). */
struct chunk {
    struct tia_bvh_extent extent;
    struct tia_bvh_bins bins;
    bool stopped;
};

/* A node whose children are parts too, or the root of a tree that one thread builds. */
struct part {
    struct tia_bounds bounds; /* bounds of a divided part */
    struct bvh_range range;
    uint32_t place; /* first node of the part's tree while it is built */
    uint32_t nodes; /* number of nodes of the part's tree */
    bool divided, stopped;
};

struct crew {
    struct bvh_space *space;
    struct bvh_items all;
    struct tia_bvh_node *nodes;
    struct part parts[2 * PARTS - 1]; /* depth first: each part is followed by its first child */
    unsigned count;
    /* the part whose chunks are being processed */
    struct tia_bvh_split_items items;
    struct tia_bvh_binning binning[3];
    struct chunk *chunks;
};

/* ---- jobs of the threads ---- */

/* Returns the result of the caller's `stop`. Only one thread at a time may call it: returns false while another thread
 * does. */
static bool poll_stop(void *ctx)
{
    const struct bvh_space *space = ctx;
    bool stopped = false;

    if (space->workers->enter(space->workers->ctx)) {
        stopped = space->cancel.stop(space->cancel.ctx);
        space->workers->leave(space->workers->ctx);
    }
    return stopped;
}

/* Returns a cancellation for one thread, which counts only that thread's work. */
static struct cancel cancel_of(const struct crew *crew)
{
    return (struct cancel){crew->space->cancel.stop ? poll_stop : NULL, crew->space, 0, false};
}

static struct tia_bvh_split_items chunk_items(const struct crew *crew, unsigned index, struct cancel *cancel)
{
    struct tia_bvh_split_items items = crew->items;
    uint32_t size = (items.count + CHUNKS - 1) / CHUNKS, first = index * size;

    first = first < items.count ? first : items.count;
    items.boxes += first;
    items.items += first;
    items.count = items.count - first < size ? items.count - first : size;
    items.cancel = cancel;
    return items;
}

static void measure_chunk(void *arg, unsigned index)
{
    struct crew *crew = arg;
    struct cancel cancel = cancel_of(crew);
    struct tia_bvh_split_items items = chunk_items(crew, index, &cancel);

    tia_bvh_measure(&crew->chunks[index].extent, &items);
    crew->chunks[index].stopped = cancel.stopped;
}

static void fill_chunk(void *arg, unsigned index)
{
    struct crew *crew = arg;
    struct cancel cancel = cancel_of(crew);
    struct tia_bvh_split_items items = chunk_items(crew, index, &cancel);

    tia_bvh_fill_bins(&crew->chunks[index].bins, &items, crew->binning);
    crew->chunks[index].stopped = cancel.stopped;
}

/* Builds the tree of part number `index` among those without children. */
static void build_part(void *arg, unsigned index)
{
    struct crew *crew = arg;
    struct part *part = crew->parts;
    struct cancel cancel = cancel_of(crew);

    for (; part->divided || index > 0; part++)
        index -= !part->divided;
    part->nodes = tia_bvh_build_range(crew->nodes + part->place, &crew->all, part->range, &cancel);
    part->stopped = cancel.stopped;
}

/* ---- the upper part of the tree ---- */

static void run(struct crew *crew, void (*job)(void *arg, unsigned index), unsigned count)
{
    crew->space->workers->run(crew->space->workers->ctx, job, crew, count);
}

/* Runs the job for all chunks, in any order. Returns false if stopped. */
static bool run_chunks(struct crew *crew, void (*job)(void *arg, unsigned index))
{
    bool stopped = false;

    run(crew, job, CHUNKS);
    for (unsigned i = 0; i < CHUNKS; i++)
        stopped = stopped || crew->chunks[i].stopped;
    crew->space->cancel.stopped = crew->space->cancel.stopped || stopped;
    return !stopped;
}

/* Splits items as tia_bvh_split_items does, on several threads. */
static uint32_t split_together(struct crew *crew, struct tia_bounds *bounds, uint32_t most)
{
    struct chunk *c = crew->chunks;

    if (!run_chunks(crew, measure_chunk))
        return 0;
    for (unsigned i = 1; i < CHUNKS; i++)
        tia_bvh_join_extents(&c->extent, &c[i].extent);
    *bounds = tia_bvh_bounds(&c->extent);
    bool divides = tia_bvh_choose_bins(crew->binning, &c->extent);
    if (divides && !run_chunks(crew, fill_chunk))
        return 0;
    for (unsigned i = 1; i < CHUNKS && divides; i++)
        tia_bvh_join_bins(&c->bins, &c[i].bins);
    return tia_bvh_split_at_best(&crew->items, &c->extent, divides ? &c->bins : NULL, crew->binning, most);
}

static struct part *find_largest(struct crew *crew)
{
    struct part *largest = NULL;

    for (unsigned i = 0; i < crew->count; i++)
        if (!crew->parts[i].divided && (!largest || crew->parts[i].range.count > largest->range.count))
            largest = &crew->parts[i];
    return largest;
}

/* Divides a part. The part stays in its place, followed by its children; the first child has `left` items. */
static void divide(struct crew *crew, struct part *part, uint32_t left)
{
    struct bvh_range whole = part->range;

    for (struct part *p = &crew->parts[crew->count - 1]; p > part; p--)
        p[2] = *p;
    crew->count += 2;
    part->divided = true;
    part[1] = (struct part){.range = {whole.first, left, whole.depth + 1}, .place = part->place + 1};
    part[2] = (struct part){.range = {whole.first + left, whole.count - left, whole.depth + 1},
                            .place = part->place + 1 + (uint32_t)TREE_NODES(left)};
}

static void divide_all(struct crew *crew)
{
    struct cancel *cancel = &crew->space->cancel;

    while (crew->count < 2 * PARTS - 1) {
        struct part *part = find_largest(crew);
        if (part->range.count <= SMALLEST || cancelled(cancel, part->range.count))
            return;
        crew->items = bvh_items_of(&crew->all, part->range, cancel);
        uint32_t left = split_together(crew, &part->bounds, bvh_most_items(part->range.depth + 1));
        if (cancel->stopped)
            return;
        divide(crew, part, left);
    }
}

/* ---- moving the trees together ---- */

/* Moves a tree's nodes down to index `to`. Before the move, the index in an inner node is relative to the tree's
 * root. */
static void move_tree(struct crew *crew, const struct part *part, uint32_t to)
{
    for (uint32_t i = 0; i < part->nodes; i++) {
        struct tia_bvh_node node = crew->nodes[part->place + i];
        node.index += node.count ? 0 : to;
        crew->nodes[to + i] = node;
    }
}

/* Closes the gaps between the trees; the nodes are in depth-first order. A tree is followed by the second child of the
 * last node whose second child is still missing. Returns the number of nodes. */
static uint32_t move_together(struct crew *crew)
{
    uint32_t waiting[TIA_BVH_DEPTH_MAX + 1], to = 0;
    unsigned depth = 0;

    for (const struct part *part = crew->parts; part < crew->parts + crew->count; part++) {
        if (part > crew->parts && !part[-1].divided)
            crew->nodes[waiting[--depth]].index = to;
        if (part->divided) {
            crew->nodes[to] = (struct tia_bvh_node){.bounds = part->bounds};
            waiting[depth++] = to++;
        } else {
            move_tree(crew, part, to);
            to += part->nodes;
        }
    }
    return to;
}

uint32_t tia_bvh_build_together(struct bvh_space *space, struct tia_bvh_node *nodes, const struct bvh_items *all,
                                uint32_t count)
{
    struct crew crew = {.space = space, .all = *all, .nodes = nodes, .count = 1, .chunks = (void *)nodes};

    if (count < LEAST)
        return tia_bvh_build_range(nodes, all, (struct bvh_range){0, count, 0}, &space->cancel);
    crew.parts[0] = (struct part){.range = {0, count, 0}};
    divide_all(&crew);
    if (space->cancel.stopped)
        return 0;
    run(&crew, build_part, (crew.count + 1) / 2);
    for (unsigned i = 0; i < crew.count; i++)
        space->cancel.stopped = space->cancel.stopped || crew.parts[i].stopped;
    return space->cancel.stopped ? 0 : move_together(&crew);
}
