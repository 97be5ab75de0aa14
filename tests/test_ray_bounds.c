/* The bounds of src/simd/rays: the fixed-point ray is traced beside each certified one, and the used part of each bound
 * is measured. None may be exceeded; the largest part of each is printed.
 *
 *     test_ray_bounds            as many scenes as seconds allow
 *     test_ray_bounds N          N random scenes: make check runs 1000 (tests/slow/simd)
 *     test_ray_bounds --uses     the needed part of each bound by name
 *     test_ray_bounds --rays N [PASS]     N rays, see below: make check-rays-billion
 *
 * --uses finds the least power of two by which a bound can be scaled in a few scenes before a quantity is off by more
 * than its bound, or a decision differs. --rays draws the gallery, the databases and random scenes, larger with each
 * pass, until N rays, shadow rays among them, are compared. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "common/scene/scene_load.h"
#include "float_modes.h"
#include "render/whitted/shade.h"
#include "with_hierarchy.h"

#define BOUND_SCALES "bound_scales.h"
#define SURE_CHECK
#include "one_lane.h"

static unsigned random_scenes = 150;

enum { ORIGIN, DIRECTION, DISTANCE, POINT, GEOMETRIC, NORMAL, OWN, COLOUR, BOUNDS };
static const char *const names[BOUNDS] = {"origin",           "direction", "distance",           "point",
                                          "geometric normal", "normal",    "light of a surface", "colour of a sample"};
static double used[BOUNDS];
static unsigned long compared, differing, rays, shadow_rays, rests;

static void use(int what, double gap, double bound)
{
    double part = gap / bound;

    used[what] = part > used[what] || isnan(part) ? part : used[what];
    compared++;
}

static double gap3(const struct v3 *a, const double b[3])
{
    return sqrt((a->x - b[0]) * (a->x - b[0]) + (a->y - b[1]) * (a->y - b[1]) + (a->z - b[2]) * (a->z - b[2]));
}

/* ---- the fixed-point side: the ray that is followed, the pending ones, and the hits ---- */

static const struct ray_view *view;
static struct exact {
    struct ray ray;
    struct media media;
    unsigned class; /* class of the sample's pixel */
} now, waiting[QUEUE_SIZE];
static struct shading shading;
static struct path path;

static void check_camera(const struct sure_block *b, const struct rays *r)
{
    struct sure_place place = sure_place_of(b, (int)r->slot[0] / b->samples);
    int x = b->x + place.x, y = b->y + place.y;
    const struct light_pixel pixel = ray_pixel_at(x, y);

    now.class = ray_pixel_class(x, y);
    now.media.count = 0;
    ray_camera_ray(&view->camera, &pixel, (int)r->slot[0] % b->samples, &now.ray);
}

static void check_push(int item, bool refracted)
{
    struct bounces next;

    shade_bounce(view, &shading, &now.media, &next);
    waiting[item] =
        (struct exact){refracted ? next.refracted : next.reflected, refracted ? next.media : now.media, now.class};
}

static void check_pop(int item)
{
    now = waiting[item];
}

static void check_met(const struct rays *r, const struct query *q)
{
    double o[3], d[3];
    struct hit hit;

    sure_point(o, now.ray.origin);
    sure_dir(d, now.ray.direction);
    use(ORIGIN, gap3(&r->p.o, o), r->p.eo);
    use(DIRECTION, gap3(&r->p.d, d), r->p.ed);
    path = (struct path){.view = view, .class = now.class, .next_reached = PATH_REACHED};
    for (int i = 0; i < PATH_BLOCKERS; i++)
        path.blocker[i] = TIA_NO_OBJECT;
    ray_intersect(view, &now.ray, &hit);
    ray_intersect_lights(view, &now.ray, &hit);
    double object = hit.light != TIA_NO_OBJECT    ? LIGHT_ID + hit.light
                    : hit.object != TIA_NO_OBJECT ? (double)hit.object
                                                  : -1;
    rays++;
    bool same = object == q->id && (object < 0 || object >= LIGHT_ID || q->element == hit.element);
    differing += !same;
    if (object >= 0)
        use(DISTANCE, fabs(sure_length(hit.t) - q->t), q->e);
    if (object >= 0 && object < LIGHT_ID)
        shade_prepare(&path, &now.ray, &hit, &shading);
}

static void check_surface(const struct shade *h)
{
    double v[3];

    sure_point(v, shading.point);
    use(POINT, gap3(&h->point, v), h->ep);
    sure_dir(v, shading.geometric);
    use(GEOMETRIC, gap3(&h->geometric, v), h->eg);
    sure_dir(v, shading.normal);
    use(NORMAL, gap3(&h->normal, v), h->en);
}

