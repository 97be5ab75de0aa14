/* Rows that steps, parts and nearer spheres decide by few of their pixels, against the same pixels one by one: random
 * and constructed scenes, rows of any width, tiles that cut them, guard pixels. */
#include <stdlib.h>

#include "check.h"
#include "common/corpus/corpus.h"
#include "common/corpus/dice.h"
#include "edge_scene.h"
#include "render/core/dither.h"
#include "render/span/span_shade.h"

#define MOST 1920
#define GUARDS 8
#define EVERY 23 /* one of so many pixels is compared with the exact pixel */

static unsigned long compared;

/* Draws a span by the kernels for chunks, and some of its pixels exactly. */
static void draw_singly(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                        tia_rgb565 *want)
{
    struct exact_picture picture = span_picture_of(view);

    for (int i = 0; i < span->count; i += CHUNK) {
        num_u t[CHUNK];
        int count = span->count - i < CHUNK ? span->count - i : CHUNK;
        struct shaded_span part = {span->object, span->x + i, span->y, count, t, NULL, NULL};
        span_distances(span_view_of(view), span->object, span->y, part.x, count, t);
        shade_span(view, &part, threshold, want + i);
    }
    for (int i = span->x % EVERY; i < span->count; i += EVERY)
        want[i] = tia_exact_shade(&picture, span->x + i, span->y, span->object, (tia_q30)threshold[0], NULL, NULL);
}

/* Compares a tile's row as it is drawn with its pixels one by one. */
static void try_tile(const struct tia_view *view, struct tia_tile tile)
{
    static tia_rgb565 want[MOST], got[MOST + 2 * GUARDS];
    static uint64_t memory[2 * MOST + 64];
    const struct tia_surface surface = {got + GUARDS, sizeof *got, 0};
    struct tia_hits *hits;
    num_u threshold[THRESHOLDS];

    dither_thresholds(false, (int)tile.y, threshold);
    span_set_order(threshold, false);
    memset(got, 0xa5, sizeof got);
    CHECK_EQ(tia_hits_init(&hits, memory, sizeof memory, view, tile), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, tile, &surface, NULL), TIA_OK);
    for (int x = 0, end; x < tile.width; x = end) {
        uint32_t object = tia_hits_object(hits, tile.x + (unsigned)x, tile.y);
        end = x + 1;
        while (end < tile.width && tia_hits_object(hits, tile.x + (unsigned)end, tile.y) == object)
            end++;
        if (object >= view->scene->sphere_count || span_view_of(view)->spheres[object].c <= 0)
            continue;
        struct shaded_span span = {object, tile.x + x, tile.y, end - x, NULL, NULL, NULL};
        draw_singly(view, &span, threshold, want + x);
        compared += (unsigned long)(end - x);
        for (int i = x; i < end; i++)
            CHECK_MSG(got[GUARDS + i] == want[i], "sphere %u, pixel (%d, %d): %04x, not %04x", (unsigned)object,
                      tile.x + i, tile.y, got[GUARDS + i], want[i]);
    }
    for (int i = 0; i < GUARDS; i++)
        CHECK(got[i] == 0xa5a5 && got[GUARDS + tile.width + i] == 0xa5a5);
}

/* Tries rows of a scene with only its first light, whole and as tiles of any width cut them. */
static void try_scene(struct tia_scene *scene, unsigned width, unsigned height, uint64_t seed)
{
    size_t size = tia_view_size(scene, 1);
    void *memory = malloc(size);
    struct tia_view *view;

    scene->light_count = 1;
    if (width <= MOST && !tia_view_init(&view, memory, size, scene, 1, width, height, NULL))
        for (unsigned y = (unsigned)(seed % 3); y < height; y += 3 + height / 16) {
            unsigned part = 1 + (unsigned)(dice_next(&seed) % 130), x = (unsigned)(dice_next(&seed) % width);
            try_tile(view, (struct tia_tile){0, (uint16_t)y, (uint16_t)width, 1});
            part = part < width - x ? part : width - x;
            try_tile(view, (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)part, 1});
        }
    free(memory);
}

TEST(random_scenes)
{
    static struct edge_scene e;
    static struct corpus_scene c;

    for (unsigned i = 1; i <= 1500; i++) {
        edge_make(&e, i);
        e.lights[0].radius = 0; /* hits do not tell where a light is seen */
        if (e.scene.light_count)
            try_scene(&e.scene, e.width, e.height, i);
    }
    for (unsigned i = 0; i < 40; i++) {
        corpus_random(&c, 7, i);
        c.lights[0].radius = 0;
        try_scene(&c.scene, 640, 480, i);
    }
}

/* Scenes with a ground and a ball on or near it, and a light: at the centre of the ball, on the tangent plane of a
 * visible point of the ground, or on the ground, above or below it. */
TEST(constructed_scenes)
{
    static const tia_q16 radii[] = {64, 655, TIA_Q16_ONE, 20 * TIA_Q16_ONE, 10000 * TIA_Q16_ONE};
    struct corpus_scene s;

    for (unsigned i = 0; i < 400; i++) {
        uint64_t state = i + 77;
        CHECK_EQ(corpus_thesis(&s, "a", 640, 480), TIA_OK);
        memcpy(s.spheres, s.scene.spheres, 2 * sizeof *s.spheres);
        s.scene.spheres = s.spheres;
        struct tia_sphere *ball = &s.spheres[1], *ground = &s.spheres[0];
        ball->radius = radii[i % 5 == 4 ? 2 : i % 5];
        ground->radius = radii[i / 5 % 5];
        ground->centre = (struct tia_vec3){0, -ground->radius - TIA_Q16_ONE, s.scene.camera.eye.z - 8 * TIA_Q16_ONE};
        ball->centre = ground->centre;
        ball->centre.y += ground->radius + ball->radius + (i & 1 ? 0 : edge_any(&state, 16));
        ball->centre.x += edge_any(&state, 18);
        struct tia_vec3 *light = &s.lights[0].centre;
        *light = i % 3 == 0 ? ball->centre : ground->centre;
        light->y += i % 3 == 1 ? ground->radius : 0; /* on the ground's tangent plane */
        light->x += i % 3 == 1 ? edge_any(&state, 20) : 0;
        light->z += i % 3 == 1 ? edge_any(&state, 20) : 0;
        light->y += i % 3 == 2 ? ground->radius + edge_any(&state, 18) : 0;
        s.lights[0].radius = 0;
        s.scene.light_count = 1;
        try_scene(&s.scene, i & 2 ? 640 : 1920, 60 + i % 7, i);
    }
}

/* Pictures whose rows have 1 to 130 pixels. */
TEST(rows_of_any_width)
{
    struct corpus_scene s;

    for (unsigned width = 1; width <= 130; width++) {
        CHECK_EQ(corpus_thesis(&s, width & 1 ? "" : "a", width, 40), TIA_OK);
        try_scene(&s.scene, width, 40, width);
    }
}

int main(void)
{
    RUN(random_scenes);
    RUN(constructed_scenes);
    RUN(rows_of_any_width);
    printf("# %lu pixels compared\n", compared);
    return check_status();
}
