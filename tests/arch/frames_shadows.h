/* frames_shadows.h - the pinned frames of the techniques for shadows, and of the rasteriser alone. */
#ifndef TESTS_ARCH_FRAMES_SHADOWS_H
#define TESTS_ARCH_FRAMES_SHADOWS_H

#include <tia/raster.h>

#include "common/corpus/corpus_flat.h"
#include "common/corpus/corpus_rays.h"
#include "common/corpus/dice.h"
#include "frames_canvas.h"

#define FRAMES_FLAT 6
#define FRAMES_CURVED 2

/* ---- techniques ---- */

/* Draws the scene in tiles that do not divide it. */
static inline void frames_scene(struct frames_canvas *c, const struct tia_scene *scene, unsigned width, unsigned height,
                                bool dither, const char *name)
{
    if (!frames_open(c, scene, width, height))
        abort();
    frames_draw(c, 17, 11, true, dither);
    frames_tell(c, name);
    frames_close(c);
}

/* Draws a scene of flat faces by each exact technique, all with the same shadows. */
static inline void frames_flat(struct frames_canvas *c, unsigned index)
{
    static struct corpus_rays scene;
    static const enum tia_shadows techniques[] = {TIA_SHADOWS_RAYS, TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL,
                                                  TIA_SHADOWS_MAP_EXACT};
    const unsigned width = 40 + index, height = 30 - index;
    char name[60];

    corpus_random_flat(&scene, 565, index);
    for (size_t i = 0; i < sizeof techniques / sizeof techniques[0]; i++) {
        scene.scene.shadows = techniques[i];
        (void)snprintf(name, sizeof name, "flat-%u-%ux%u-%s", index, width, height, tia_shadows_name(techniques[i]));
        frames_scene(c, &scene.scene, width, height, index % 4 == 3, name);
    }
}

/* Draws a shadow map with a filter and a bias, in a scene where each choice gives a different picture. */
static inline void frames_map(struct frames_canvas *c, enum tia_filter filter, enum tia_bias bias, tia_q16 amount)
{
    static struct corpus_rays scene;
    const unsigned index = filter == TIA_FILTER_NONE ? 9 : 6 + (unsigned)filter;
    const uint16_t size = filter % 2 ? 64 : 128;
    char name[60];

    corpus_random_flat(&scene, 565, index);
    scene.scene.shadows = TIA_SHADOWS_MAP;
    scene.scene.shadow_map = (struct tia_shadow_map){.size = size, .bias = bias, .amount = amount, .filter = filter};
    (void)snprintf(name, sizeof name, "flat-%u-48x36-map-%u-%s-%s", index, size, tia_bias_name(bias),
                   tia_filter_name(filter));
    frames_scene(c, &scene.scene, 48, 36, false, name);
}

static inline void frames_maps(struct frames_canvas *c)
{
    for (unsigned i = TIA_FILTER_NONE; i <= TIA_FILTER_PCSS; i++)
        frames_map(c, (enum tia_filter)i, i % 2 ? TIA_BIAS_SLOPE : TIA_BIAS_PLANE, TIA_Q16(1));
    for (unsigned i = TIA_BIAS_NONE; i <= TIA_BIAS_NORMAL; i++)
        if (i != TIA_BIAS_SLOPE)
            frames_map(c, TIA_FILTER_NONE, (enum tia_bias)i, i == TIA_BIAS_CONSTANT ? TIA_Q16(0.05) : TIA_Q16(1.5));
}

/* Draws curved shapes, as such and as facets. */
static inline void frames_curved(struct frames_canvas *c, unsigned index)
{
    static struct corpus_rays scene;
    static const enum tia_shadows techniques[] = {TIA_SHADOWS_ZFAIL, TIA_SHADOWS_MAP_EXACT};
    char name[60];

    corpus_random_opaque(&scene, 565, 20 + index);
    for (unsigned i = 0; i < 4; i++) {
        enum tia_shadows technique = techniques[i % 2];
        scene.scene.shadows = technique;
        scene.scene.tessellated = i < 2 ? 0 : TIA_Q16(0.02);
        (void)snprintf(name, sizeof name, "curved-%u-40x30-%s%s", index, tia_shadows_name(technique),
                       i < 2 ? "" : "-tessellated");
        frames_scene(c, &scene.scene, 40, 30, false, name);
    }
}

