/* Scenes with curved objects under techniques for shadows: rays find the objects that have no faces. All pictures are
 * compared with those of the tracer, which does not rasterise. */
#include <stdlib.h>

#include <tia/bvh.h>
#include <tia/debug.h>

#include "check.h"
#include "flat/curved_places.h"
#include "shadow_world.h"

enum { WIDTH = 128, HEIGHT = 96, PIXELS = WIDTH * HEIGHT, MOST = 16 * PIXELS };

/* ---- pictures ---- */

struct picture {
    uint32_t object[MOST], hash[MOST];
    tia_rgb565 pixels[MOST];
};

static struct picture one, other;

/* The techniques with identical results. */
static const enum tia_shadows exact[4] = {TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL, TIA_SHADOWS_RAYS,
                                          TIA_SHADOWS_MAP_EXACT};

/* Draws tile by tile, the last one first. */
static void draw_sized(const struct tia_scene *scene, int width, int height, int tile_width, int tile_height,
                       struct picture *out)
{
    const struct tia_tile all = {0, 0, (uint16_t)width, (uint16_t)height};
    size_t view_size = tia_view_size(scene, scene->light_count), size = tia_hits_size(scene, all);
    void *memory = malloc(view_size), *hit_memory = malloc(size);
    static uint32_t hash[MOST];
    const struct tia_options options = {.debug = &(struct tia_debug){.path_hash = hash}};
    struct tia_view *view = NULL;
    struct tia_hits *hits;

    CHECK_EQ(
        tia_view_init(&view, memory, view_size, scene, scene->light_count, (unsigned)width, (unsigned)height, NULL),
        TIA_OK);
    CHECK(!tia_hits_init(&hits, hit_memory, size, view, all));
    memset(out, 0, sizeof *out);
    for (int y = (height - 1) / tile_height * tile_height; y >= 0; y -= tile_height)
        for (int x = (width - 1) / tile_width * tile_width; x >= 0; x -= tile_width) {
            int right = x + tile_width < width ? x + tile_width : width;
            int bottom = y + tile_height < height ? y + tile_height : height;
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(right - x), (uint16_t)(bottom - y)};
            struct tia_surface surface = {.pixels = out->pixels + y * width + x, .step = 2, .pitch = 2 * width};

            CHECK(!tia_view_draw(view, hits, tile, &surface, &options));
            for (int i = 0; i < (right - x) * (bottom - y); i++)
                out->hash[(y + i / tile.width) * width + x + i % tile.width] = hash[i];
        }
    for (int i = 0; i < width * height; i++)
        out->object[i] = tia_hits_object(hits, (unsigned)(i % width), (unsigned)(i / width));
    free(memory);
    free(hit_memory);
}

static void draw(const struct tia_scene *scene, int tile_width, int tile_height, struct picture *out)
{
    draw_sized(scene, WIDTH, HEIGHT, tile_width, tile_height, out);
}

/* ---- places ---- */

/* Checks each curved object in a scene of its own: no pixel outside its place shows it. Returns the number of pixels
 * that show an object. */
static unsigned check_places(const struct world *w)
{
    static struct tia_curved_place places[SPHERES + SHAPES];
    struct tia_eye eye;
    unsigned seen = 0;
    uint32_t count = tia_curved_count(&w->scene);

    tia_eye_init(&eye, &w->scene, WIDTH, HEIGHT);
    tia_curved_find(places, &w->scene, &eye, WIDTH, HEIGHT);
    for (uint32_t n = 0; n < count; n++) {
        struct tia_scene alone = w->scene;
        bool sphere = places[n].object < SPHERES;

        alone.sphere_count = sphere;
        alone.shape_count = !sphere;
        alone.spheres += sphere ? places[n].object : 0;
        alone.shapes += sphere ? 0 : places[n].object - SPHERES;
        alone.light_count = 0;
        draw(&alone, WIDTH, HEIGHT, &one);
        for (int i = 0; i < PIXELS; i++) {
            int x = i % WIDTH, y = i / WIDTH;
            seen += one.object[i] != TIA_NO_OBJECT;
            CHECK_MSG(one.object[i] == TIA_NO_OBJECT ||
                          (x >= places[n].x0 && x < places[n].x1 && y >= places[n].y0 && y < places[n].y1),
                      "object %u is at %d, %d", places[n].object, x, y);
        }
    }
    return seen;
}

TEST(places_hold_what_is_seen)
{
    struct world w;

    for (int i = 0; i < 12; i++) {
        struct tia_camera camera = make_camera((enum tia_projection)(i % 3));
        if (i % 4 == 3)
            camera.eye = somewhere(2);
        make_world(&w, camera);
        CHECK_EQ(tia_curved_count(&w.scene), SPHERES + 3 + 3 + 3 + 3 + 2); /* sphere, disc, cylinder, cone, grid */
        CHECK(check_places(&w) > 1000);
    }
}

