/* The exact techniques, called as the renderer calls them, against rays that are tested with every face in integers of
 * 128 bits: no pixel differs, whichever fallback a technique uses. Coordinates times a power of two change no sign, so
 * the same scenes are drawn in all vertex formats. */
#include <stdlib.h>

#include "math/align.h"
#include "shadow/casters.h"
#include "shadow/technique.h"
#include "shadow_worlds.h"

#define PIXELS (SIZE * SIZE)

/* ---- drawing ---- */

static const enum tia_shadows techniques[] = {TIA_SHADOWS_RAYS, TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL};
#define TECHNIQUES (sizeof techniques / sizeof *techniques)

struct drawing {
    struct tia_scene scene;
    struct tia_shadow_view view;
    struct tia_shadow_tile tile;
    uint64_t lit[PIXELS];
    void *memory, *own;
};

static void open_drawing(struct drawing *d, const struct world *w)
{
    struct tia_tile all = {0, 0, SIZE, SIZE};
    unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT;
    size_t size = tia_raster_size(all, buffers, w->flat.face_count);

    d->memory = malloc(size);
    d->view = (struct tia_shadow_view){
        .scene = &d->scene, .flat = w->flat, .sample_count = 1, .own_size = 4096 + tia_casters_size(FACES)};
    d->view.own = d->own = malloc((size_t)d->view.own_size);
    d->view.samples[0] = w->light;
    CHECK(!tia_raster_init(&d->tile.target, d->memory, size, &d->view.flat.grid, all, buffers, w->flat.face_count));
    CHECK(!tia_shadow_faces(&d->tile.target, &d->view.flat, &never));
    d->view.flat.planes = d->tile.target.planes;
    d->tile.lit = d->lit;
}

static void draw(struct drawing *d, enum tia_shadows shadows)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(shadows);

    d->scene.shadows = shadows;
    memset(d->lit, 0, sizeof d->lit);
    CHECK(!technique->prepare(&d->view, &never));
    CHECK(!technique->set_lights(&d->view, &never));
    technique->light(&d->view, &d->tile, 0, &never);
}

static void close_drawing(struct drawing *d)
{
    free(d->memory);
    free(d->own);
}

/* ---- the same scene, in other units ---- */

static void scale_vertex(struct tia_raster_vertex *v, bool flat, int64_t by)
{
    *v = (struct tia_raster_vertex){v->x * by, v->y * by, v->w * by, flat ? v->h * by : v->h};
}

static void scale_world(struct world *w, int bits)
{
    bool flat = w->flat.eye.projection == TIA_ORTHOGRAPHIC;

    for (uint32_t i = 0; i < w->flat.point_count; i++)
        scale_vertex(&points[i], flat, INT64_C(1) << bits);
    for (uint32_t i = 0; i < w->flat.object_count; i++)
        for (int k = 0; k < 3; k++) {
            objects[i].low[k] *= INT64_C(1) << bits;
            objects[i].high[k] *= INT64_C(1) << bits;
        }
    scale_vertex(&w->light, flat, INT64_C(1) << bits);
    w->flat.grid.fraction += bits;
    w->flat.grid.scale += flat ? 0 : bits;
}

/* ---- comparisons ---- */

struct tally {
    uint32_t seen, dark, wrong[TECHNIQUES];
};

static void find_answers(const struct world *w, bool lit[PIXELS], struct tally *t)
{
    for (int at = 0; at < PIXELS; at++) {
        uint32_t face = find_seen(w, at % SIZE, at / SIZE);
        lit[at] = face != TIA_NO_FACE && is_lit(w, face, at % SIZE, at / SIZE);
        t->seen += face != TIA_NO_FACE;
        t->dark += face != TIA_NO_FACE && !lit[at];
    }
}

static void compare(const struct world *w, const bool lit[PIXELS], struct tally *t)
{
    static struct drawing d;

    open_drawing(&d, w);
    for (size_t i = 0; i < TECHNIQUES; i++) {
        draw(&d, techniques[i]);
        for (int at = 0; at < PIXELS; at++)
            t->wrong[i] += d.lit[at] != lit[at];
    }
    close_drawing(&d);
}

