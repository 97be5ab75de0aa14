/* tia_bvh_move: the hierarchy is refitted, and rays hit the same as with a new one; films rebuild no static part. */
#include <stdlib.h>

#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "random.h"
#include "render/trace/trace.h"
#include "tia/bvh.h"

/* Numbers of calls of tia_bvh_build and tia_bvh_move by tools/tia/film_scene.c, which is included below. */
static unsigned builds, moves;

static inline int counted_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used,
                                const struct tia_scene *scene, const struct tia_job *job)
{
    builds++;
    return tia_bvh_build(bvh, memory, size, used, scene, job);
}

static inline int counted_move(const struct tia_bvh **bvh, void *memory, size_t size, const struct tia_scene *scene,
                               const struct tia_scene *standing, const struct tia_job *job)
{
    moves++;
    return tia_bvh_move(bvh, memory, size, scene, standing, job);
}

#define tia_bvh_build counted_build
#define tia_bvh_move counted_move
#include "../tools/tia/film_scene.c"
#undef tia_bvh_build
#undef tia_bvh_move

tia_q16 film_time(const struct options *options, uint32_t frame)
{
    (void)options;
    return (tia_q16)frame * TIA_Q16_ONE / 8;
}

struct rotation film_rotation(const struct options *options)
{
    return (struct rotation){options->rotate, 32, 24};
}

void fail_view_reason(char *why, size_t size, int status, const struct fail_view *view)
{
    (void)snprintf(why, size, "%d: %u spheres", status, (unsigned)view->scene->sphere_count);
}

/* ---- scenes ---- */

static bool contains(const struct tia_bounds *b, const struct tia_bounds *in)
{
    return in->max.x < in->min.x || (b->min.x <= in->min.x && b->min.y <= in->min.y && b->min.z <= in->min.z &&
                                     b->max.x >= in->max.x && b->max.y >= in->max.y && b->max.z >= in->max.z);
}

static void check_boxes(const struct tia_scene *scene)
{
    const struct tia_bvh_tree *tree = &scene->bvh->objects;
    uint32_t met = 0;

    for (uint32_t i = 0; i < tree->node_count; i++) {
        const struct tia_bvh_node *node = &tree->nodes[i];
        for (uint32_t k = 0; k < node->count; k++, met++) {
            struct tia_bounds box = tia_object_bounds(scene, tree->items[node->index + k]);
            CHECK(contains(&node->bounds, &box));
        }
        CHECK(node->count || (contains(&node->bounds, &tree->nodes[i + 1].bounds) &&
                              contains(&node->bounds, &tree->nodes[node->index].bounds)));
    }
    CHECK_EQ(met + scene->bvh->unbounded_count, scene->sphere_count + scene->shape_count);
}

static struct tia_view *open_view(void **memory, const struct tia_scene *scene)
{
    size_t size = tia_view_size(scene, scene->light_count);
    struct tia_view *view = NULL;

    *memory = malloc(size);
    CHECK_EQ(tia_view_init(&view, *memory, size, scene, scene->light_count, 48, 36, NULL), TIA_OK);
    return view;
}

/* Compares the hits of a picture's rays by two hierarchies. */
static void compare_rays(const struct tia_scene *scene, const struct tia_bvh *other)
{
    struct tia_scene with = *scene;
    void *memory[2];
    const struct tia_view *view[2];
    unsigned differ = 0;

    with.bvh = other;
    view[0] = open_view(&memory[0], scene);
    view[1] = open_view(&memory[1], &with);
    for (int i = 0; i < 48 * 36 && !check_failed; i++) {
        struct hit hit[2];
        struct ray ray;
        const struct light_pixel pixel = ray_pixel_at(i % 48, i / 48);
        const struct ray_view *one = view[0]->prepared;
        ray_camera_ray(&one->camera, &pixel, 0, &ray);
        for (int k = 0; k < 2; k++)
            ray_intersect(view[k]->prepared, &ray, &hit[k]);
        differ += hit[0].object != hit[1].object ||
                  (hit[0].object != TIA_NO_OBJECT && (hit[0].t != hit[1].t || hit[0].element != hit[1].element));
    }
    CHECK_EQ(differ, 0);
    free(memory[0]);
    free(memory[1]);
}

/* Tries the scene with its objects moved: a little, or far. */
static void try_moved(const struct tia_scene *standing, tia_q16 far)
{
    static struct tia_transform transforms[200];
    static struct tia_shape shapes[200];
    struct tia_scene scene = *standing;
    size_t size = tia_bvh_move_size(standing), whole = tia_bvh_size(standing);
    void *memory = malloc(size), *anew = malloc(whole);
    const struct tia_bvh *built;

    CHECK(scene.transform_count <= 200 && scene.shape_count <= 200);
    for (uint32_t i = 0; i < scene.shape_count; i++) {
        shapes[i] = standing->shapes[i];
        if (shapes[i].kind == TIA_SPHERE && i % 2)
            shapes[i].sphere.radius *= 2;
    }
    scene.shapes = shapes;
    for (uint32_t i = 0; i < scene.transform_count; i++) {
        transforms[i] = standing->transforms[i];
        if (i % 3 == 0)
            continue;
        transforms[i].position.x += (tia_q16)(far * random_double());
        transforms[i].position.y += (tia_q16)(far * random_double());
    }
    scene.transforms = transforms;
    if (tia_scene_check(&scene, NULL) == TIA_OK) {
        CHECK_EQ(tia_bvh_move(&scene.bvh, memory, size - 1, &scene, standing, NULL), TIA_ERR_MEMORY);
        CHECK_EQ(tia_bvh_move(&scene.bvh, memory, size, &scene, standing, NULL), TIA_OK);
        CHECK(scene.bvh->meshes == standing->bvh->meshes);
        check_boxes(&scene);
        CHECK_EQ(tia_bvh_build(&built, anew, whole, NULL, &scene, NULL), TIA_OK);
        compare_rays(&scene, built);
    }
    free(memory);
    free(anew);
}

