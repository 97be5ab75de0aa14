/* The renderer's calls one by one: their refusals, which change nothing, and a pixel computed by hand. */
#include <math.h>
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "check.h"

enum { W = 40, H = 30 };

static uint64_t view_memory[1000], hits_memory[W * H + 100];
static tia_rgb565 before[W * H], after[W * H];

static const struct tia_tile frame = {0, 0, W, H};
static const struct tia_light light = {TIA_VEC3(-20, 20, -20), TIA_Q16(3), TIA_RGB(1, 1, 1)};

static int init(struct tia_view **view, const struct tia_scene *scene, uint32_t lights, unsigned width, unsigned height)
{
    return tia_view_init(view, view_memory, sizeof view_memory, scene, lights, width, height, NULL);
}

static struct tia_view *thesis_view(uint32_t lights)
{
    struct tia_view *view = NULL;

    CHECK_EQ(init(&view, &tia_thesis_scene, lights, W, H), TIA_OK);
    return view;
}

static struct tia_hits *hits_of(const struct tia_view *view, struct tia_tile area)
{
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, area), TIA_OK);
    return hits;
}

static void render(const struct tia_view *view, struct tia_hits *hits, tia_rgb565 *out)
{
    struct tia_surface surface = {.pixels = out, .step = 2, .pitch = 2 * W};

    CHECK_EQ(tia_view_draw(view, hits, frame, &surface, NULL), TIA_OK);
}

TEST(sizes)
{
    static const struct {
        unsigned width, height;
        int status;
    } sizes[] = {
        {1, 1, TIA_OK},
        {8192, 8192, TIA_OK},
        {8192, 1, TIA_OK},
        {1, 8192, TIA_OK},
        {0, 1, TIA_ERR_ARGUMENT},
        {1, 0, TIA_ERR_ARGUMENT},
        {8193, 1, TIA_ERR_ARGUMENT},
        {1, 8193, TIA_ERR_ARGUMENT},
        {UINT32_MAX, 1, TIA_ERR_ARGUMENT},
        {65537, 65537, TIA_ERR_ARGUMENT},
    };

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct tia_view *view = NULL;
        CHECK_EQ(init(&view, &tia_thesis_scene, 1, sizes[i].width, sizes[i].height), sizes[i].status);
        CHECK_EQ(view != NULL, !sizes[i].status);
    }
}

/* A view needs exactly the stated memory, and not a byte more. */
TEST(memory_of_a_view)
{
    for (uint32_t lights = 0; lights < 5; lights++) {
        size_t size = tia_view_size(&tia_thesis_scene, lights);
        const unsigned char *bytes = (const unsigned char *)view_memory;
        struct tia_view *view = NULL;
        memset(view_memory, 0xa5, sizeof view_memory);
        CHECK_EQ(tia_view_init(&view, view_memory, size - 1, &tia_thesis_scene, lights, W, H, NULL), TIA_ERR_MEMORY);
        CHECK_EQ(tia_view_init(&view, view_memory, 0, &tia_thesis_scene, lights, W, H, NULL), TIA_ERR_MEMORY);
        CHECK(!view && bytes[0] == 0xa5);
        CHECK_EQ(tia_view_init(&view, view_memory, size, &tia_thesis_scene, lights, W, H, NULL), TIA_OK);
        for (uint32_t n = 0; n < lights; n++) {
            struct tia_light all[5] = {light, light, light, light, light};
            CHECK_EQ(tia_view_set_lights(view, all, n + 1), TIA_OK);
        }
        for (size_t i = size; i < sizeof view_memory; i++)
            CHECK_EQ(bytes[i], 0xa5);
    }
    CHECK(tia_view_size(&tia_thesis_scene, UINT32_MAX) >= UINT32_MAX);
}

TEST(memory_of_hits)
{
    const struct tia_tile area = {5, 7, 7, 8}, none = {5, 7, 0, 8}, flat = {5, 7, 7, 0};
    size_t size = tia_hits_size(&tia_thesis_scene, area);
    const unsigned char *bytes = (const unsigned char *)hits_memory;
    struct tia_view *view = thesis_view(0);
    struct tia_hits *hits = NULL;

    memset(hits_memory, 0xa5, sizeof hits_memory);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, size - 1, view, area), TIA_ERR_MEMORY);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, none), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, flat), TIA_ERR_ARGUMENT);
    CHECK(!hits && bytes[0] == 0xa5);
    CHECK(tia_hits_size(&tia_thesis_scene, (struct tia_tile){0, 0, 65535, 65535}) >=
          UINT32_MAX); /* more than 32 bits can hold */
    CHECK_EQ(tia_hits_init(&hits, hits_memory, size, view, area), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, area), TIA_OK);
    for (size_t i = size; i < sizeof hits_memory; i++)
        CHECK_EQ(bytes[i], 0xa5);
}

