/* rays.c - valid scenes with all features, by q16 and by chk, with and without a hierarchy: no number leaves its range,
 * all draw the same along the same paths, and so do hits that are lit again. In double precision the same scene can be
 * drawn. Exact techniques for shadows draw the same. */
#include <stdio.h>
#include <string.h>

#include "accepted.h"
#include "picture_memory.h"

#define WORK 1500 /* limit of rays times objects, about a millisecond's */

static uint64_t rays_of(const struct made *m, uint32_t pixels)
{
    uint64_t forks = 0, samples = 1, rays = 1;

    for (uint32_t i = 0; i < MADE_MATERIALS; i++) {
        const struct tia_material *k = &m->materials[i];
        bool refracts = k->refraction.r | k->refraction.g | k->refraction.b;
        uint64_t here = refracts ? 2 : k->mirror.r || k->mirror.g || k->mirror.b;
        forks = here > forks ? here : forks;
    }
    for (uint32_t i = 0; i < m->scene.light_count; i++)
        samples += m->lights[i].kind < TIA_RECTANGLE_LIGHT ? 1 : m->lights[i].samples ? m->lights[i].samples : 16;
    for (uint32_t i = 0; i < (m->scene.depth ? m->scene.depth : TIA_DEPTH_DEFAULT) && forks; i++)
        rays += forks == 2 ? rays : 1;
    return rays * samples * pixels * (m->scene.camera.samples ? m->scene.camera.samples : 1);
}

static uint64_t work_of(const struct made *m, uint32_t pixels)
{
    uint64_t objects = m->scene.sphere_count + 1;

    for (uint32_t i = 0; i < m->scene.shape_count; i++)
        objects += m->shapes[i].kind == TIA_MESH ? 4 : m->shapes[i].kind == TIA_GRID ? m->grid.size[0] / 16 + 2 : 1;
    return objects * rays_of(m, pixels);
}

/* Reduces the depth, the tile and the samples until the work is within its limit. */
static void limit_work(struct made *m, struct tia_tile *tile)
{
    while (work_of(m, (uint32_t)tile->width * tile->height) > WORK)
        if (m->scene.depth != 1 && rays_of(m, 1) > 32)
            m->scene.depth = m->scene.depth ? m->scene.depth - 1 : TIA_DEPTH_DEFAULT;
        else if (tile->width > 1)
            tile->width = 1;
        else if (tile->height > 1)
            tile->height = 1;
        else if (m->scene.camera.samples > 1)
            m->scene.camera.samples /= 4;
        else
            break;
}

static void relight(struct picture *p, const struct tia_scene *scene, bool dither)
{
    MUST(!tia_view_set_lights(p->view, NULL, 0));
    light_picture(p, dither);
    MUST(!tia_view_set_lights(p->view, scene->lights, scene->light_count));
    light_picture(p, dither);
}

static struct tia_tile take_tile(struct bytes *b, uint16_t *width, uint16_t *height)
{
    static const uint16_t sizes[] = {1, 2, 3, 40, 639, TIA_SIZE_MAX};
    uint8_t size = take_byte(b), x = take_byte(b), y = take_byte(b);

    *width = sizes[size % 6];
    *height = sizes[size / 6 % 6];
    struct tia_tile tile = {(uint16_t)((*width - 1) * x / 255), (uint16_t)((*height - 1) * y / 255), 2, 2};
    tile.width = tile.x + 2 > *width ? 1 : 2;
    tile.height = tile.y + 2 > *height ? 1 : 2;
    return tile;
}

/* Checks that the scene with its hierarchy gives the same picture. */
static void draw_sooner(const struct picture *plain, const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    struct tia_scene with = *scene;
    size_t size = tia_bvh_size(scene);
    void *memory = malloc(size);
    struct picture sooner;

    MUST(memory && !tia_bvh_build(&with.bvh, memory, size, NULL, scene, NULL));
    open_picture(&sooner, &tia_core_q16, &with, width, height, plain->tile);
    light_picture(&sooner, false);
    must_be_same(plain, &sooner);
    close_picture(&sooner);
    free(memory);
}

static bool is_exact(enum tia_shadows shadows)
{
    return shadows == TIA_SHADOWS_RAYS || shadows == TIA_SHADOWS_ZPASS || shadows == TIA_SHADOWS_ZFAIL ||
           shadows == TIA_SHADOWS_MAP_EXACT;
}

/* Checks that the other exact techniques for shadows give the same picture. */
static void draw_otherwise(const struct picture *plain, const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    struct tia_scene other = *scene;
    struct picture picture;

    if (!is_exact(scene->shadows))
        return;
    for (unsigned i = 0; tia_shadows_name(i); i++) {
        other.shadows = (enum tia_shadows)i;
        if (!is_exact(other.shadows))
            continue;
        open_picture(&picture, &tia_core_q16, &other, width, height, plain->tile);
        light_picture(&picture, false);
        must_be_same(plain, &picture);
        close_picture(&picture);
    }
}

/* Chooses traced shadows if objects are too far away for the rasteriser. */
static void choose_shadows(struct tia_scene *scene, uint16_t width, uint16_t height)
{
    size_t size = tia_view_size(scene, scene->light_count);
    void *memory = malloc(size);
    struct tia_view *view;

    MUST(memory);
    if (tia_view_init(&view, memory, size, scene, scene->light_count, width, height, NULL) == TIA_ERR_RANGE)
        scene->shadows = TIA_SHADOWS_TRACED;
    free(memory);
}

static void draw(const struct tia_scene *scene, uint16_t width, uint16_t height, struct tia_tile tile)
{
    static const struct tia_core *const others[] = {&tia_core_chk, &tia_core_f64};
    struct picture q16, other;

    open_picture(&q16, &tia_core_q16, scene, width, height, tile);
    light_picture(&q16, false);
    must_see_objects(&q16, scene);
    draw_sooner(&q16, scene, width, height);
    draw_otherwise(&q16, scene, width, height);
    for (int i = 0; i < 2; i++) {
        open_picture(&other, others[i], scene, width, height, tile);
        light_picture(&other, false);
        must_see_objects(&other, scene);
        if (i == 0) {
            must_be_same(&q16, &other);
            relight(&q16, scene, false);
            must_be_same(&q16, &other);
        }
        close_picture(&other);
    }
    close_picture(&q16);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct made m;
    struct bytes b = {data, size};
    uint16_t width, height;
    struct tia_tile tile = take_tile(&b, &width, &height);

    if (!make_accepted(&b, &m))
        return 0;
    limit_work(&m, &tile);
    if (m.scene.shadows != TIA_SHADOWS_TRACED)
        choose_shadows(&m.scene, width, height);
    draw(&m.scene, width, height, tile);
    return 0;
}
