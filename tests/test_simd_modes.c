/* Every instruction set in every floating-point environment that its caller may have: the same memory and the same
 * pictures, and the caller's environment is unchanged. */
#include <stdlib.h>

#include <tia/simd.h>

#include "common/corpus/corpus_rays.h"
#include "edge_scene.h"
#include "float_modes.h"
#include "render/renderer.h"
#include "simd_frames.h"
#include "with_hierarchy.h"

static const struct tia_simd *simd;
static const struct float_mode *mode;

/* ---- the mode, around one call ---- */

static struct environment before, after;

static void enter_mode(void)
{
    float_mode_set(mode);
#ifndef ENVIRONMENT_FIXED
    environment_read(&before);
#endif
}

static void leave_mode(void)
{
    const int rounding = fegetround();

#ifndef ENVIRONMENT_FIXED
    environment_read(&after);
    environment_write(&(struct environment){ENVIRONMENT_DEFAULT, 0});
    CHECK_MSG(after.control == before.control && after.flags == before.flags, "%s, %s: control %jx %jx, flags %jx %jx",
              simd->name, mode->name, (uintmax_t)before.control, (uintmax_t)after.control, (uintmax_t)before.flags,
              (uintmax_t)after.flags);
#endif
    CHECK_EQ(rounding, mode->rounding);
    (void)fesetround(FE_TONEAREST);
}

/* ---- scenes ---- */

typedef void scene_try(const struct tia_scene *scene, unsigned number);

static struct edge_scene edge;
static struct corpus_rays rays;

/* Runs twelve scenes for spans, as far as they are valid, and twelve scenes of all shapes: four each by rays, ambient
 * occlusion and paths. */
static void each_scene(scene_try *try)
{
    for (unsigned i = 1; i <= 12; i++) {
        edge_make(&edge, i);
        if (!tia_scene_check(&edge.scene, NULL))
            try(&edge.scene, i);
    }
    for (unsigned i = 0; i < 12; i++) {
        corpus_random_rays(&rays, 5, i);
        rays.scene.integration.integrator = (enum tia_integrator)(i % 3);
        rays.scene.integration.spp = 2;
        with_hierarchy(&rays.scene, try, 100 + i);
    }
}

enum { W = 24, H = 17 };

/* ---- cases ---- */

/* Compares the constants that SIMD kernels prepare; both times at the same place, so that addresses in them are equal.
 */
static void compare_memory(const struct tia_scene *scene, unsigned number)
{
    size_t size = tia_view_size(scene, scene->light_count), more = tia_simd_size(simd, scene, scene->light_count, 1);
    void *memory = malloc(size), *constants = calloc(1, more + 1), *want = malloc(more + 1);
    struct tia_view *view;

    CHECK_EQ(tia_view_init(&view, memory, size, scene, scene->light_count, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_simd(view, simd, constants, more), TIA_OK);
    memcpy(want, constants, more);
    memset(constants, 0, more);
    enter_mode();
    int status = tia_view_set_simd(view, simd, constants, more);
    leave_mode();
    CHECK_EQ(status, TIA_OK);
    CHECK_MSG(memcmp(want, constants, more) == 0, "%s, %s: scene %u", simd->name, mode->name, number);
    enter_mode();
    status = tia_view_set_lights(view, scene->lights, scene->light_count);
    leave_mode();
    CHECK_EQ(status, TIA_OK);
    CHECK_MSG(memcmp(want, constants, more) == 0, "%s, %s: scene %u, its lights", simd->name, mode->name, number);
    free(memory);
    free(constants);
    free(want);
}

TEST(memory)
{
    each_scene(compare_memory);
}

static bool asked, inside_nearest;
static struct environment inside;

static bool note_environment(void *ctx)
{
    (void)ctx;
#ifndef ENVIRONMENT_FIXED
    environment_read(&inside);
#endif
    volatile double one = 1, little = 0x1p-60;
    inside_nearest = one + little <= 1 && one - little >= 1;
    asked = true;
    return false;
}

/* Compares with plain C's picture for rays, and with the kernels' in the usual mode for spans. */
static void compare_picture(const struct tia_scene *scene, unsigned number)
{
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, scene, W, H));
    bool spans = f.plain->renderer->part == SIMD_SPANS;
    CHECK_EQ(tia_view_draw(spans ? f.simd : f.plain, f.hits[spans], f.area,
                           &(struct tia_surface){.pixels = (void *)f.want, .step = 2, .pitch = 2 * W}, NULL),
             TIA_OK);
    enter_mode();
    int status = tia_view_draw(f.simd, f.hits[1], f.area,
                               &(struct tia_surface){.pixels = (void *)f.got, .step = 2, .pitch = 2 * W}, NULL);
    leave_mode();
    CHECK_EQ(status, TIA_OK);
    CHECK_MSG(memcmp(f.want, f.got, 2 * W * H) == 0, "%s, %s: scene %u", simd->name, mode->name, number);
    simd_frames_close(&f);
}

TEST(pictures)
{
    each_scene(compare_picture);
}

/* Checks the environment inside the SIMD kernels, in their calls of `stop`. */
static void look_inside(const struct tia_scene *scene, unsigned number)
{
    static struct tia_sum sums[W * H];
    static tia_rgb565 pixels[W * H];
    const struct tia_tile all = {0, 0, W, H};
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, scene, W, H));
    f.simd->stop = note_environment;
    asked = false;
    enter_mode();
    if (f.simd->simd && f.simd->renderer->sample)
        f.simd->simd->enter->sample(f.simd, all, 0, 9, &(struct tia_gathered){.sums = sums, .pitch = W});
    else if (f.simd->simd)
        f.simd->simd->enter->light(f.simd, all, &(struct tia_surface){.pixels = pixels, .step = 2, .pitch = 2 * W},
                                   &(struct tia_options){0});
    leave_mode();
    CHECK_MSG(asked || !f.simd->simd, "scene %u", number);
#ifndef ENVIRONMENT_FIXED
    CHECK_MSG(!asked || ((inside.control ^ ENVIRONMENT_DEFAULT) & (mode->set | mode->clear | FLOAT_MASKS)) == 0,
              "%s, %s: scene %u: control %jx", simd->name, mode->name, number, (uintmax_t)inside.control);
#endif
    CHECK_MSG(!asked || inside_nearest, "%s, %s: scene %u", simd->name, mode->name, number);
    simd_frames_close(&f);
}

TEST(inside_of_a_level)
{
    each_scene(look_inside);
}

int main(void)
{
    for (unsigned i = 0; (simd = tia_simd_at(i)); i++)
        for (size_t k = 0; k < FLOAT_MODES; k++) {
            mode = &float_modes[k];
            RUN(memory);
            RUN(pictures);
            RUN(inside_of_a_level);
        }
    return check_status();
}