TEST(scenes_that_are_refused)
{
    const struct tia_light far = {TIA_VEC3(32000, 32000, 0), 0, TIA_RGB(1, 1, 1)};
    struct tia_scene scene = tia_thesis_scene;
    struct tia_view *view = NULL;

    scene.camera.fov = TIA_FOV_MAX + 1;
    CHECK_EQ(init(&view, &scene, 1, W, H), TIA_ERR_RANGE);
    scene = tia_thesis_scene;
    scene.lights = &far;
    scene.light_count = 1;
    CHECK_EQ(init(&view, &scene, 1, W, H), TIA_ERR_RANGE);
    scene.lights = &light;
    CHECK_EQ(init(&view, &scene, 0, W, H), TIA_ERR_ARGUMENT); /* no room for the light */
    CHECK(!view);
    CHECK_EQ(init(&view, &scene, 1, W, H), TIA_OK);
}

/* Refused lights, too many or out of range, leave the old ones. */
TEST(lights_that_are_refused)
{
    struct tia_light bad[3] = {light, light, light};
    struct tia_view *view = thesis_view(2);
    struct tia_hits *hits = hits_of(view, frame);

    CHECK_EQ(tia_view_set_lights(view, &light, 1), TIA_OK);
    render(view, hits, before);
    bad[0].centre.x = bad[1].centre.x = -bad[0].centre.x;
    CHECK(tia_view_set_lights(view, bad, 3) < 0);
    CHECK(tia_view_set_lights(view, bad, UINT32_MAX) < 0);
    bad[1].emission.g = -1;
    CHECK_EQ(tia_view_set_lights(view, bad, 2), TIA_ERR_RANGE);
    bad[1] = bad[0];
    bad[0].radius = 1;
    CHECK_EQ(tia_view_set_lights(view, bad, 2), TIA_ERR_RANGE);
    render(view, hits, after);
    CHECK(!memcmp(before, after, sizeof before));
    CHECK_EQ(tia_view_set_lights(view, bad + 1, 1), TIA_OK);
    render(view, hits, after);
    CHECK(memcmp(before, after, sizeof before));
}

/* Lights fade in the unit of the view's scene: unit_bits + scale_bits must be in 0..30. */
TEST(units_of_lights)
{
    struct tia_light fading = light;
    struct tia_scene scene = tia_thesis_scene;
    struct tia_view *view = NULL;

    fading.quadratic = TIA_Q16(0.001);
    scene.lights = &fading; /* rays draw it, not spans */
    scene.light_count = 1;
    for (int scale = -3; scale <= 3; scale += 6) {
        scene.scale_bits = (int8_t)scale;
        fading.unit_bits = (int8_t)-scale;
        size_t size = tia_view_size(&scene, 1);
        void *memory = malloc(size);
        CHECK_EQ(tia_view_init(&view, memory, size, &scene, 1, W, H, NULL), TIA_OK);
        CHECK_EQ(tia_view_set_lights(view, &fading, 1), TIA_OK);
        fading.unit_bits = (int8_t)(-scale - 1);
        CHECK_EQ(tia_view_set_lights(view, &fading, 1), TIA_ERR_RANGE);
        free(memory);
    }
}

/* Lights are refused, too, when they need more shadow maps than the scene's: six for a point light, or a second one. */
TEST(lights_without_room_for_maps)
{
    const struct tia_light spot = {.kind = TIA_SPOT_LIGHT,
                                   .centre = TIA_VEC3(-20, 20, -20),
                                   .emission = TIA_RGB(1, 1, 1),
                                   .direction = {TIA_Q30(0.7), TIA_Q30(-0.7), 0},
                                   .inner = TIA_Q16(40),
                                   .outer = TIA_Q16(50)};
    struct tia_light two[2] = {spot, spot};
    struct tia_scene scene = tia_thesis_scene;
    struct tia_view *view = NULL;

    scene.lights = &spot;
    scene.light_count = 1;
    scene.binding_count = 0;
    scene.shadows = TIA_SHADOWS_MAP;
    scene.shadow_map.size = 64;
    size_t size = tia_view_size(&scene, 2), hits_size = tia_hits_size(&scene, frame);
    void *memory = malloc(size), *mapped = malloc(hits_size);
    struct tia_hits *hits = NULL;
    CHECK_EQ(tia_view_init(&view, memory, size, &scene, 2, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, mapped, hits_size, view, frame), TIA_OK);
    render(view, hits, before);
    CHECK_EQ(tia_view_set_lights(view, &light, 1), TIA_ERR_MEMORY);
    CHECK_EQ(tia_view_set_lights(view, two, 2), TIA_ERR_MEMORY);
    render(view, hits, after);
    CHECK(!memcmp(before, after, sizeof before));
    two[0].centre.x = TIA_Q16(10);
    CHECK_EQ(tia_view_set_lights(view, two, 1), TIA_OK);
    render(view, hits, after);
    CHECK(memcmp(before, after, sizeof before));
    free(memory);
    free(mapped);
}

