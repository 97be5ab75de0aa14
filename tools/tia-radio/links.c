#include "links.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

enum { CHUNK = 1024 }; /* number of rays of a job */

const char *method_name(enum method method)
{
    static const char *const names[METHODS] = {"image", "sbr", "hybrid"};

    return names[method];
}

static bool add_path(void *ctx, const struct tia_radio_path *path)
{
    struct path_list *list = ctx;

    if (list->count == list->room) {
        unsigned room = list->room > 0 ? 2 * list->room : 64;
        struct tia_radio_path *more = realloc(list->paths, room * sizeof *more);
        list->exhausted = !more;
        if (!more)
            return false;
        list->paths = more;
        list->room = room;
    }
    list->paths[list->count++] = *path;
    return true;
}

static int compare_paths(const void *left, const void *right)
{
    const struct tia_radio_path *a = left, *b = right;

    if (a->length != b->length)
        return a->length > b->length ? 1 : -1;
    if (a->order != b->order)
        return a->order > b->order ? 1 : -1;
    return memcmp(a->face, b->face, sizeof a->face) > 0 ? 1 : -1;
}

void links_sort(struct path_list *list)
{
    if (list->count > 0)
        qsort(list->paths, list->count, sizeof *list->paths, compare_paths);
}

bool links_try(const struct search *search, struct tia_radio_room *room, const struct sequences *sequences,
               struct tia_vec3 from, struct tia_vec3 to, struct path_list *list)
{
    const struct tia_radio_link link = {from, to, search->order, search->walls, add_path, list};

    if (!sequences)
        (void)tia_radio_images(search->radio, room, &link);
    for (size_t i = 0; sequences && i < sequences->count && !list->exhausted; i++)
        (void)tia_radio_try(search->radio, room, &link, sequences->array[i].plane, sequences->array[i].order);
    return !list->exhausted;
}

/* ---- rays ---- */

/* A ray's result. Of results with equal sequences and paths, the one of the lowest ray number is used, so that it does
 * not depend on the threads. */
struct find {
    struct sequence sequence;
    struct tia_radio_path path;
    int64_t miss;
    uint32_t ray;
};

struct finds {
    struct find *array;
    size_t count, room;
    bool exhausted;
};

struct shooting {
    const struct search *search;
    struct tia_radio_link link;
    bool everywhere;
    struct finds *finds; /* finds of each job */
    atomic_bool exhausted;
};

struct job {
    struct finds *finds;
    uint32_t ray;
};

static int compare_sequences(const struct sequence *a, const struct sequence *b)
{
    if (a->order != b->order)
        return a->order > b->order ? 1 : -1;
    for (uint32_t i = 0; i < a->order; i++)
        if (a->plane[i] != b->plane[i])
            return a->plane[i] > b->plane[i] ? 1 : -1;
    return 0;
}

/* Orders finds: equal sequences are adjacent. Of these, those with the fewest walls come first, then the nearest. */
static int compare_finds(const void *left, const void *right)
{
    const struct find *a = left, *b = right;
    int order = compare_sequences(&a->sequence, &b->sequence);

    if (order != 0)
        return order;
    if (a->path.wall_count != b->path.wall_count)
        return a->path.wall_count > b->path.wall_count ? 1 : -1;
    if (a->miss != b->miss)
        return a->miss > b->miss ? 1 : -1;
    return (a->ray > b->ray) - (a->ray < b->ray);
}

static void keep_first(struct finds *finds)
{
    size_t kept = 0;

    if (finds->count > 0)
        qsort(finds->array, finds->count, sizeof *finds->array, compare_finds);
    for (size_t i = 0; i < finds->count; i++)
        if (kept == 0 || compare_sequences(&finds->array[kept - 1].sequence, &finds->array[i].sequence) != 0)
            finds->array[kept++] = finds->array[i];
    finds->count = kept;
}

static bool add_find(struct finds *finds, const struct find *find)
{
    if (finds->count == finds->room)
        keep_first(finds);
    if (2 * finds->count >= finds->room) {
        size_t room = finds->room > 0 ? 2 * finds->room : 64;
        struct find *more = realloc(finds->array, room * sizeof *more);
        finds->exhausted = !more;
        if (!more)
            return false;
        finds->array = more;
        finds->room = room;
    }
    finds->array[finds->count++] = *find;
    return true;
}