TEST(random_scenes)
{
    static struct corpus_rays c;

    for (unsigned i = 0; i < 60; i++) {
        corpus_random_rays(&c, 21, i);
        size_t size = tia_bvh_size(&c.scene);
        void *memory = malloc(size);
        CHECK_EQ(tia_bvh_build(&c.scene.bvh, memory, size, NULL, &c.scene, NULL), TIA_OK);
        try_moved(&c.scene, TIA_Q16_ONE / 4);
        try_moved(&c.scene, 20 * TIA_Q16_ONE);
        c.scene.bvh = NULL;
        free(memory);
    }
}

/* ---- films ---- */

enum { STILL = 2000, FRAMES = 8 };

static struct tia_sphere spheres[STILL];

/* Makes many static spheres, and one shape that flies across. */
static void make_film(struct tia_scene *scene)
{
    static const struct tia_material material = {.colour = {TIA_Q30_ONE / 2, TIA_Q30_ONE / 2, TIA_Q30_ONE / 2}};
    static const struct tia_transform transform = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}};
    static const struct tia_shape shape = {
        .kind = TIA_SPHERE, .transform = 1, .sphere = {{0, 0, -8 * TIA_Q16_ONE}, TIA_Q16_ONE}};
    static const struct tia_keyframe keys[2] = {{0, {0, 0, 0}}, {TIA_Q16_ONE, {5 * TIA_Q16_ONE, 0, 0}}};
    static const struct tia_track track = {TIA_MOVES_TRANSFORM, 0, false, keys, 2};
    static const struct tia_light light = {.kind = TIA_POINT_LIGHT,
                                           .centre = {0, 20 * TIA_Q16_ONE, 0},
                                           .emission = {TIA_Q30_ONE / 2, TIA_Q30_ONE / 2, TIA_Q30_ONE / 2}};

    for (int i = 0; i < STILL; i++)
        spheres[i] = (struct tia_sphere){{(tia_q16)(600000 * random_double()), (tia_q16)(600000 * random_double()),
                                          (tia_q16)(-900000 + 200000 * random_double())},
                                         10000,
                                         0};
    *scene = (struct tia_scene){.camera = {.fov = TIA_Q16(50)},
                                .spheres = spheres,
                                .sphere_count = STILL,
                                .shapes = &shape,
                                .shape_count = 1,
                                .transforms = &transform,
                                .transform_count = 1,
                                .materials = &material,
                                .material_count = 1,
                                .tracks = &track,
                                .track_count = 1,
                                .lights = &light,
                                .light_count = 1};
}

TEST(films)
{
    static struct options options;
    struct film_scene film = {.options = NULL};
    char why[PORT_WHY] = "";
    unsigned same = 0;

    make_film(&options.scene);
    struct tia_fault fault = {.thing = "", .field = "", .rule = ""};
    CHECK_MSG(tia_scene_check(&options.scene, &fault) == TIA_OK, "%s %s: %s", fault.thing, fault.field, fault.rule);
    size_t size = tia_bvh_size(&options.scene);
    void *memory = malloc(size);
    CHECK_EQ(tia_bvh_build(&options.scene.bvh, memory, size, NULL, &options.scene, NULL), TIA_OK);
    options.core = &tia_core_q16;
    CHECK_EQ(film_scene_begin(&film, &options, why), TIA_OK);
    for (uint32_t i = 0; i < FRAMES; i++) {
        int status = film_scene_update(&film, i);
        CHECK_MSG(status == TIA_OK, "frame %u: %d %s", (unsigned)i, status, why);
        if (status)
            break;
        const struct tia_bvh_tree *before = &options.scene.bvh->objects, *now = &film.scene->bvh->objects;
        check_boxes(film.scene);
        CHECK(now->items == before->items && now->node_count == before->node_count);
        for (uint32_t k = 0; k < now->node_count && i == FRAMES - 1; k++)
            same += now->nodes[k].bounds.min.x == before->nodes[k].bounds.min.x &&
                    now->nodes[k].bounds.max.x == before->nodes[k].bounds.max.x;
    }
    CHECK_EQ(builds, 0);
    CHECK_EQ(moves, FRAMES);
    CHECK(same + 2 * TIA_BVH_DEPTH_MAX > options.scene.bvh->objects.node_count);
    film_scene_end(&film);
    free(memory);
}

int main(void)
{
    (void)counted_build; /* a film that calls it would fail */
    RUN(random_scenes);
    RUN(films);
    return check_status();
}