/* Counts shadow rays, which check_own() compares by their transmission. */
static void check_shadow(unsigned lanes)
{
    shadow_rays += lanes;
}

static void check_own(const struct lit *lit)
{
    const num_length whole[3] = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE};
    num_length colour[3] = {0, 0, 0};

    shade_light(&path, &shading, whole, colour);
    for (int c = 0; c < 3; c++)
        use(OWN, fabs(sure_length(colour[c]) - lit->own[c]), lit->eown);
}

/* ---- scenes ---- */

static void check_block(struct sure_block *b)
{
    static struct work work;

    trace(b, &work);
    rests += (unsigned long)b->rest_count;
    tia_sure_add_rests(b);
    for (int i = 0; i < b->width * b->height * b->samples; i++) {
        struct sure_place place = sure_place_of(b, i / b->samples);
        num_length colour[3];
        if (b->unsure[i])
            continue;
        tia_sure_sample(view, b->x + place.x, b->y + place.y, i % b->samples, colour);
        for (int c = 0; c < 3; c++)
            use(COLOUR, fabs(sure_length(colour[c]) - b->colour[c][i]), b->error[i]);
    }
}

static void check_scene(const struct tia_scene *scene, unsigned width, unsigned height)
{
    size_t size = tia_view_size(scene, scene->light_count), more = tia_sure_size(scene, scene->light_count);
    void *memory = malloc(size), *constants = malloc(more);
    struct tia_view *prepared;
    struct sure_block b;

    CHECK_EQ(tia_view_init(&prepared, memory, size, scene, scene->light_count, width, height, NULL), TIA_OK);
    prepared->simd_memory = constants;
    if (prepared->renderer->part != SIMD_RAYS) {
        free(constants);
        free(memory);
        return;
    }
    view = prepared->prepared;
    tia_sure_prepare(prepared);
    tia_sure_set_lights(prepared);
    b.scene = tia_sure_scene(prepared);
    b.cancel = (struct cancel){0};
    b.seen = NULL;
    b.samples = view->camera.side * view->camera.side;
    b.width = b.height = SURE_SIDE / 2 / view->camera.side;
    for (b.y = 0; b.y + b.height <= (int)height; b.y += b.height)
        for (b.x = 0; b.x + b.width <= (int)width; b.x += b.width)
            check_block(&b);
    free(constants);
    free(memory);
}

static void forget_uses(void)
{
    memset(used, 0, sizeof used);
    compared = differing = 0;
}

static void check_bounds(const char *what)
{
    for (int i = 0; i < BOUNDS; i++) {
        CHECK_MSG(used[i] <= 1, "%s: the bound of the %s is exceeded %.2f times", what, names[i], used[i]);
        printf("# %s: %.3f of the bound of the %s\n", what, used[i], names[i]);
    }
    CHECK_MSG(differing == 0, "%s: %lu decisions differ", what, differing);
    CHECK(compared > 10000);
    forget_uses();
}

/* Checks the scenes of files, in pictures of `part` times 16 x 12 or 8 x 8 pixels. */
static void check_files(unsigned part)
{
    static const char *const files[] = {"scenes/nff/balls_2.nff", "scenes/nff/rings_3.nff", "scenes/nff/teapot_3.nff",
                                        "scenes/nff/jacks_3.nff", "scenes/orrery.tia"};

    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct scene_file file;
        CHECK_EQ(scene_open(&file, files[i], scene_format_of(files[i]), false), TIA_OK);
        check_scene(&file.scene, (i < 4 ? 16 : 8) * part, (i < 4 ? 12 : 8) * part);
        scene_close(&file);
    }
}

TEST(scene_files)
{
    check_files(2);
    check_bounds("files");
}

static void check_small(const struct tia_scene *scene, unsigned number)
{
    (void)number;
    check_scene(scene, 16, 16);
}

static void check_corpus(unsigned scenes)
{
    static struct corpus_rays c;

    for (unsigned i = 0; i < scenes; i++) {
        corpus_random_rays(&c, 12, i);
        with_hierarchy(&c.scene, check_small, i);
    }
}

TEST(random_corpus)
{
    rests = 0;
    check_corpus(random_scenes);
    check_bounds("random scenes");
    printf("# %lu rays were followed by the fixed-point path from where they start\n", rests);
    CHECK(rests > 0);
}

/* ---- the needed part of each bound ---- */