/* A ball of radius 1 at the distance 10: its box reaches at most 50/9 pixels from the middle of 100, so its place, with
 * one more pixel on either side, is 43 to 56. When the eye is inside the box, the place is the whole picture. */
TEST(places_are_small)
{
    static const struct tia_sphere ball = {.radius = Q(1)};
    struct tia_scene scene = {.spheres = &ball, .sphere_count = 1, .materials = &white, .material_count = 1};
    struct tia_curved_place place;
    struct tia_eye eye;

    scene.camera = (struct tia_camera){.eye = {0, 0, Q(10)}, .fov = Q(90)};
    tia_eye_init(&eye, &scene, 100, 100);
    tia_curved_find(&place, &scene, &eye, 100, 100);
    CHECK(place.object == 0 && place.x0 == 43 && place.x1 == 57 && place.y0 == 43 && place.y1 == 57);
    scene.camera.eye = (struct tia_vec3){Q(3), Q(-4), Q(10)};
    tia_eye_init(&eye, &scene, 100, 100);
    tia_curved_find(&place, &scene, &eye, 100, 100); /* x from -4/9 to -2/11, y from 3/11 to 5/9 */
    CHECK(place.x0 == 26 && place.x1 == 42 && place.y0 == 21 && place.y1 == 38);
    scene.camera.eye.z = Q(0.5);
    tia_eye_init(&eye, &scene, 100, 100);
    tia_curved_find(&place, &scene, &eye, 100, 100);
    CHECK(place.x0 == 0 && place.x1 == 100 && place.y0 == 0 && place.y1 == 100);
}

/* ---- against the tracer ---- */

struct difference {
    unsigned object, path;
};

static void compare(struct difference *d)
{
    for (int i = 0; i < PIXELS; i++) {
        d->object += one.object[i] != other.object[i];
        d->path += one.object[i] == other.object[i] && one.hash[i] != other.hash[i];
    }
}

/* The start of rays off a surface and the rounding of vertices matter at edges only: to the object in one pixel of
 * 10,000, to the light in one of 20,000. */
TEST(agrees_with_rays)
{
    struct difference d = {0, 0};
    struct world w;

    for (int i = 0; i < 12; i++) {
        make_world(&w, make_camera((enum tia_projection)(i % 3)));
        draw(&w.scene, WIDTH, HEIGHT, &one);
        w.scene.shadows = exact[i / 3 % 4];
        draw(&w.scene, WIDTH, HEIGHT, &other);
        compare(&d);
    }
    CHECK_MSG(d.object * 10000 <= 12 * PIXELS && d.path * 20000 <= 12 * PIXELS,
              "of %d pixels %u see another object, %u another light", 12 * PIXELS, d.object, d.path);
}

/* The techniques use the same sample points of an area light at every pixel: those that the tracer uses in every fourth
 * column of every fourth row. */
TEST(area_lights_agree_there)
{
    const struct tia_light area[2] = {{.kind = TIA_DISC_LIGHT,
                                       .centre = {Q(3), Q(7), Q(5)},
                                       .radius = Q(2),
                                       .direction = {TIA_Q30(0.3), TIA_Q30(-0.8), TIA_Q30(0.1)},
                                       .emission = {1 << 29, 1 << 29, 1 << 29},
                                       .samples = 23},
                                      {.kind = TIA_RECTANGLE_LIGHT,
                                       .centre = {Q(-3), Q(6), Q(2)},
                                       .side = {{Q(1), 0, Q(1)}, {Q(1), Q(1), 0}},
                                       .emission = {1 << 29, 1 << 29, 1 << 29}}};
    unsigned differ = 0, pixels = 0;
    struct world w;

    for (int i = 0; i < (int)check_count(4); i++) {
        make_world(&w, make_camera((enum tia_projection)(i % 3)));
        w.scene.lights = area;
        w.scene.light_count = 2;
        draw(&w.scene, WIDTH, HEIGHT, &one);
        w.scene.shadows = TIA_SHADOWS_ZFAIL;
        draw(&w.scene, WIDTH, HEIGHT, &other);
        for (int p = 0; p < PIXELS; p++)
            if (p % 4 == 0 && p / WIDTH % 4 == 0) {
                pixels++;
                differ += one.hash[p] != other.hash[p];
            }
    }
    CHECK_MSG(differ * 200 <= pixels, "%u of %u pixels, each with 39 rays to a light", differ, pixels);
}