static void check_worlds(enum tia_projection projection, enum contents contents, bool grid)
{
    int32_t step = grid ? projection == TIA_ORTHOGRAPHIC ? 128 : 96 : 1, range = grid ? 4 : 500;
    static bool lit[PIXELS];
    struct tally t = {0};
    struct world w;

    for (unsigned round = 0; round < check_count(100); round++) {
        begin(&w, projection);
        make(&w, contents, range, step);
        end(&w, range, step);
        find_answers(&w, lit, &t);
        compare(&w, lit, &t);
        scale_world(&w, 15);
        compare(&w, lit, &t);
        if (projection == TIA_ORTHOGRAPHIC)
            continue;
        scale_world(&w, 14);
        compare(&w, lit, &t);
    }
    for (size_t i = 0; i < TECHNIQUES; i++)
        CHECK_MSG(!t.wrong[i], "%s: %u pixels differ", tia_shadows_name(techniques[i]), t.wrong[i]);
    CHECK_MSG(t.dark > t.seen / 8 && t.dark < t.seen - check_count(300), "%u of %u are dark", t.dark, t.seen);
}

static void check_both(enum contents contents, bool grid)
{
    check_worlds(TIA_PERSPECTIVE, contents, grid);
    check_worlds(TIA_ORTHOGRAPHIC, contents, grid);
}

TEST(soups)
{
    check_both(SOUP, false);
    check_both(SOUP, true);
}

TEST(solids)
{
    check_both(SOLIDS, false);
    check_both(SOLIDS, true);
    check_both(CROOKED, false);
}

TEST(planes_and_all)
{
    check_both(MIXED, false);
    check_both(MIXED, true);
}

TEST(far_planes_and_lights)
{
    check_both(SMALL, false);
}

/* ---- stopping ---- */

static bool stop(void *ctx)
{
    *(unsigned *)ctx += 1;
    return true;
}

/* Returns a cancellation that is polled at once and stops; `asked` counts the calls. */
static struct cancel stopper(unsigned *asked)
{
    *asked = 0;
    return (struct cancel){.stop = stop, .ctx = asked, .work = CANCEL_INTERVAL};
}

/* After the stop, no loop over the faces continues or calls `stop` again. */
TEST(passes_over_faces_stop)
{
    static struct drawing d;
    struct world w;
    unsigned asked;
    uint32_t count;

    begin(&w, TIA_ORTHOGRAPHIC);
    make(&w, SOLIDS, 500, 1);
    end(&w, 500, 1);
    open_drawing(&d, &w);
    const struct tia_shadow_light light = {&w.light, NULL};
    struct cancel cancel = stopper(&asked);
    CHECK_EQ(tia_shadow_faces(&d.tile.target, &d.view.flat, &cancel), TIA_STOPPED);
    cancel = stopper(&asked);
    CHECK_EQ(tia_shadow_zfail(&d.tile.target, &d.view.flat, light, &cancel), TIA_STOPPED);
    cancel = stopper(&asked);
    CHECK_EQ(tia_shadow_zpass(&d.tile.target, &d.view.flat, light, &cancel), TIA_STOPPED);
    for (int i = 0; i < PIXELS; i++)
        CHECK_EQ(d.tile.target.count[i], 0);
    cancel = stopper(&asked);
    (void)tia_shadow_count_eye(&d.view.flat, light, &count, &cancel);
    CHECK(asked == 1 && count == 0);
    cancel = stopper(&asked);
    (void)tia_shadow_count_far(&d.view.flat, light, &count, &cancel);
    CHECK(asked == 1 && count == 0);
    cancel = stopper(&asked);
    CHECK_EQ(tia_shadow_keep_roles(d.own, &d.view.flat, &w.light, &cancel), TIA_STOPPED);
    CHECK_EQ(asked, 1);
    close_drawing(&d);
}

TEST(techniques_stop)
{
    static struct drawing d;
    struct world w;
    unsigned asked;

    begin(&w, TIA_PERSPECTIVE);
    make(&w, SOLIDS, 500, 1);
    end(&w, 500, 1);
    open_drawing(&d, &w);
    for (size_t i = 0; i < TECHNIQUES; i++) {
        const struct tia_shadow_technique *technique = tia_shadow_technique(techniques[i]);
        draw(&d, techniques[i]);
        memset(d.lit, 0, sizeof d.lit);
        struct cancel cancel = stopper(&asked);
        technique->light(&d.view, &d.tile, 0, &cancel);
        CHECK_EQ(asked, 1);
        cancel = stopper(&asked);
        int prepared = technique->prepare(&d.view, &cancel);
        CHECK_EQ(prepared ? prepared : technique->set_lights(&d.view, &cancel), TIA_STOPPED);
        CHECK_EQ(asked, 1);
    }
    close_drawing(&d);
}

int main(void)
{
    RUN(passes_over_faces_stop);
    RUN(techniques_stop);
    RUN(soups);
    RUN(solids);
    RUN(planes_and_all);
    RUN(far_planes_and_lights);
    return check_status();
}
