/* A drawing that is asked to stop does, in the middle of a picture that would take minutes. */
#include <time.h>

#include <tia/render.h>

#include "check.h"

enum { W = 64, H = 48, MANY = 1000 };

static uint64_t view_memory[200000], hits_memory[W * H * 2 + 100];
static tia_rgb565 pixels[W * H];

/* ---- whoever asks ---- */

struct asker {
    unsigned asked, until; /* says true from that question on */
};

static bool ask(void *ctx)
{
    struct asker *asker = ctx;
    return ++asker->asked >= asker->until;
}

/* ---- pictures ---- */

static const struct tia_tile frame = {0, 0, W, H};

static struct tia_view *view_of(const struct tia_scene *scene)
{
    struct tia_view *view = NULL;

    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, scene, scene->light_count, W, H), TIA_OK);
    return view;
}

static int draw(const struct tia_view *view, struct tia_hits **hits, int traced)
{
    const struct tia_surface surface = {pixels, 2, 2 * W};
    int status = TIA_OK;

    if (!traced) {
        CHECK_EQ(tia_hits_init(hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
        status = tia_trace(view, *hits, frame);
    }
    return status ? status : tia_light_tile(view, *hits, frame, &surface, NULL);
}

static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

/* Balls in a row, and a light for each of the `light_count`. */
static struct tia_sphere balls[2];
static struct tia_light lights[MANY];
static struct tia_material materials[1];

static struct tia_scene scene_of(uint32_t light_count)
{
    balls[0] = (struct tia_sphere){.centre = TIA_VEC3(0, -10004, -20), .radius = TIA_Q16(10000)};
    balls[1] = (struct tia_sphere){.centre = TIA_VEC3(0, 0, -20), .radius = TIA_Q16(4)};
    materials[0] = (struct tia_material){.colour = TIA_RGB(0.5, 0.5, 0.5)};
    for (int i = 0; i < MANY; i++)
        lights[i] = (struct tia_light){TIA_VEC3(i % 10 - 5, 20 + i / 10, -10), TIA_Q16(0.5), TIA_RGB(1, 1, 1)};
    struct tia_scene scene = tia_thesis_scene;
    scene.bindings = NULL;
    scene.binding_count = 0;
    scene.materials = materials;
    scene.material_count = 1;
    scene.spheres = balls;
    scene.sphere_count = 2;
    scene.lights = lights;
    scene.light_count = light_count;
    return scene;
}

/* Each ray that meets the ball becomes two, sixteen times, and each of them asks for 256 shadow rays of a thousand
 * lights: one pixel would take days. */
static struct tia_scene endless_scene(void)
{
    struct tia_scene scene = scene_of(MANY);

    materials[0] = (struct tia_material){.colour = TIA_RGB(0.5, 0.5, 0.5),
                                         .mirror = TIA_RGB(1, 1, 1),
                                         .refraction = TIA_RGB(1, 1, 1),
                                         .index = TIA_Q16(1.5)};
    for (int i = 0; i < MANY; i++) {
        lights[i].kind = TIA_SPHERE_LIGHT;
        lights[i].samples = 256;
    }
    scene.depth = 16;
    return scene;
}

TEST(nobody_asks)
{
    struct tia_scene scene = scene_of(1);
    struct asker never = {0, UINT32_MAX};
    struct tia_hits *hits = NULL;
    static tia_rgb565 plain[W * H];
    struct tia_view *view = view_of(&scene);

    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    memcpy(plain, pixels, sizeof plain);
    tia_view_set_stop(view, ask, &never);
    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    CHECK(!memcmp(plain, pixels, sizeof plain) && never.asked >= H);
    never.until = 1;
    tia_view_set_stop(view, NULL, NULL);
    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    CHECK(!memcmp(plain, pixels, sizeof plain));
}

/* By spans a row is the unit: after the answer no row is begun. */
TEST(spans)
{
    struct tia_scene scene = scene_of(10);

    for (unsigned until = 1; until < H; until += 7) {
        struct asker asker = {0, UINT32_MAX};
        struct tia_hits *hits = NULL;
        struct tia_view *view = view_of(&scene);
        CHECK_EQ(draw(view, &hits, 0), TIA_OK);
        memset(pixels, 0x5a, sizeof pixels);
        asker.until = until;
        tia_view_set_stop(view, ask, &asker);
        CHECK_EQ(draw(view, &hits, 1), TIA_STOPPED);
        CHECK_MSG(pixels[(until - 1) * W] == 0x5a5a && (until == 1 || pixels[(until - 2) * W] != 0x5a5a), "row %u",
                  until);
    }
}

/* But many lights make a row take long. */
TEST(many_lights_in_a_row)
{
    struct tia_scene scene = scene_of(MANY);
    struct asker asker = {0, UINT32_MAX};
    struct tia_hits *hits = NULL;
    struct tia_view *view = view_of(&scene);

    CHECK_EQ(draw(view, &hits, 0), TIA_OK);
    tia_view_set_stop(view, ask, &asker);
    CHECK_EQ(draw(view, &hits, 1), TIA_OK);
    CHECK(asker.asked > H + H / 4 * (MANY / 64));
}

TEST(a_trace_by_spans)
{
    struct tia_scene scene = scene_of(1);
    struct asker asker = {0, 1};
    struct tia_hits *hits = NULL;
    struct tia_view *view = view_of(&scene);

    tia_view_set_stop(view, ask, &asker);
    CHECK_EQ(draw(view, &hits, 0), TIA_STOPPED);
    CHECK(asker.asked <= 2);
}

/* The first question comes soon, and the answer ends all. */
TEST(rays)
{
    struct tia_scene scene = endless_scene();
    struct tia_hits *hits = NULL;
    struct tia_view *view = view_of(&scene);
    struct asker asker = {0, 1};
    double start = cpu_seconds();

    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    tia_view_set_stop(view, ask, &asker);
    CHECK_EQ(tia_trace(view, hits, frame), TIA_STOPPED);
    CHECK(asker.asked <= 2);
    tia_view_set_stop(view, NULL, NULL);
    CHECK_EQ(tia_trace(view, hits, frame), TIA_OK);
    for (unsigned until = 1; until < 100000; until = until * 10 + 3) {
        asker = (struct asker){0, until};
        tia_view_set_stop(view, ask, &asker);
        CHECK_EQ(draw(view, &hits, 1), TIA_STOPPED);
        CHECK_MSG(asker.asked <= until + 1, "asked %u times after the answer", asker.asked - until);
    }
    CHECK(cpu_seconds() - start < 20);
}

/* Every core has the function. */
TEST(the_table_of_functions)
{
    struct tia_scene scene = endless_scene();
    struct asker asker = {0, 1};
    struct tia_view *view = view_of(&scene);
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_core_q16.hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    tia_core_q16.set_stop(view, ask, &asker);
    CHECK_EQ(tia_core_q16.trace(view, hits, frame), TIA_STOPPED);
}

int main(void)
{
    RUN(nobody_asks);
    RUN(spans);
    RUN(many_lights_in_a_row);
    RUN(a_trace_by_spans);
    RUN(rays);
    RUN(the_table_of_functions);
    return check_status();
}