/* Draws an orthographic view by each technique, and several samples a pixel. */
static inline void frames_cameras(struct frames_canvas *c)
{
    static struct corpus_rays scene;
    static const enum tia_shadows techniques[] = {TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL, TIA_SHADOWS_MAP,
                                                  TIA_SHADOWS_MAP_EXACT};
    char name[60];

    for (unsigned i = 0; i < sizeof techniques / sizeof techniques[0]; i++) {
        corpus_random_flat(&scene, 565, 9);
        scene.scene.shadows = techniques[i];
        scene.scene.camera.projection = TIA_ORTHOGRAPHIC;
        scene.scene.camera.window = (struct tia_window){0, 0, TIA_Q16(-4), TIA_Q16(4), TIA_Q16_ONE};
        (void)snprintf(name, sizeof name, "orthographic-44x33-%s", tia_shadows_name(techniques[i]));
        frames_scene(c, &scene.scene, 44, 33, false, name);
    }
    corpus_random_flat(&scene, 565, 1);
    scene.scene.shadows = TIA_SHADOWS_ZFAIL;
    scene.scene.camera.samples = 4;
    frames_scene(c, &scene.scene, 32, 24, false, "flat-1-32x24-4-samples-zfail");
}

/* ---- polygons ---- */

#define FRAMES_POLYGONS 80
#define FRAMES_TARGET (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR)

struct frames_target {
    struct tia_raster_grid grid;
    struct tia_raster_target target;
    void *memory;
};

static inline void frames_open_target(struct frames_canvas *c, struct frames_target *t, enum tia_projection projection,
                                      unsigned range)
{
    size_t size;

    c->area = (struct tia_tile){0, 0, 64, 48};
    c->pixels = calloc((size_t)64 * 48, sizeof *c->pixels);
    size = tia_raster_size(c->area, FRAMES_TARGET, FRAMES_POLYGONS);
    t->memory = malloc(size);
    if (!c->pixels || !t->memory || tia_raster_grid_init(&t->grid, projection, 64, 48, 1, 0, range) ||
        tia_raster_init(&t->target, t->memory, size, &t->grid, c->area, FRAMES_TARGET, FRAMES_POLYGONS))
        abort();
}

static inline void frames_close_target(struct frames_canvas *c, struct frames_target *t)
{
    free(c->pixels);
    free(t->memory);
}

static inline int64_t frames_coordinate(uint64_t *state, int64_t most)
{
    return (int64_t)(dice_next(state) % (2 * (uint64_t)most + 1)) - most;
}

/* Returns a point: in perspective in front of the eye or behind it; in orthographic views with its nearness in h. */
static inline struct tia_raster_vertex frames_point(uint64_t *state, const struct tia_raster_grid *l, int64_t most)
{
    int64_t x = frames_coordinate(state, most), y = frames_coordinate(state, most), z = frames_coordinate(state, most);

    if (l->projection == TIA_ORTHOGRAPHIC)
        return (struct tia_raster_vertex){x, y, INT64_C(1) << l->fraction, z};
    return (struct tia_raster_vertex){x, y, dice_one_in(state, 4) || z > 0 ? z : -z, 1};
}

/* Makes a polygon and returns its number of corners: one in three is the side of a shadow volume, whose far corners are
 * at infinity; the others are triangles. */
static inline unsigned frames_polygon(uint64_t *state, const struct tia_raster_grid *l, int64_t most,
                                      struct tia_raster_vertex v[4])
{
    const int64_t size = most >> dice_between(state, 1, 3);
    struct tia_raster_vertex light = frames_point(state, l, most);

    v[0] = frames_point(state, l, most - size);
    for (int i = 1; i < 3; i++) {
        v[i] = v[0];
        v[i].x += frames_coordinate(state, size);
        v[i].y += frames_coordinate(state, size);
        *(l->projection == TIA_ORTHOGRAPHIC ? &v[i].h : &v[i].w) += frames_coordinate(state, size);
    }
    if (!dice_one_in(state, 3))
        return 3;
    for (int i = 2; i < 4; i++) {
        const struct tia_raster_vertex *p = &v[3 - i];
        v[i] = (struct tia_raster_vertex){p->x - light.x, p->y - light.y, p->w - light.w, p->h - light.h};
    }
    return 4;
}

/* Returns the position of the highest bit of n in 6 bits, and the ten bits that follow it. */
static inline tia_rgb565 frames_magnitude(uint64_t n)
{
    unsigned zeros = 0;

    while (zeros < 63 && !(n << zeros >> 63))
        zeros++;
    return (tia_rgb565)((63 - zeros) << 10 | (n << zeros >> 53 & 1023));
}

/* Reports the face, the nearness and the stencil value of each pixel. Coordinates are below `most`; 0: as large as 64
 * bits allow. */