static bool holds(void)
{
    bool all = true;

    forget_uses();
    check_files(1);
    check_corpus(20);
    for (int i = 0; i < BOUNDS; i++)
        all = all && used[i] <= 1;
    return all && differing == 0;
}

/* Returns the least power of two by which the bound may be scaled, from 1/64 on; 0: the bound is not needed. */
static double least_scale(double *scale)
{
    double least = 1;

    *scale = 0;
    if (holds())
        least = 0;
    for (*scale = 0.5; least > 1.0 / 64 && holds(); *scale /= 2)
        least = *scale;
    *scale = 1;
    return least;
}

TEST(uses_by_name)
{
    int unused = 0;

    CHECK(holds());
    for (int i = 0; i < scaled_bound_count; i++) {
        double least = least_scale(&scaled_bounds[i].scale);
        printf("# %-28s %g of it is needed\n", scaled_bounds[i].name, least);
        (void)fflush(stdout);
        unused += least == 0;
    }
    printf("# %d of %d bounds could be left out in these scenes\n", unused, scaled_bound_count);
    CHECK(holds());
}

/* ---- the number of rays given ---- */

static uint64_t rays_asked;
static unsigned first_pass;

static void check_file(const char *name, unsigned width, unsigned height)
{
    struct scene_file file;

    CHECK_MSG(scene_open(&file, name, scene_format_of(name), false) == TIA_OK, "%s", name);
    if (file.scene.bvh)
        check_scene(&file.scene, width, height);
    scene_close(&file);
}

static void check_larger(const struct tia_scene *scene, unsigned number)
{
    (void)number;
    check_scene(scene, 64, 48);
}

static void check_random(unsigned pass, unsigned index)
{
    static struct corpus_rays c;

    corpus_random_rays(&c, 1000 + pass, index);
    with_hierarchy(&c.scene, check_larger, index);
}

static bool has_enough(const char *what)
{
    bool exceeded = differing != 0;

    for (int i = 0; i < BOUNDS; i++)
        exceeded = exceeded || !(used[i] <= 1);
    if (exceeded)
        CHECK_MSG(false, "%s: %lu of %lu rays differ, or a bound is exceeded", what, differing, rays);
    return check_failed || rays + shadow_rays >= rays_asked;
}

TEST(many_rays)
{
    static const char *const files[] = {"scenes/castle.tia",      "scenes/nff/balls_3.nff",   "scenes/chess.tia",
                                        "scenes/nff/gears_1.nff", "scenes/flake.tia",         "scenes/nff/jacks_3.nff",
                                        "scenes/glass.tia",       "scenes/nff/lattice_3.nff", "scenes/orrery.tia",
                                        "scenes/nff/mount_3.nff", "scenes/vase.tia",          "scenes/nff/rings_3.nff",
                                        "scenes/porch.tia",       "scenes/nff/teapot_3.nff",  "scenes/cornell.tia",
                                        "scenes/nff/tetra_4.nff", "scenes/nff/shells_2.nff",  "scenes/nff/tree_4.nff"};
    const unsigned count = sizeof files / sizeof *files;
    bool enough = false;

    for (unsigned pass = first_pass; !enough; pass++) {
        unsigned width = 96 + 8 * (pass % 64) + pass / 64; /* sizes differ, so that no picture is drawn twice */
        for (unsigned i = 0; i < count && !enough; i++) {
            check_file(files[i], width, width / 4 * 3);
            enough = has_enough(files[i]);
        }
        for (unsigned i = 0; i < 50 && !enough; i++) {
            check_random(pass, i);
            enough = has_enough("random scenes");
        }
        printf("# pass %u: %lu rays and %lu shadow rays, %lu differ\n", pass, rays, shadow_rays, differing);
        (void)fflush(stdout);
    }
    for (int i = 0; i < BOUNDS; i++)
        printf("# %.3f of the bound of the %s\n", used[i], names[i]);
}

int main(int argc, char **argv)
{
    float_mode_of_simd();
    if (argc > 2 && strcmp(argv[1], "--rays") == 0) {
        rays_asked = strtoull(argv[2], NULL, 10);
        first_pass = argc > 3 ? (unsigned)strtoul(argv[3], NULL, 10) : 0;
        RUN(many_rays);
        return check_status();
    }
    if (argc > 1 && strcmp(argv[1], "--uses") == 0) {
        RUN(uses_by_name);
        return check_status();
    }
    random_scenes = (unsigned)check_number(argc, argv, 1, random_scenes);
    RUN(scene_files);
    RUN(random_corpus);
    return check_status();
}