/* Tiles and hierarchies change no bit. */
TEST(tiles_and_hierarchies_change_nothing)
{
    struct world w;

    for (int i = 0; i < 6; i++) {
        const struct tia_bvh *bvh = NULL;
        make_world(&w, make_camera((enum tia_projection)(i % 3)));
        w.scene.shadows = TIA_SHADOWS_ZFAIL;
        draw(&w.scene, WIDTH, HEIGHT, &one);
        draw(&w.scene, 7 + i, 5, &other);
        CHECK(!memcmp(&one, &other, sizeof one));
        size_t size = tia_bvh_size(&w.scene);
        void *memory = malloc(size);
        CHECK(!tia_bvh_build(&bvh, memory, size, NULL, &w.scene, NULL));
        w.scene.bvh = bvh;
        draw(&w.scene, 64, 40, &other);
        CHECK(!memcmp(&one, &other, sizeof one));
        free(memory);
    }
}

/* ---- several samples a pixel ---- */

static int channel(tia_rgb565 pixel, int c)
{
    return c == 0 ? pixel >> 11 : c == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* Checks a mean. Sample i + n j of a pixel is a pixel of the picture that is n^2 times as large: in column n^2 x + n i
 * + j, row n^2 y + n j + n - 1 - i, see camera.h. So the pixel is the mean of those pixels, but for the rounding of
 * each. */
static void check_mean(const struct tia_scene *scene, int n, int width, int height)
{
    struct tia_scene sampled = *scene;
    int large = n * n * width;

    sampled.camera.samples = (uint32_t)(n * n);
    draw_sized(scene, large, n * n * height, large, 64, &one);
    draw_sized(&sampled, width, height, 5, 7, &other);
    for (int p = 0; p < width * height; p++) {
        int sum[3] = {0, 0, 0}, corner = n * n * (p / width) * large + n * n * (p % width);
        for (int i = 0; i < n * n; i++)
            for (int c = 0; c < 3; c++)
                sum[c] += channel(one.pixels[corner + (n * (i / n) + n - 1 - i % n) * large + n * (i % n) + i / n], c);
        for (int c = 0; c < 3; c++)
            CHECK_MSG(abs(sum[c] - n * n * channel(other.pixels[p], c)) <= n * n, "pixel %d: %d for %d/%d", p,
                      channel(other.pixels[p], c), sum[c], n * n);
        CHECK_EQ(other.object[p], one.object[corner + (n - 1) * large]);
    }
}

TEST(samples_are_averaged)
{
    struct tia_light all[4] = {lights[0], lights[1], lights[2]};
    struct world w;

    all[3] = (struct tia_light){.kind = TIA_DISC_LIGHT,
                                .centre = {Q(1), Q(6), Q(3)},
                                .radius = Q(1),
                                .direction = {0, TIA_Q30(-1), 0},
                                .emission = {1 << 28, 1 << 28, 1 << 28},
                                .samples = 5};
    for (int i = 0; i < (int)check_count(6); i++) {
        make_world(&w, make_camera((enum tia_projection)(i % 3)));
        w.scene.lights = all;
        w.scene.light_count = 4;
        w.scene.shadows = exact[i % 4];
        w.scene.tessellated = i > 2 ? Q(0.02) : 0;
        check_mean(&w.scene, i % 4 == 3 ? 4 : 2, i % 4 == 3 ? 12 : 24, i % 4 == 3 ? 9 : 18);
    }
}

/* ---- flat faces in place of curved surfaces ---- */

/* Returns the number of pixels that show a different object or light than rays do, when curved surfaces are faces with
 * this error. All techniques must give the same pixels. */
static unsigned count_differences(double error)
{
    struct difference d = {0, 0};
    struct world w;

    random_state = 5;
    for (int i = 0; i < (int)check_count(3); i++) {
        make_world(&w, make_camera((enum tia_projection)(i % 3)));
        draw(&w.scene, WIDTH, HEIGHT, &one);
        w.scene.tessellated = (tia_q16)(error * 65536);
        w.scene.shadows = exact[0];
        draw(&w.scene, 50, 31, &other);
        compare(&d);
        for (int n = 1; n < 4; n++) {
            w.scene.shadows = exact[n];
            draw(&w.scene, WIDTH, HEIGHT, &one);
            CHECK(!memcmp(&one, &other, sizeof one));
        }
    }
    return d.object + d.path;
}

TEST(tessellation_converges)
{
    unsigned coarse = count_differences(0.04), fine = count_differences(0.008), finest = count_differences(0.0016);

    CHECK_MSG(coarse > 2 * fine && fine > 2 * finest, "%u, %u and %u of %d pixels differ", coarse, fine, finest,
              (int)check_count(3) * PIXELS);
}

int main(void)
{
    RUN(places_hold_what_is_seen);
    RUN(places_are_small);
    RUN_LONG(agrees_with_rays);
    RUN_LONG(area_lights_agree_there);
    RUN(tiles_and_hierarchies_change_nothing);
    RUN(samples_are_averaged);
    RUN_LONG(tessellation_converges);
    return check_status();
}