/* Tiles that are empty or leave the image or the hits are refused by all three functions, and no pixel is drawn. */
TEST(tiles_that_are_refused)
{
    static const struct tia_tile bad[] = {
        {0, 0, 0, 1},         {0, 0, 1, 0},         {4, 5, 10, 10},         {5, 4, 10, 10},
        {5, 5, 31, 10},       {5, 5, 10, 21},       {35, 25, 1, 1},         {34, 24, 2, 1},
        {65535, 5, 65535, 1}, {5, 65535, 1, 65535}, {36, 26, 65535, 65535},
    };
    const struct tia_tile area = {5, 5, 30, 20}, beyond = {30, 20, 20, 20}, corner = {39, 29, 1, 1};
    struct tia_surface surface = {.pixels = after, .step = 2, .pitch = 2 * W};
    struct tia_view *view = thesis_view(0);
    struct tia_hits *hits = hits_of(view, frame);

    render(view, hits, before);
    memcpy(after, before, sizeof after);
    hits = hits_of(view, area);
    CHECK_EQ(tia_view_trace(view, hits, area), TIA_OK);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK_EQ(tia_view_trace(view, hits, bad[i]), TIA_ERR_ARGUMENT);
        CHECK_EQ(tia_view_light(view, hits, bad[i], &surface, NULL), TIA_ERR_ARGUMENT);
        CHECK_EQ(tia_view_draw(view, hits, bad[i], &surface, NULL), TIA_ERR_ARGUMENT);
    }
    surface.pixels = NULL;
    CHECK_EQ(tia_view_light(view, hits, area, &surface, NULL), TIA_ERR_ARGUMENT);
    surface.pixels = after;
    hits = hits_of(view, beyond); /* hits may cover more than the image */
    CHECK_EQ(tia_view_trace(view, hits, beyond), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_light(view, hits, beyond, &surface, NULL), TIA_ERR_ARGUMENT);
    CHECK(!memcmp(before, after, sizeof before));
    CHECK_EQ(tia_view_draw(view, hits, corner, &surface, NULL), TIA_OK);
    CHECK_EQ(after[0], before[W * H - 1]);
}

/* In the largest picture the corners and the middle are correct. */
TEST(the_largest_picture)
{
    static const struct {
        uint16_t x, y;
        uint32_t object;
    } pixels[] = {{0, 0, TIA_NO_OBJECT}, {8191, 0, TIA_NO_OBJECT}, {0, 8191, 0}, {8191, 8191, 0}, {4096, 4700, 1}};

    for (int i = 0; i < 5; i++) {
        struct tia_tile tile = {pixels[i].x, pixels[i].y, 1, 1};
        struct tia_view *view = NULL;
        CHECK_EQ(init(&view, &tia_thesis_scene, 0, 8192, 8192), TIA_OK);
        struct tia_hits *hits = hits_of(view, tile);
        CHECK_EQ(tia_view_trace(view, hits, tile), TIA_OK);
        CHECK_EQ(tia_hits_object(hits, tile.x, tile.y), pixels[i].object);
    }
}

/* ---- one pixel by hand: it sees a unit sphere at (0, 0, -10) in (0, 0, -9), where N = (0, 0, 1) ---- */

