/* Shadow volumes against exact rays from a pixel's visible point to the light, tested with every face in integers of
 * 128 bits. Corners are small enough for these integers, and many lie on pixel centres, in one plane, or in the plane
 * of the light or the eye. Rays that meet an edge are moved to the right by an infinitesimal distance, then down. */
#include <stdlib.h>

#include "shadow/occluder.h"
#include "shadow_worlds.h"

/* ---- comparisons ---- */

struct tally {
    uint32_t worlds, pixels, seen, dark, faces_wrong, wrong[2], rays_wrong, unsure[2], counts_wrong;
};

/* State of z-fail or z-pass: the target, and the number of volumes that contain the far ends (z-fail) or the starts
 * (z-pass) of all rays from the eye; not sure: the number is undecided. */
struct technique {
    struct tia_raster_target target;
    void *memory;
    uint32_t count;
    bool sure;
};

/* Returns the number of volumes that contain the point at a pixel. */
static uint32_t count_at(const struct technique *t, size_t at)
{
    return t->target.count[at] + t->count;
}

/* True if tia_occluder_hides finds a face that hides the light from the point of `face` at pixel (i, j); `face` is
 * turned to the light. */
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
        t->wrong[k] += how[k].sure && (turned && count_at(&how[k], at) == 0) != lit;
    t->counts_wrong += how[0].sure && how[1].sure && count_at(&how[0], at) != count_at(&how[1], at);
    t->rays_wrong += (turned && !is_hidden(w, how[0].target.planes, face, i, j)) != lit;
}

static void prepare(struct technique *how, const struct world *w)
{
    struct tia_tile all = {0, 0, SIZE, SIZE};
    unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT;
    size_t size = tia_raster_size(all, buffers, w->flat.face_count);

    how->memory = malloc(size);
    CHECK(!tia_raster_init(&how->target, how->memory, size, &w->flat.grid, all, buffers, w->flat.face_count));
    CHECK(!tia_shadow_faces(&how->target, &w->flat, &never));
}

static void compare(const struct world *w, struct tally *t)
{
    static uint8_t roles[FACES];
    const struct tia_shadow_light kept = {&w->light, roles}, light[2] = {kept, {&w->light, NULL}};
    unsigned by = t->worlds++ % 2; /* z-fail by roles, z-pass without, or the reverse */
    struct technique how[2];

    for (int k = 0; k < 2; k++)
        prepare(&how[k], w);
    CHECK(!tia_shadow_keep_roles(roles, &w->flat, &w->light, &never));
    CHECK(!tia_shadow_zfail(&how[0].target, &w->flat, light[by], &never));
    CHECK(!tia_shadow_zpass(&how[1].target, &w->flat, light[!by], &never));
    how[0].sure = tia_shadow_count_far(&w->flat, light[by], &how[0].count, &never);
    how[1].sure = tia_shadow_count_eye(&w->flat, light[!by], &how[1].count, &never);
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
    CHECK_EQ(t->counts_wrong, 0);
    CHECK_MSG(t->seen > t->pixels / 20 && t->dark > t->seen / 8 && t->dark < t->seen - t->seen / 20,
              "%u of %u see a face, %u are dark", t->seen, t->pixels, t->dark);
    for (int k = 0; k < 2; k++)
        CHECK_MSG(ties && (k || flat) ? t->unsure[k] >= t->worlds / 40 && t->unsure[k] < t->worlds / 2 : !t->unsure[k],
                  "%u of %u unsure", t->unsure[k], t->worlds);
}

static void check_worlds(enum tia_projection projection, enum contents contents, bool grid)
{
    int32_t step = grid ? projection == TIA_ORTHOGRAPHIC ? 128 : 96 : 1, range = grid ? 4 : 500;
    unsigned rounds = contents == MIXED ? check_count(200) : 200;
    struct tally t = {0};
    struct world w;

    for (unsigned round = 0; round < rounds; round++) {
        begin(&w, projection);
        make(&w, contents, range, step);
        end(&w, range, step);
        compare(&w, &t);
    }
    check_tally(&t, grid, projection == TIA_ORTHOGRAPHIC);
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
    check_worlds(TIA_PERSPECTIVE, JOINED, false);
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
    RUN_LONG(solids);
    RUN_LONG(solids_with_ties);
    RUN(planes_and_all);
    return check_status();
}
