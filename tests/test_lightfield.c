/* The eyes' positions of light fields, rounded once, against integer arithmetic; and refusals. */
#include <tia/lightfield.h>
#include <tia/scene.h>

#include "check.h"
#include "random.h"
#include "scene/light_grid.h"

#define ONE TIA_Q16_ONE

static struct tia_camera camera_of(tia_q16 line)
{
    return (struct tia_camera){.projection = TIA_FRUSTUM,
                               .eye = {3 * ONE, -ONE, 7},
                               .window = {-2 * ONE, 3 * ONE, -ONE, ONE, 4 * ONE},
                               .line = line};
}

static uint32_t below(uint32_t n)
{
    return random_u32() % n;
}

/* True if `got` is n/d rounded to nearest, halves up; d above 0. */
static bool is_nearest(int64_t got, int64_t n, int64_t d)
{
    return 2 * (got * d - n) <= d && 2 * (got * d - n) > -d;
}

TEST(views_stand_evenly)
{
    for (unsigned i = 0; i < check_count(4000); i++) {
        tia_q16 line = (tia_q16)(below(UINT32_C(1) << 20) + 1);
        uint32_t views = below(200) + 2, view = below(views);
        struct tia_camera camera = camera_of(line);
        int64_t place = tia_light_field_place(&camera, view, views);
        CHECK_MSG(is_nearest(place + line, (int64_t)2 * line * view, views - 1), "line %d, view %u of %u: %d",
                  (int)line, (unsigned)view, (unsigned)views, (int)place);
    }
    struct tia_camera longest = camera_of(INT32_MAX);
    CHECK_EQ(tia_light_field_place(&longest, 0, 65536), -INT32_MAX);
    CHECK_EQ(tia_light_field_place(&longest, 65535, 65536), INT32_MAX);
    CHECK_EQ(tia_light_field_place(&longest, 0, 1), 0);
}

/* For an upright screen u is x; rotated by a right angle, z. */
TEST(a_place_moves_the_eye_and_not_the_screen)
{
    struct tia_camera camera = camera_of(5 * ONE), out;

    tia_light_field_camera(&out, &camera, 12345);
    CHECK_EQ(out.eye.x, camera.eye.x + 12345);
    CHECK_EQ(out.eye.y, camera.eye.y);
    CHECK_EQ(out.window.left, camera.window.left - 12345);
    CHECK_EQ(out.window.right, camera.window.right - 12345);
    CHECK_EQ(out.window.top, camera.window.top);
    CHECK_EQ(out.line, 0);
    camera.up = (struct tia_vec3){0, ONE, 0};
    camera.reference = (struct tia_vec3){camera.eye.x + 9 * ONE, camera.eye.y, camera.eye.z};
    tia_light_field_camera(&out, &camera, -777);
    CHECK_EQ(out.eye.z, camera.eye.z - 777);
    CHECK_EQ(out.eye.x, camera.eye.x);
    CHECK_EQ(out.reference.z, camera.reference.z - 777);
}

/* The line runs along (3, 0, -4)/5, whose multiples are not multiples of 2^-16. */
TEST(an_oblique_place_is_rounded_once)
{
    struct tia_camera camera = camera_of(90 * ONE), out;

    camera.up = (struct tia_vec3){0, ONE, 0};
    camera.reference = (struct tia_vec3){camera.eye.x - 4 * ONE, camera.eye.y, camera.eye.z - 3 * ONE};
    for (tia_q16 place = -5000000; place < 5000000; place += 12347) {
        tia_light_field_camera(&out, &camera, place);
        CHECK_MSG(is_nearest(out.eye.x - camera.eye.x, (int64_t)3 * place, 5), "x at %d", (int)place);
        CHECK_MSG(is_nearest(out.eye.z - camera.eye.z, (int64_t)-4 * place, 5), "z at %d", (int)place);
        CHECK_EQ(out.eye.y, camera.eye.y);
        CHECK_EQ(out.reference.x - camera.reference.x, out.eye.x - camera.eye.x);
    }
}

static struct light_grid grid_of(struct tia_scene *scene, struct tia_camera camera, const struct tia_light_field *field,
                                 int width)
{
    struct light_grid grid;

    *scene = (struct tia_scene){.camera = camera, .field = field};
    CHECK_EQ(tia_scene_check(scene, NULL), TIA_OK);
    tia_light_grid_init(&grid, scene, width, 10);
    return grid;
}