static const struct tia_material materials[] = {
    {TIA_RGB(0.5, 0.5, 0.75), TIA_RGB(0, 0, 0), TIA_RGB(0.0625, 0, 0)},
    {TIA_RGB(1, 1, 1), TIA_RGB(0.5, 0.25, 1), TIA_RGB(0, 0, 0)},
};
/* A sphere of glass halfway to light 2, and an opaque one halfway to light 3. */
static const struct tia_sphere spheres[] = {
    {TIA_VEC3(0, 0, -10), TIA_Q16(1), 0},
    {TIA_VEC3(0, 4, -5), TIA_Q16(0.5), 1},
    {TIA_VEC3(4, 0, -5), TIA_Q16(0.5), 0},
};
static const struct tia_light five[] = {
    {TIA_VEC3(0, 5, -1), 0, TIA_RGB(0.25, 0.5, 0.25)},       {TIA_VEC3(0, 0, -20), 0, TIA_RGB(1, 1, 1)},
    {TIA_VEC3(0, 8, -1), 0, TIA_RGB(0.5, 0.25, 0.125)},      {TIA_VEC3(8, 0, -1), 0, TIA_RGB(1, 1, 1)},
    {TIA_VEC3(0, 0, -5), TIA_Q16(1), TIA_RGB(0.25, 1.5, 0)},
};

static uint16_t pixel_colours[3];

static uint32_t one_pixel(uint32_t light_count, tia_rgb565 *colour)
{
    const struct tia_scene scene = {
        .camera = {TIA_VEC3(0, 0, 0), TIA_Q16(25)},
        .background = TIA_RGB(1, 0, 1),
        .materials = materials,
        .spheres = spheres,
        .lights = five,
        .material_count = 2,
        .sphere_count = 3,
        .light_count = light_count,
    };
    const struct tia_tile pixel = {0, 0, 1, 1};
    struct tia_surface surface = {.pixels = colour, .step = 2, .pitch = 2};
    struct tia_view *view = NULL;
    uint32_t path_hash = 0;
    struct tia_options options = {.colours = pixel_colours, .debug = &(struct tia_debug){.path_hash = &path_hash}};

    CHECK_EQ(init(&view, &scene, light_count, 1, 1), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits_of(view, pixel), pixel, &surface, &options), TIA_OK);
    options.dither = true;
    CHECK_EQ(tia_view_draw(view, hits_of(view, pixel), pixel, &surface, &options), TIA_ERR_UNSUPPORTED);
    struct tia_hits *hits = hits_of(view, pixel);
    CHECK_EQ(tia_view_trace(view, hits, pixel), TIA_OK);
    CHECK_EQ(tia_view_light(view, hits, pixel, &surface, &options), TIA_ERR_UNSUPPORTED);
    return path_hash;
}

static unsigned level(double c, int levels)
{
    return (unsigned)floor((c < 1 ? c : 1) * levels + 0.5);
}

/* Light 0 arrives with N.Ldir = 8/|(0, 5, 8)|, light 2 through the glass with 8/|(0, 8, 8)|; light 1
 * is behind, light 3 in shadow. */
TEST(a_pixel_by_hand)
{
    double cosine0 = 8 / sqrt(89), cosine2 = 8 / sqrt(128);
    double red = 0.5 * (cosine0 * 0.25 + cosine2 * 0.5 * 0.5) + 0.0625;
    double green = 0.5 * (cosine0 * 0.5 + cosine2 * 0.25 * 0.25);
    double blue = 0.75 * (cosine0 * 0.25 + cosine2 * 0.125);
    tia_rgb565 colour;

    CHECK_EQ(one_pixel(4, &colour), 1u << 0 | 1u << 2 | (2u + 1) * (1 + 1) << 16);
    CHECK_EQ(colour, level(red, 31) << 11 | level(green, 63) << 5 | level(blue, 31));
    CHECK_EQ(pixel_colours[0], level(red, 65535));
    CHECK_EQ(pixel_colours[1], level(green, 65535));
    CHECK_EQ(pixel_colours[2], level(blue, 65535));
    CHECK_EQ(one_pixel(1, &colour), 1);
    CHECK_EQ(one_pixel(0, &colour), 0);
    CHECK_EQ(colour, level(0.0625, 31) << 11);
}

/* Light 4 is in front of everything: the pixel shows its emission, clamped. */
TEST(a_light_in_sight)
{
    tia_rgb565 colour;

    CHECK_EQ(one_pixel(5, &colour), UINT32_C(0xffff0000) + 4);
    CHECK_EQ(colour, level(0.25, 31) << 11 | 63 << 5);
}

int main(void)
{
    RUN(sizes);
    RUN(memory_of_a_view);
    RUN(memory_of_hits);
    RUN(scenes_that_are_refused);
    RUN(lights_that_are_refused);
    RUN(units_of_lights);
    RUN(lights_without_room_for_maps);
    RUN(tiles_that_are_refused);
    RUN(the_largest_picture);
    RUN(a_pixel_by_hand);
    RUN(a_light_in_sight);
    return check_status();
}