static inline void frames_polygons(struct frames_canvas *c, const char *format, enum tia_projection projection,
                                   int64_t most)
{
    struct frames_target t;
    struct tia_stencil count = {TIA_COMPARE_ALWAYS,   0, 255, 255, TIA_STENCIL_KEEP, TIA_STENCIL_DECR_WRAP,
                                TIA_STENCIL_INCR_WRAP};
    struct tia_raster_state how = {.depth = TIA_COMPARE_LESS, .depth_write = true, .front = count, .back = count};
    uint64_t state = 565;
    char name[60];

    frames_open_target(c, &t, projection, 2);
    how.back.zfail = TIA_STENCIL_INVERT;
    for (uint32_t i = 0; i < FRAMES_POLYGONS; i++) {
        struct tia_raster_vertex v[4];
        unsigned corners = frames_polygon(&state, &t.grid, most ? most : t.grid.narrow / 2, v);
        if (tia_raster_draw(&t.target, &how, v, corners, i))
            abort();
    }
    static const char *const buffers[] = {"faces", "depth", "stencil"};
    for (unsigned n = 0; n < 3; n++) {
        for (size_t i = 0; i < (size_t)64 * 48; i++)
            c->pixels[i] = (tia_rgb565)(n == 0   ? t.target.face[i] * 1657
                                        : n == 1 ? frames_magnitude(t.target.nearness[i])
                                                 : t.target.stencil[i] * 257u);
        (void)snprintf(name, sizeof name, "polygons-%s-64x48-%s", format, buffers[n]);
        frames_tell(c, name);
    }
    frames_close_target(c, &t);
}

/* Draws random triangle `face`, at a z from 2 to 8 in front of the eye, or its image in the plane z = 8. */
static inline void frames_draw_reflected(struct tia_raster_target *target, struct tia_raster_state *how, uint32_t face,
                                         bool mirrored)
{
    const int32_t one = (int32_t)1 << target->grid->fraction;
    struct tia_raster_vertex v[3];
    uint64_t state = face;
    int32_t x = dice_between(&state, -3 * one, 3 * one), y = dice_between(&state, -2 * one, 2 * one);
    int32_t z = dice_between(&state, 3 * one, 7 * one);

    for (int i = 0; i < 3; i++) {
        int32_t w = z + dice_between(&state, -one, one);
        v[i].x = x + dice_between(&state, -one, one);
        v[i].y = y + dice_between(&state, -one, one);
        v[i].w = mirrored ? 16 * (int64_t)one - w : w;
        v[i].h = 1;
    }
    how->colour[0] = (uint16_t)(face * 1657);
    if (tia_raster_draw(target, how, v, 3, face + (mirrored ? FRAMES_POLYGONS / 2 : 0)))
        abort();
}

/* Draws a mirror by the stencil buffer: the faces in front of the mirror, then the mirror itself, which sets marks, and
 * the mirrored faces where a mark is set, as in test_raster_mirror.c. */
static inline void frames_mirror(struct frames_canvas *c)
{
    static const struct tia_stencil any = {TIA_COMPARE_ALWAYS, 1, 255, 255, TIA_STENCIL_KEEP, TIA_STENCIL_KEEP,
                                           TIA_STENCIL_KEEP};
    const uint32_t half = FRAMES_POLYGONS / 2;
    struct frames_target t;
    struct tia_raster_state how = {
        .depth = TIA_COMPARE_LESS, .depth_write = true, .front = any, .back = any, .colour_write = {true, true, true}};

    frames_open_target(c, &t, TIA_PERSPECTIVE, 5);
    const int64_t one = INT64_C(1) << t.grid.fraction, x = 6 * one, y = 5 * one, w = 8 * one;
    const struct tia_raster_vertex mirror[4] = {{-x, -y, w, 1}, {x, -y, w, 1}, {x, y, w, 1}, {-x, y, w, 1}};
    for (uint32_t i = 0; i + 1 < half; i++)
        frames_draw_reflected(&t.target, &how, i, false);
    how.front.zpass = how.back.zpass = TIA_STENCIL_REPLACE;
    how.colour[0] = 0x5b0f;
    if (tia_raster_draw(&t.target, &how, mirror, 4, half - 1))
        abort();
    tia_raster_clear_depth(&t.target);
    how.front.zpass = how.back.zpass = TIA_STENCIL_KEEP;
    how.front.test = how.back.test = TIA_COMPARE_EQUAL;
    for (uint32_t i = 0; i + 1 < half; i++)
        frames_draw_reflected(&t.target, &how, i, true);
    for (size_t i = 0; i < (size_t)64 * 48; i++)
        c->pixels[i] = t.target.colour[3 * i];
    frames_tell(c, "mirror-by-stencil-64x48");
    frames_close_target(c, &t);
}

static inline void frames_shadows(struct frames_canvas *c)
{
    for (unsigned i = 0; i < FRAMES_FLAT; i++)
        frames_flat(c, i);
    frames_maps(c);
    for (unsigned i = 0; i < FRAMES_CURVED; i++)
        frames_curved(c, i);
    frames_cameras(c);
    frames_polygons(c, "64-bits", TIA_PERSPECTIVE, 0);
    frames_polygons(c, "128-bits", TIA_PERSPECTIVE, (INT64_C(1) << 40) - 1);
    frames_polygons(c, "orthographic", TIA_ORTHOGRAPHIC, (INT64_C(1) << 29) - 1);
    frames_mirror(c);
}

#endif