static bool add_ray(void *ctx, const struct tia_radio_ray *ray)
{
    const struct job *job = ctx;
    struct find find = {.path = ray->path, .miss = ray->miss, .ray = job->ray};

    find.sequence.order = ray->path.order;
    for (uint32_t i = 0; i < ray->path.order; i++)
        find.sequence.plane[i] = ray->plane[i];
    return add_find(job->finds, &find);
}

static void shoot_chunk(void *arg, unsigned index)
{
    struct shooting *s = arg;
    struct tia_radio_room *room = malloc(tia_radio_room_size());
    struct job job = {&s->finds[index], index * CHUNK};
    uint32_t end = tia_radio_directions(s->search->density);

    end = end - job.ray > CHUNK ? job.ray + CHUNK : end;
    for (; room && job.ray < end && !job.finds->exhausted; job.ray++)
        (void)tia_radio_shoot(s->search->radio, room, &s->link, s->search->density, job.ray, s->everywhere, add_ray,
                              &job);
    keep_first(job.finds);
    if (!room || job.finds->exhausted)
        atomic_store(&s->exhausted, true);
    free(room);
}

/* Shoots all rays in parallel. *all receives each sequence once. Returns false if there is no memory. */
static bool shoot(const struct search *search, struct tia_vec3 from, struct tia_vec3 to, bool everywhere,
                  struct finds *all)
{
    unsigned jobs = (tia_radio_directions(search->density) + CHUNK - 1) / CHUNK;
    struct shooting s = {.search = search,
                         .link = {from, to, search->order, search->walls, NULL, NULL},
                         .everywhere = everywhere,
                         .finds = calloc(jobs, sizeof *s.finds)};

    *all = (struct finds){NULL, 0, 0, false};
    if (!s.finds)
        return false;
    threads_run(search->pool, shoot_chunk, &s, jobs);
    for (unsigned i = 0; i < jobs; i++) {
        for (size_t k = 0; k < s.finds[i].count && !all->exhausted; k++)
            (void)add_find(all, &s.finds[i].array[k]);
        free(s.finds[i].array);
    }
    keep_first(all);
    free(s.finds);
    return !all->exhausted && !atomic_load(&s.exhausted);
}

static bool take_sequences(const struct finds *finds, struct sequences *out)
{
    *out = (struct sequences){.array = malloc((finds->count + 1) * sizeof *out->array)};
    if (!out->array)
        return false;
    out->array[out->count++] = (struct sequence){.order = 0};
    for (size_t i = 0; i < finds->count; i++)
        if (finds->array[i].sequence.order > 0)
            out->array[out->count++] = finds->array[i].sequence;
    return true;
}

bool sequences_shoot(const struct search *search, struct tia_vec3 from, struct sequences *sequences)
{
    struct finds finds;
    bool fine = shoot(search, from, from, true, &finds) && take_sequences(&finds, sequences);

    free(finds.array);
    return fine;
}

/* ---- a link ---- */

static bool find_by_rays(const struct search *search, struct tia_radio_room *room, struct tia_vec3 from,
                         struct tia_vec3 to, struct path_list *list)
{
    struct finds finds;
    struct sequences sequences = {.array = NULL};
    bool fine = shoot(search, from, to, false, &finds);

    for (size_t i = 0; i < finds.count && fine && search->method == METHOD_SBR; i++)
        fine = add_path(list, &finds.array[i].path);
    if (fine && search->method == METHOD_HYBRID)
        fine = take_sequences(&finds, &sequences) && links_try(search, room, &sequences, from, to, list);
    free(sequences.array);
    free(finds.array);
    return fine;
}

bool links_find(const struct search *search, struct tia_vec3 from, struct tia_vec3 to, struct path_list *list)
{
    struct tia_radio_room *room = malloc(tia_radio_room_size());

    *list = (struct path_list){.paths = NULL};
    bool fine = room && (search->method == METHOD_IMAGE ? links_try(search, room, NULL, from, to, list)
                                                        : find_by_rays(search, room, from, to, list));
    free(room);
    if (fine)
        links_sort(list);
    return fine;
}