/* Projectors aim at s = q + (q - p) D/d; q = left + (x + 1/2)/W 5, p = middle + place, with the middle at 1/2. */
TEST(projectors_aim_at_the_line)
{
    unsigned seen = 0;

    for (unsigned i = 0; i < check_count(4000); i++) {
        struct tia_light_field field = {.kind = TIA_PROJECTOR};
        struct tia_scene scene;
        struct light_pixel pixel;
        field.projector.distance = (tia_q16)below(UINT32_C(1) << 18) + 1;
        field.projector.place = (tia_q16)below(UINT32_C(1) << 18) - (1 << 17);
        int width = (int)below(60) + 1, x = (int)below((uint32_t)width);
        struct light_grid grid = grid_of(&scene, camera_of(3 * ONE), &field, width);
        bool seen_here = tia_light_grid_pixel(&grid, x, 0, 0, &pixel);
        int64_t d = field.projector.distance, whole = 2 * width;
        int64_t q = -2 * ONE * whole + (int64_t)5 * ONE * (2 * x + 1), p = whole * (ONE / 2 + field.projector.place);
        int64_t n = q * d + (q - p) * 4 * ONE; /* n over whole d */
        bool inside = n <= (3 * ONE * 2 + 1) * whole * d / 2 && n >= -(3 * ONE * 2 + 1) * whole * d / 2;
        seen += seen_here;
        CHECK_MSG(seen_here == inside || !is_nearest(pixel.place, n, whole * d), "whether %d is on the line", x);
        CHECK_MSG(!seen_here || is_nearest(pixel.place, n, whole * d) ||
                      2 * n % (whole * d) == 0, /* at a half either neighbour is correct */
                  "width %d, x %d: %d", width, x, (int)pixel.place);
    }
    CHECK(seen > 100);
}

TEST(phases_at_their_limits)
{
    struct tia_light_field field = {.kind = TIA_LENTICULAR};
    struct tia_scene scene;
    struct light_pixel pixel;

    field.lens.pitch = INT64_C(3) << 40; /* three lenses over three pixels: the phase grows by a third from subpixel to
                                            subpixel */
    struct light_grid grid = grid_of(&scene, camera_of(INT32_C(3000) * ONE), &field, 3);
    tia_light_grid_pixel(&grid, 0, 0, 0, &pixel); /* the phase is 1/2 */
    CHECK_EQ(pixel.place, 0);
    tia_light_grid_pixel(&grid, 0, 0, 1, &pixel); /* 5/6 */
    CHECK_EQ(pixel.place, 2000 * ONE);
    tia_light_grid_pixel(&grid, 2, 0, 2, &pixel); /* 1/6 */
    CHECK_EQ(pixel.place, -2000 * ONE);
    CHECK_EQ(pixel.x, 8);
    field.lens.inverted = true;
    grid = grid_of(&scene, camera_of(INT32_C(3000) * ONE), &field, 3);
    tia_light_grid_pixel(&grid, 0, 0, 1, &pixel);
    CHECK_EQ(pixel.place, -2000 * ONE);
}

static void refused(const struct tia_scene *scene, const char *thing, const char *field)
{
    struct tia_fault fault = {"", 0, "", ""};

    CHECK_EQ(tia_scene_check(scene, &fault), TIA_ERR_RANGE);
    CHECK_MSG(!strcmp(fault.thing, thing) && !strcmp(fault.field, field), "%s: %s: %s", fault.thing, fault.field,
              fault.rule);
}

TEST(what_is_refused)
{
    struct tia_light_field field = {.kind = TIA_QUILT, .quilt = {2, 2}};
    struct tia_scene good = {.camera = camera_of(ONE), .field = &field}, bad = good;
    const struct tia_sphere far = {.centre = {0, 0, -32000 * ONE}, .radius = ONE};
    const struct tia_material material = {.colour = {0, 0, 0}};

    CHECK_EQ(tia_scene_check(&good, NULL), TIA_OK);
    bad.camera.line = -1;
    refused(&bad, "camera", "line");
    bad.camera = (struct tia_camera){.fov = 25 * ONE, .line = ONE};
    refused(&bad, "camera", "line");
    bad.camera = camera_of(32767 * ONE);
    refused(&bad, "camera", "line");
    bad.camera = camera_of(0);
    refused(&bad, "light field", "camera");
    bad = good;
    bad.shadows = TIA_SHADOWS_ZFAIL;
    refused(&bad, "light field", "shadows");
    field.quilt.rows = 0;
    refused(&good, "light field", "quilt");
    field.quilt = (struct tia_quilt){TIA_QUILT_MAX, TIA_QUILT_MAX};
    CHECK_EQ(tia_scene_check(&good, NULL), TIA_OK);
    field.quilt.columns++;
    refused(&good, "light field", "quilt");
    field = (struct tia_light_field){.kind = TIA_LENTICULAR, .lens = {.pitch = TIA_PITCH_MAX}};
    refused(&good, "light field", "lens.pitch");
    field = (struct tia_light_field){.kind = TIA_PROJECTOR};
    refused(&good, "light field", "projector.distance");
    good.field = NULL; /* a ball in reach of the eye, but not of the whole line */
    good.spheres = &far;
    good.materials = &material;
    good.sphere_count = good.material_count = 1;
    CHECK_EQ(tia_scene_check(&good, NULL), TIA_OK);
    good.camera.line = 10000 * ONE;
    refused(&good, "sphere", "centre");
}

int main(void)
{
    RUN(views_stand_evenly);
    RUN(a_place_moves_the_eye_and_not_the_screen);
    RUN(an_oblique_place_is_rounded_once);
    RUN(projectors_aim_at_the_line);
    RUN(phases_at_their_limits);
    RUN(what_is_refused);
    return check_status();
}
