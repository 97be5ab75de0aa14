/* The stack use of SIMD kernels, for any scene: the stack is painted, and the deepest changed byte is found. Also,
 * drawing works in threads with small stacks. */
#include <pthread.h>
#include <stdlib.h>
#include <sys/mman.h>

#include <tia/simd.h>

#include "common/corpus/corpus_rays.h"
#include "edge_scene.h"
#include "reading.h"
#include "render/renderer.h"
#include "simd_frames.h"
#include "with_hierarchy.h"

/* Compilers without optimisation, and sanitizers, keep every value on the stack. */
#if defined __OPTIMIZE__ && !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__
#define LIMITED true
#endif
#if defined __has_feature
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#undef LIMITED
#endif
#endif
#ifndef LIMITED
#define LIMITED false
#endif

enum { W = 24, H = 17, SIZE = 4 << 20, SMALL = LIMITED ? 64 << 10 : SIZE, LIMIT = 16 << 10, PAINT = 0xa7 };

static const struct tia_simd *simd;

/* ---- the thread's work ---- */

struct work {
    struct tia_view *view;
    struct tia_hits *hits;
    void *memory;
    size_t size;
    const uint8_t *top; /* top of the stack, where the measured work begins */
    int status;
};

static const struct tia_tile frame = {0, 0, W, H};
static tia_rgb565 pixels[W * H];
static uint32_t path_hash[W * H];
static struct tia_sum sums[W * H];

static void *do_work(void *arg)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * W};
    const struct tia_options hashed = {.dither = true, .debug = &(struct tia_debug){.path_hash = path_hash}};
    struct work *w = arg;
    uint8_t here;

    w->top = &here;
    w->status = tia_view_set_simd(w->view, simd, w->memory, w->size);
    if (!w->status)
        w->status = tia_view_set_lights(w->view, w->view->lights, w->view->light_count);
    if (!w->status)
        w->status = tia_view_draw(w->view, w->hits, frame, &surface, NULL);
    if (!w->status)
        w->status = tia_view_light(w->view, w->hits, frame, &surface, &hashed);
    if (!w->status && w->view->renderer->sample)
        w->status = tia_estimator_q16.sample(w->view, frame, 0, 3, sums, W);
    return NULL;
}

static void run(struct work *w, void *stack, size_t size)
{
    pthread_attr_t attributes;
    pthread_t thread;

    CHECK_EQ(pthread_attr_init(&attributes), 0);
    CHECK_EQ(stack ? pthread_attr_setstack(&attributes, stack, size) : pthread_attr_setstacksize(&attributes, size), 0);
    CHECK_EQ(pthread_create(&thread, &attributes, do_work, w), 0);
    CHECK_EQ(pthread_join(thread, NULL), 0);
    (void)pthread_attr_destroy(&attributes);
}

/* ---- scenes ---- */

static uint8_t *stack;
static size_t deepest;
static char deepest_scene[80];

/* Measures the stack use of a call, and records the largest. Stacks grow downwards on every processor with SIMD
 * kernels. */
static void measure(struct work *w, const char *what, unsigned number)
{
    size_t unused = 0;

    memset(stack, PAINT, SIZE);
    run(w, stack, SIZE);
    while (unused < SIZE && stack[unused] == PAINT)
        unused++;
    size_t used = (size_t)(w->top - stack) - unused;
    if (used > deepest) {
        deepest = used;
        (void)snprintf(deepest_scene, sizeof deepest_scene, "%s %u", what, number);
    }
}

static void draw(const struct tia_scene *scene, const char *what, unsigned number)
{
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, scene, W, H));
    struct work w = {.view = f.simd,
                     .hits = f.hits[1],
                     .memory = f.memory[2],
                     .size = tia_simd_size(simd, scene, scene->light_count, 1)};
    if (stack)
        measure(&w, what, number);
    else
        run(&w, NULL, SMALL);
    CHECK_MSG(w.status == TIA_OK, "%s, %s %u: status %d", simd->name, what, number, w.status);
    simd_frames_close(&f);
}

static void draw_corpus(const struct tia_scene *scene, unsigned number)
{
    draw(scene, "random scene", number);
}

/* A scene with all features that need much stack: grids and meshes with transforms, glass, textures, mirrors,
 * transparent groups, and lights with samples. */
