/* Rays reported to an observer: a mirror on the ground before the eye, computed from geometry. */
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"
#include "reading.h"

enum { MOST = 32, SIDE = 9 };

static struct tia_traced told[MOST];
static unsigned told_count;

static void note(void *ctx, const struct tia_traced *traced)
{
    (void)ctx;
    if (told_count < MOST)
        told[told_count] = *traced;
    told_count++;
}

static const struct tia_core *const core = &tia_core_watched;

/* Draws the middle pixel, whose ray is the camera's axis. Returns the number of tests counted. */
static uint32_t watch(const char *text)
{
    struct reading r = {.reader = {.text = text, .length = strlen(text)}};
    const struct tia_tile middle = {SIDE / 2, SIDE / 2, 1, 1};
    struct tia_observer observer = {note, NULL, 0};
    tia_rgb565 pixel, same;
    const struct tia_surface surface = {.pixels = &pixel, .step = 2, .pitch = 2},
                             again = {.pixels = &same, .step = 2, .pitch = 2};
    struct tia_view *view;
    struct tia_hits *hits;

    told_count = 0;
    read_begin(&r);
    CHECK_MSG(!r.status, "%s", r.reader.error.text);
    size_t view_size = core->view_size(core, &r.scene, r.scene.light_count),
           hits_size = core->hits_size(core, &r.scene, middle);
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    CHECK_EQ(core->view_init(core, &view, view_memory, view_size, &r.scene, r.scene.light_count, SIDE, SIDE, NULL),
             TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, middle), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, middle, &surface,
                           &(struct tia_options){.debug = &(struct tia_debug){.observer = &observer}}),
             TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, middle, &again, NULL), TIA_OK);
    CHECK_EQ(pixel, same);
    free(view_memory);
    free(hits_memory);
    read_end(&r);
    return observer.tests;
}

static bool at(struct tia_vec3 v, double x, double y, double z)
{
    double dx = v.x / 65536.0 - x, dy = v.y / 65536.0 - y, dz = v.z / 65536.0 - z;
    return dx * dx + dy * dy + dz * dz < 1e-6;
}

/* The ray goes from (0, 3, 4) down to the origin and up again to (0, 3, -4), where there is a wall. One light is above
 * the ground, one below. */
TEST(mirror_and_shadows)
{
    uint32_t tests =
        watch("camera eye 0 3 4 look 0 0 0 fov 40\nmaterial glass colour 0.1 mirror 0.5\n"
              "material wall colour 1\nlight point at 0 8 0\nlight point at 0 -8 0\n"
              "plane point 0 0 0 normal 0 1 0 material glass\nplane point 0 0 -4 normal 0 0 1 material wall\n");

    CHECK_EQ(told_count, 5);
    CHECK(told[0].ray == TIA_RAY_PRIMARY && at(told[0].from, 0, 3, 4) && at(told[0].to, 0, 0, 0));
    CHECK(told[0].object == 0 && told[0].light == TIA_NO_OBJECT && at(told[0].normal, 0, 1, 0));
    CHECK(told[0].length > 5 * 65536 - 8 && told[0].length < 5 * 65536 + 8);
    CHECK(told[1].ray == TIA_RAY_SHADOW && told[1].light == 0 && told[1].arrives && at(told[1].to, 0, 8, 0));
    CHECK(told[1].object == 0 && at(told[1].from, 0, 0, 0));
    CHECK(told[2].ray == TIA_RAY_REFLECTED && at(told[2].from, 0, 0, 0) && at(told[2].to, 0, 3, -4));
    CHECK(told[2].object == 1 && at(told[2].normal, 0, 0, 1));
    CHECK(told[3].ray == TIA_RAY_SHADOW && told[3].light == 0 && told[3].arrives && at(told[3].from, 0, 3, -4));
    CHECK(told[4].ray == TIA_RAY_SHADOW && told[4].light == 1 && !told[4].arrives && at(told[4].to, 0, -8, 0));
    CHECK_EQ(tests, 2 + 2 + 2 + 2 + 1); /* two planes, of which the last ray needs only the first */
}

/* One ray passes glass without refraction at a right angle; a ball is between point and light; one ray hits nothing. */
TEST(glass_and_nothing)
{
    (void)watch("camera eye 0 0 9 look 0 0 0 fov 40\nmaterial glass colour 0.1 refraction 0.9 index 1.5\n"
                "material ball colour 1\nlight point at 0 0 20\n"
                "box min -2 -2 -1 max 2 2 1 material glass\nsphere centre 0 0 15 radius 1 material ball\n");
    CHECK(told[0].ray == TIA_RAY_PRIMARY && at(told[0].to, 0, 0, 1) && at(told[0].normal, 0, 0, 1));
    CHECK(told[1].ray == TIA_RAY_SHADOW && !told[1].arrives && at(told[1].to, 0, 0, 20));
    bool through = false, nothing = false;
    for (unsigned i = 2; i < told_count; i++) {
        through =
            through || (told[i].ray == TIA_RAY_REFRACTED && at(told[i].from, 0, 0, 1) && at(told[i].to, 0, 0, -1));
        nothing =
            nothing || (told[i].ray == TIA_RAY_REFRACTED && told[i].length == INT32_MAX && at(told[i].from, 0, 0, -1) &&
                        at(told[i].to, 0, 0, -2) && told[i].object == TIA_NO_OBJECT);
    }
    CHECK(through && nothing);
}

int main(void)
{
    RUN(mirror_and_shadows);
    RUN(glass_and_nothing);
    return check_status();
}
