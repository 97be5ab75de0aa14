/* Shadow volumes against exact rays: what a pixel sees, and whether a face lies between that and the light, tried with
 * every face in integers of 128 bits. Corners are small enough for those, and many lie on pixel centres, in one plane,
 * in the plane of the light or the eye. Rays that meet an edge are moved to the right by less than anything, then down.
 */
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "shadow/occluder.h"
#include "shadow_oracle.h"

#define FACES 64
#define POINTS (3 * FACES)

static int32_t below(int32_t n)
{
    return (int32_t)(random_bits() % (uint64_t)n);
}

/* ---- scenes ---- */

static struct tia_flat_face faces[FACES];
static struct tia_flat_object objects[FACES];
static struct tia_raster_vertex points[POINTS];
static uint32_t across[TIA_SIDES * FACES];

/* Points and directions as they are in perspective; in orthographic views h is what w was. */
static struct tia_raster_vertex vertex(const struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        return (struct tia_raster_vertex){x, y, point ? INT64_C(1) << w->flat.lattice.fraction : 0, z};
    return (struct tia_raster_vertex){x, y, z, point};
}

static void begin(struct world *w, enum tia_projection projection)
{
    *w = (struct world){.flat = {.objects = objects, .faces = faces, .across = across, .points = points}};
    w->flat.eye.projection = projection;
    CHECK(!tia_lattice_init(&w->flat.lattice, projection, SIZE, SIZE, 1, 0, projection == TIA_ORTHOGRAPHIC ? 20 : 5));
}

/* Whole multiples of step, of a scene that reaches `range` to all sides and from a bit behind the eye. */
static void any_place(const struct world *w, int32_t range, int32_t step, int64_t at[3])
{
    for (int k = 0; k < 3; k++)
        at[k] = (int64_t)(below(2 * range + 1) - (k == 2 ? range / 3 : range)) * step;
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        at[2] = -at[2];
}

static void add_point(struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    points[w->flat.point_count++] = vertex(w, x, y, z, point);
}

/* The points were added just before. */
static void add_object(struct world *w, const uint8_t (*corners)[4], uint32_t count, uint32_t point_count)
{
    struct tia_flat_scene *f = &w->flat;
    struct tia_flat_object *o = &objects[f->object_count++];
    uint32_t first = f->point_count - point_count;

    *o = (struct tia_flat_object){.first_face = f->face_count, .face_count = count};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < TIA_SIDES; k++)
            faces[f->face_count + i].corner[k] =
                k == 3 && !corners[i][3] ? TIA_NO_CORNER : first + corners[i][k]; /* the last is never point 0 */
    f->face_count += count;
    for (int k = 0; k < 3; k++) {
        o->low[k] = INT64_MAX;
        o->high[k] = INT64_MIN;
    }
    for (uint32_t i = first; i < f->point_count; i++) {
        int64_t p[3];
        tia_flat_affine(f, &points[i], p);
        for (int k = 0; k < 3; k++) {
            o->low[k] = p[k] < o->low[k] ? p[k] : o->low[k];
            o->high[k] = p[k] > o->high[k] ? p[k] : o->high[k];
        }
    }
}

static void end(struct world *w, int32_t range, int32_t step)
{
    void *room = malloc(tia_edges_room(w->flat.face_count));
    int64_t at[3];

    (void)tia_edges_join(across, faces, w->flat.face_count, room);
    free(room);
    for (uint32_t i = 0; i < w->flat.object_count; i++) {
        struct tia_flat_object *o = &objects[i];
        o->closed = true;
        for (uint32_t e = TIA_SIDES * o->first_face; e < TIA_SIDES * (o->first_face + o->face_count); e++)
            o->closed = o->closed && (e % TIA_SIDES == 3 || across[e] != TIA_NO_EDGE);
    }
    any_place(w, range, step, at);
    bool point = below(4) != 0;
    w->light = vertex(w, at[0], at[1], at[2] + (!point && !at[0] && !at[1] && !at[2]), point);
}

static void make_soup(struct world *w, uint32_t count, int32_t range, int32_t step)
{
    static const uint8_t triangle[1][4] = {{0, 1, 2}};

    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            int64_t at[3];
            any_place(w, range, step, at);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, triangle, 1, 3);
    }
}