static const char large[] =
    "camera eye 0 1 6 fov 50\nbackground 0.1 0.2 0.3\n"
    "texture squares checker even 0.2 0.3 0.2 odd 0.9 0.8 0.7 scale 0.3 0.3\n"
    "material plain colour 0.7 0.6 0.5 specular 0.5 0.4 0.3 exponent 12.5 facing 0.1\n"
    "material squares texture squares colour 0.8 1 0.7 specular 0.2 exponent 4 refraction 0.9 index 1.4 fresnel\n"
    "material mirror colour 0.5 mirror 0.5 specular 0.4 exponent 3\n"
    "material thin colour 0.2 mirror 0.3 refraction 0.8 index 1.6 fresnel transmission 0.5 0.6 0.5\n"
    "light sphere at 2 5 3 radius 1 emission 0.4 samples 16\n"
    "light rectangle at -2 4 1 sides 0.5 0 0  0 0 0.5 emission 0.5 samples 9\n"
    "light spot at 0.3 3 3 direction -0.1 -0.8 -0.6 inner 10 outer 35 emission 0.5 attenuation 0.5 0.2 0.1\n"
    "light directional direction 0.3 -1 -0.2 emission 0.2\n"
    "plane point 0 -1 0 normal 0 1 0 material squares\n"
    "sphere centre 0.3 0.5 0 radius 0.6 material thin\nsphere centre -1.2 0.4 0.5 radius 0.5 material mirror\n"
    "sphere radius 0.4 at 1.5 0.2 1 rotate 10 20 30 scale 1 0.4 1.3 material thin\n"
    "box min -1 -1 -1 max 1 1 1 at -0.8 -0.2 1.6 rotate 30 40 10 scale 0.2 0.5 0.3 material thin\n"
    "cone base 0.6 -0.7 0.9 top 0.6 0.2 1 radii 0.1 0.5 capped material thin\n"
    "cylinder base 0 0 0 top 0 1 0 radius 0.4 capped at 0.2 -0.9 1.2 rotate 5 70 10 scale 0.6 0.8 0.6 material plain\n"
    "instance steps at -0.6 -0.4 2 rotate 20 30 10 scale 0.4 0.5 0.6 material mirror\n"
    "grid steps size 3 3 2 corner -0.7 -0.7 -0.5 cell 0.5\nrow 1 2 0\nrow 0 2 1\nrow 0 1 1\nrow 1 0 2\nrow 1 0 0\n"
    "row 0 2 2\nend\n"
    "instance gem at 0.7 0.3 2 rotate 10 50 0 scale 0.6 0.9 0.5 material thin\n"
    "instance gem at -0.1 -0.5 2.5 rotate 40 0 10 scale 0.3 0.3 0.4 material squares\nmesh gem\n"
    "vertex 1 0 0.2\nvertex -0.5 0 0.9\nvertex -0.5 0 -0.9\nvertex 0 0.7 0\nnormal 0.9 0.4 0\nnormal -0.5 0.4 0.8\n"
    "normal -0.5 0.4 -0.8\nnormal 0 1 0\nface 1//1 4//4 2//2\nface 2//2 4//4 3//3\nface 3//3 4//4 1//1\nend\n";

static void draw_large(const struct tia_scene *scene, unsigned number)
{
    draw(scene, "large scene", number);
}

static void draw_all(void)
{
    static struct reading reading;
    static struct corpus_rays rays;
    static struct edge_scene edge;

    read_string(&reading, TIA_FORMAT_TIA, large);
    CHECK_MSG(reading.status == TIA_OK, "line %u: %s", reading.reader.error.line, reading.reader.error.text);
    for (unsigned i = 0; !reading.status && i < 3; i++) {
        reading.scene.integration.integrator = (enum tia_integrator)i;
        reading.scene.integration.spp = 8;
        with_hierarchy(&reading.scene, draw_large, i);
    }
    read_end(&reading);
    for (unsigned i = 0; i < 24; i++) {
        corpus_random_rays(&rays, 9, i);
        rays.scene.integration.integrator = (enum tia_integrator)(i % 3);
        rays.scene.integration.spp = 2;
        with_hierarchy(&rays.scene, draw_corpus, i);
    }
    for (unsigned i = 1; i <= 20; i++) {
        edge_make(&edge, i);
        if (!tia_scene_check(&edge.scene, NULL))
            draw(&edge.scene, "edge scene", i);
    }
}

/* ---- cases ---- */

/* Returns the number of bytes that simd.h allows. */
static size_t limit(void)
{
    size_t beyond = 0; /* bytes of a vector register beyond 128 bits */

#ifdef __riscv
    if (!strcmp(simd->name, "rvv")) {
        __asm__("csrr %0, 0xc22" : "=r"(beyond)); /* vlenb */
        beyond -= 16;
    }
#endif
    return LIMIT + beyond * (5 << 10) / 16;
}

TEST(no_more_than_simd_h_says)
{
    stack = mmap(NULL, SIZE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    deepest = 0;
    CHECK(stack != MAP_FAILED);
    draw_all();
    printf("# %s: %zu bytes, %s\n", simd->name, deepest, deepest_scene);
    CHECK_MSG(!LIMITED || deepest <= limit(), "%s takes %zu bytes of stack, %s", simd->name, deepest, deepest_scene);
    CHECK_MSG(deepest > 1024, "%s: %zu bytes?", simd->name, deepest);
    (void)munmap(stack, SIZE);
}

TEST(threads_with_little)
{
    stack = NULL;
    draw_all();
}

int main(void)
{
    for (unsigned i = 0; (simd = tia_simd_at(i)); i++) {
        RUN(no_more_than_simd_h_says);
        RUN(threads_with_little);
    }
    return check_status();
}