/* Boxes, or what becomes of them when all corners move. */
static void make_solids(struct world *w, uint32_t count, int32_t range, int32_t step, int32_t jitter)
{
    static const uint8_t box[12][4] = {{0, 6, 4}, {0, 2, 6}, {1, 5, 7}, {1, 7, 3}, {0, 5, 1}, {0, 4, 5},
                                       {2, 7, 6}, {2, 3, 7}, {0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}};

    for (uint32_t i = 0; i < count; i++) {
        int64_t low[3], size[3];
        any_place(w, range, step, low);
        any_place(w, range, step, size);
        for (int k = 0; k < 8; k++) {
            int64_t at[3];
            for (int c = 0; c < 3; c++)
                at[c] = low[c] + (k >> c & 1 ? llabs(size[c]) + step : 0) + below(jitter + 1);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, box, 12, 8);
    }
}

/* A plane in two halves, all of it; it goes through a point between the others. */
static void make_plane(struct world *w, int32_t range, int32_t step)
{
    static const uint8_t halves[2][4] = {{0, 1, 2, 3}, {0, 3, 4, 1}};
    int64_t at[3], a[3], b[3];

    any_place(w, range, step, at);
    any_place(w, range, step, a);
    any_place(w, range, step, b);
    add_point(w, at[0], at[1], at[2], true);
    add_point(w, a[0], a[1], a[2], false);
    add_point(w, b[0], b[1], b[2], false);
    add_point(w, -a[0], -a[1], -a[2], false);
    add_point(w, -b[0], -b[1], -b[2], false);
    add_object(w, halves, 2, 5);
}

/* ---- what is compared ---- */

struct tally {
    uint32_t worlds, pixels, seen, dark, faces_wrong, wrong[2], rays_wrong, unsure[2];
};

/* A technique: z-fail or z-pass, and how many volumes hold where rays end or start. */
struct technique {
    struct tia_raster_target target;
    void *memory;
    uint32_t count;
    bool sure;
};

static bool is_lit_by(const struct technique *t, size_t at)
{
    return (uint8_t)(t->target.stencil[at] + t->count) == 0;
}

/* By rays to a light that the face is turned to. */
static bool is_hidden(const struct world *w, const struct tia_raster_plane *planes, uint32_t face, int i, int j)
{
    struct tia_flat_scene flat = w->flat;
    struct tia_seen_face of;
    struct tia_seen seen;
    struct tia_occluder occluder;

    flat.planes = (struct tia_raster_plane *)planes;
    tia_seen_face_init(&of, &flat, face);
    tia_seen_init(&seen, &of, i, j);
    for (uint32_t f = 0; f < flat.face_count; f++)
        if (tia_occluder_init(&occluder, &flat, &w->light, f) && tia_occluder_hides(&occluder, &seen))
            return true;
    return false;
}

static void compare_pixel(const struct world *w, const struct technique how[2], int i, int j, struct tally *t)
{
    size_t at = (size_t)j * SIZE + (size_t)i;
    uint32_t face = find_seen(w, i, j);

    t->pixels++;
    t->faces_wrong += how[0].target.face[at] != face;
    if (face == TIA_NO_FACE)
        return;
    const struct tia_flat_face *f = &w->flat.faces[face];
    bool turned = tia_flat_side(&w->flat, f, &w->light) == tia_flat_side_of_eye(&w->flat, f);
    bool lit = is_lit(w, face, i, j);
    t->seen++;
    t->dark += !lit;
    for (int k = 0; k < 2; k++)
        t->wrong[k] += how[k].sure && (turned && is_lit_by(&how[k], at)) != lit;
    t->rays_wrong += (turned && !is_hidden(w, how[0].target.planes, face, i, j)) != lit;
}

static void prepare(struct technique *how, const struct world *w)
{
    struct tia_tile all = {0, 0, SIZE, SIZE};
    unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL;
    size_t size = tia_raster_size(all, buffers, w->flat.face_count);

    how->memory = malloc(size);
    CHECK(!tia_raster_init(&how->target, how->memory, size, &w->flat.lattice, all, buffers, w->flat.face_count));
    CHECK(!tia_shadow_faces(&how->target, &w->flat));
}

static void compare(const struct world *w, struct tally *t)
{
    struct technique how[2];

    for (int k = 0; k < 2; k++)
        prepare(&how[k], w);
    CHECK(!tia_shadow_zfail(&how[0].target, &w->flat, &w->light));
    CHECK(!tia_shadow_zpass(&how[1].target, &w->flat, &w->light));
    how[0].sure = tia_shadow_count_far(&w->flat, &w->light, &how[0].count);
    how[1].sure = tia_shadow_count_eye(&w->flat, &w->light, &how[1].count);
    t->worlds++;
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++)
            compare_pixel(w, how, i, j, t);
    for (int k = 0; k < 2; k++) {
        t->unsure[k] += !how[k].sure;
        free(how[k].memory);
    }
}

static void check_tally(const struct tally *t, bool ties, bool flat)
{
    CHECK_EQ(t->faces_wrong, 0);
    CHECK_EQ(t->wrong[0], 0);
    CHECK_EQ(t->wrong[1], 0);
    CHECK_EQ(t->rays_wrong, 0);
    CHECK_MSG(t->seen > t->pixels / 20 && t->dark > t->seen / 8 && t->dark < t->seen - t->seen / 20,
              "%u of %u see a face, %u are dark", t->seen, t->pixels, t->dark);
    for (int k = 0; k < 2; k++)
        CHECK_MSG(ties && (k || flat) ? t->unsure[k] > 4 && t->unsure[k] < t->worlds / 2 : !t->unsure[k],
                  "%u of %u unsure", t->unsure[k], t->worlds);
}

enum contents { SOUP, SOLIDS, CROOKED, MIXED };

static void make(struct world *w, enum contents contents, int32_t range, int32_t step)
{
    if (contents == SOUP || contents == MIXED)
        make_soup(w, 1 + (uint32_t)below(contents == MIXED ? 5 : 13), range, step);
    if (contents != SOUP)
        make_solids(w, 2 + (uint32_t)below(3), range * 2 / 3, step, contents == CROOKED ? range / 5 : 0);
    if (contents == MIXED)
        make_plane(w, range, step);
}

static void check_worlds(enum tia_projection projection, enum contents contents, bool lattice)
{
    int32_t step = lattice ? projection == TIA_ORTHOGRAPHIC ? 128 : 96 : 1, range = lattice ? 4 : 500;
    struct tally t = {0};
    struct world w;

    for (int round = 0; round < 200; round++) {
        begin(&w, projection);
        make(&w, contents, range, step);
        end(&w, range, step);
        compare(&w, &t);
    }
    check_tally(&t, lattice, projection == TIA_ORTHOGRAPHIC);
}

TEST(soups)
{
    check_worlds(TIA_PERSPECTIVE, SOUP, false);
    check_worlds(TIA_ORTHOGRAPHIC, SOUP, false);
}

TEST(soups_with_ties)
{
    check_worlds(TIA_PERSPECTIVE, SOUP, true);
    check_worlds(TIA_ORTHOGRAPHIC, SOUP, true);
}

TEST(solids)
{
    check_worlds(TIA_PERSPECTIVE, SOLIDS, false);
    check_worlds(TIA_ORTHOGRAPHIC, SOLIDS, false);
    check_worlds(TIA_PERSPECTIVE, CROOKED, false);
    check_worlds(TIA_ORTHOGRAPHIC, CROOKED, false);
}

TEST(solids_with_ties)
{
    check_worlds(TIA_PERSPECTIVE, SOLIDS, true);
    check_worlds(TIA_ORTHOGRAPHIC, SOLIDS, true);
}

TEST(planes_and_all)
{
    check_worlds(TIA_PERSPECTIVE, MIXED, false);
    check_worlds(TIA_ORTHOGRAPHIC, MIXED, false);
    check_worlds(TIA_PERSPECTIVE, MIXED, true);
    check_worlds(TIA_ORTHOGRAPHIC, MIXED, true);
}

int main(void)
{
    RUN(soups);
    RUN(soups_with_ties);
    RUN(solids);
    RUN(solids_with_ties);
    RUN(planes_and_all);
    return check_status();
}
