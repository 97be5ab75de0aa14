/* The range of lights under techniques for shadows, the error for a light beyond it, and new hits where a light needs
 * vertices with other fraction bits. */
#include <stdlib.h>
#include <string.h>

#include <tia/debug.h>
#include <tia/render.h>
#include <tia/shadow.h>

#include "check.h"

#define Q(x) TIA_Q16(x)

static const struct tia_material material[] = {{.colour = TIA_RGB(0.5, 0.5, 0.5)}};
static const struct tia_shape shapes[] = {
    {.kind = TIA_BOX, .box = {TIA_VEC3(-200, -1, -200), TIA_VEC3(200, 0, 200)}},
    {.kind = TIA_BOX, .box = {TIA_VEC3(-1, 0, -1), TIA_VEC3(1, 2, 1)}},
    {.kind = TIA_SPHERE, .sphere = {TIA_VEC3(2, 1, 1), Q(0.7)}},
};

static struct tia_light point_at(double x, double y, double z)
{
    return (struct tia_light){.centre = {Q(x), Q(y), Q(z)}, .emission = TIA_RGB(1, 1, 1)};
}

static struct tia_scene yard(const struct tia_light *lights, enum tia_shadows technique)
{
    return (struct tia_scene){
        .camera = {.eye = TIA_VEC3(3, 4, 9), .reference = TIA_VEC3(0, 1, 0), .up = TIA_VEC3(0, 1, 0), .fov = Q(40)},
        .materials = material,
        .shapes = shapes,
        .lights = lights,
        .material_count = 1,
        .shape_count = 3,
        .light_count = 1,
        .shadows = technique,
        .shadow_map = {.size = TIA_MAP_SIZE_MIN}};
}

/* ---- out of range ---- */

struct drawn {
    void *memory[2];
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_tile all;
};

static int open_view(struct drawn *d, const struct tia_scene *s, unsigned width, unsigned height)
{
    size_t size = tia_view_size(s, 2);

    d->all = (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height};
    d->memory[0] = malloc(size);
    d->memory[1] = NULL;
    d->view = NULL;
    return tia_view_init(&d->view, d->memory[0], size, s, 2, width, height, NULL);
}

static void open_hits(struct drawn *d, const struct tia_scene *s)
{
    size_t size = tia_hits_size(s, d->all);

    d->memory[1] = malloc(size);
    CHECK_EQ(tia_hits_init(&d->hits, d->memory[1], size, d->view, d->all), TIA_OK);
}

static void light_all(const struct drawn *d, tia_rgb565 *pixels)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * d->all.width};

    CHECK_EQ(tia_view_light(d->view, d->hits, d->all, &surface, NULL), TIA_OK);
}

static void close_view(struct drawn *d)
{
    free(d->memory[0]);
    free(d->memory[1]);
}

/* Checks the scene with this light, and a view of the scene that gets the light later, by a key. refused: 0, or n if
 * the light must be within 2^n. */
static void check_light(struct tia_scene s, const struct tia_light *light, unsigned width, unsigned height,
                        unsigned refused)
{
    const struct tia_light near = point_at(0, 9, 0), lights[2] = {near, *light};
    unsigned range = 0;
    const struct tia_binding key = {.key = 'x', .light = 1, .state = *light};
    struct drawn d;

    s.lights = lights;
    s.light_count = 2;
    CHECK_EQ(open_view(&d, &s, width, height), refused ? TIA_ERR_RANGE : TIA_OK);
    CHECK_EQ(tia_shadow_light_too_far(&s, lights, 2, width, height, &range), refused ? 1 : TIA_NO_OBJECT);
    CHECK(!refused || range == refused);
    close_view(&d);
    s.light_count = 1;
    s.bindings = &key;
    s.binding_count = 1;
    CHECK_EQ(open_view(&d, &s, width, height), TIA_OK);
    CHECK_EQ(tia_view_set_lights(d.view, lights, 2), refused ? TIA_ERR_RANGE : TIA_OK);
    close_view(&d);
}

/* For a light at p the coordinate x = p 2 near/(right - left), here 1024 p, must be below 2^24. */
TEST(perspective_lights_are_in_reach_up_to_2_24)
{
    const struct tia_light in = point_at(16383.9, 5, 0), out = point_at(16384, 5, 0);
    struct tia_light bright[2] = {in, in};

    for (enum tia_shadows technique = TIA_SHADOWS_RAYS; technique <= TIA_SHADOWS_ZPASS_PLAIN; technique++) {
        struct tia_scene s = yard(NULL, technique);
        s.camera =
            (struct tia_camera){.projection = TIA_FRUSTUM, .window = {-64, 64, -64, 64, Q(1)}}; /* a window of
                                                                                                   -2^-10..2^-10 */
        check_light(s, &in, 64, 48, 0);
        check_light(s, &out, 64, 48, 24);
        bright[0].kind = TIA_DISC_LIGHT; /* the light's edge counts */
        bright[0].direction = (struct tia_dir3){0, TIA_Q30(-1), 0};
        bright[0].radius = Q(1);
        bright[0].samples = 4;
        bright[1] = bright[0];
        bright[1].centre.x = Q(16382);
        check_light(s, &bright[0], 64, 48, 24);
        check_light(s, &bright[1], 64, 48, 0);
    }
}

/* Lights behind the eye have the same limit; lights without a position have none. */
TEST(only_places_are_too_far)
{
    struct tia_scene s = yard(NULL, TIA_SHADOWS_ZFAIL);
    struct tia_light sun = point_at(20000, 0, 0), sky = point_at(20000, 0, 0), behind = point_at(-16384, 0, 20000);

    s.camera = (struct tia_camera){.projection = TIA_FRUSTUM, .window = {-64, 64, -64, 64, Q(1)}};
    sun.kind = TIA_DIRECTIONAL_LIGHT;
    sun.direction = (struct tia_dir3){TIA_Q30(-1), 0, 0};
    sky.kind = TIA_AMBIENT_LIGHT;
    check_light(s, &sun, 64, 48, 0);
    check_light(s, &sky, 64, 48, 0);
    check_light(s, &behind, 64, 48, 24);
    s.shadows = TIA_SHADOWS_TRACED;
    check_light(s, &behind, 64, 48, 0);
}

/* The window is -1/64..1/64, so x is 64 p for a light at p. The limit is 2^20, or less where rounding would move
 * vertices by more than half a pixel: 2^19 with 1920 pixels in a row, 2^17 with 8192. The faces reach 200 * 64 < 2^14,
 * so only lights from 2^30 on are directions. */
TEST(orthographic_lights_are_in_reach_where_vertices_are_fine_enough)
{
    const struct tia_light in[3] = {point_at(16383, 5, 0), point_at(8191, 5, 0), point_at(2047, 5, 0)};
    const struct tia_light out[3] = {point_at(16384, 5, 0), point_at(8192, 5, 0), point_at(2048, 5, 0)};
    static const unsigned width[3] = {64, 1920, 8192};
    struct tia_scene s = yard(NULL, TIA_SHADOWS_RAYS);

    s.camera = (struct tia_camera){.projection = TIA_ORTHOGRAPHIC, .window = {-1024, 1024, -1024, 1024, 0}};
    for (int i = 0; i < 3; i++) {
        check_light(s, &in[i], width[i], 8, 0);
        check_light(s, &out[i], width[i], 8, (unsigned)(20 - i - (i == 2)));
    }
}

/* The window is -1/128..1/128 and the image has at most 2^6 pixels in a row, so b of reach.c is 6. Faces within 1/4, at
 * most 2^6 from the eye, make r 6: lights are directions from 2^22 on, about 2^15 away. Faces within 2 make r 9, and
 * lights are directions from 2^(2 * 9 + 2 + 6) = 2^26 on. */
TEST(orthographic_lights_are_directions_far_beyond_all_faces)
{
    static const struct tia_shape small = {.kind = TIA_BOX,
                                           .box = {TIA_VEC3(-0.25, -0.25, -0.25), TIA_VEC3(0.25, 0.25, 0.25)}};
    const struct tia_light far = point_at(30000, 9000, 0), farther = point_at(16000, 0, 0);
    struct tia_scene s = yard(NULL, TIA_SHADOWS_RAYS);

    s.shape_count = 1;
    s.camera = (struct tia_camera){.projection = TIA_ORTHOGRAPHIC, .window = {-512, 512, -512, 512, 0}};
    s.shapes = &small;
    check_light(s, &far, 64, 48, 0);
    check_light(s, &farther, 64, 48, 20); /* 2^21: neither a position nor a direction */
    s.shapes = &shapes[1];
    check_light(s, &far, 64, 48, 20);
}

/* ---- hits ---- */

#define WIDTH 64
#define HEIGHT 48

static void draw_anew(const struct tia_scene *s, const struct tia_light *light, tia_rgb565 *pixels)
{
    struct drawn d;

    CHECK_EQ(open_view(&d, s, WIDTH, HEIGHT), TIA_OK);
    CHECK_EQ(tia_view_set_lights(d.view, light, 1), TIA_OK);
    open_hits(&d, s);
    CHECK_EQ(tia_view_trace(d.view, d.hits, d.all), TIA_OK);
    light_all(&d, pixels);
    close_view(&d);
}

/* Compares a picture with traced rays, which differ only where an edge of a shape or shadow almost passes through a
 * pixel's centre. */
static void compare_traced(struct tia_scene s, const struct tia_light *light, const tia_rgb565 *pixels)
{
    static tia_rgb565 traced[WIDTH * HEIGHT];
    enum tia_shadows technique = s.shadows;
    int differ = 0;

    if (technique == TIA_SHADOWS_MAP || technique == TIA_SHADOWS_ZPASS_PLAIN)
        return; /* not exact */
    s.shadows = TIA_SHADOWS_TRACED;
    draw_anew(&s, light, traced);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        differ += traced[i] != pixels[i];
    CHECK_MSG(differ <= WIDTH * HEIGHT / 1000, "technique %d: %d pixels are not as traced", (int)technique, differ);
}

static void check_moved(enum tia_shadows technique, uint32_t samples, const struct tia_light *to)
{
    static tia_rgb565 got[WIDTH * HEIGHT], want[WIDTH * HEIGHT];
    const struct tia_light from = point_at(4, 7, 3);
    struct tia_scene s = yard(&from, technique);
    struct drawn moved;

    s.camera.samples = samples;
    CHECK_EQ(open_view(&moved, &s, WIDTH, HEIGHT), TIA_OK);
    open_hits(&moved, &s);
    CHECK_EQ(tia_view_trace(moved.view, moved.hits, moved.all), TIA_OK);
    for (int i = 0; i < 3; i++) { /* there and back: earlier frames must not matter */
        const struct tia_light *now = i % 2 ? &from : to;
        CHECK_EQ(tia_view_set_lights(moved.view, now, 1), TIA_OK);
        light_all(&moved, got);
        draw_anew(&s, now, want);
        CHECK_MSG(!memcmp(got, want, sizeof got), "technique %d, picture %d", (int)technique, i);
        compare_traced(s, now, got);
    }
    close_view(&moved);
}

/* Faces reach 2^9 from the eye, so that vertices need other fraction bits for a light much farther away than before. */
TEST(hits_are_traced_again_where_a_light_needs_other_vertices)
{
    const struct tia_light far[2] = {point_at(3000, 5000, -1000), point_at(-20000, 20000, 1000)};

    for (enum tia_shadows technique = TIA_SHADOWS_RAYS; technique <= TIA_SHADOWS_ZPASS_PLAIN; technique++)
        for (int i = 0; i < 2; i++)
            check_moved(technique, technique == TIA_SHADOWS_ZFAIL ? 4 : 1, &far[i]);
}

/* A refused light leaves the old lights in place. */
TEST(the_old_lights_stay)
{
    static tia_rgb565 got[WIDTH * HEIGHT], want[WIDTH * HEIGHT];
    const struct tia_light from = point_at(4, 7, 3), out = point_at(20000, 5, 0);
    struct tia_scene s = yard(&from, TIA_SHADOWS_ZPASS);
    struct drawn d;

    s.camera =
        (struct tia_camera){.projection = TIA_FRUSTUM, .eye = TIA_VEC3(0, 1, 6000), .window = {-64, 64, -64, 64, Q(1)}};
    CHECK_EQ(open_view(&d, &s, WIDTH, HEIGHT), TIA_OK);
    open_hits(&d, &s);
    CHECK_EQ(tia_view_trace(d.view, d.hits, d.all), TIA_OK);
    light_all(&d, want);
    CHECK_EQ(tia_view_set_lights(d.view, &out, 1), TIA_ERR_RANGE);
    light_all(&d, got);
    CHECK(!memcmp(got, want, sizeof got));
    close_view(&d);
}

int main(void)
{
    RUN(perspective_lights_are_in_reach_up_to_2_24);
    RUN(only_places_are_too_far);
    RUN(orthographic_lights_are_in_reach_where_vertices_are_fine_enough);
    RUN(orthographic_lights_are_directions_far_beyond_all_faces);
    RUN(hits_are_traced_again_where_a_light_needs_other_vertices);
    RUN(the_old_lights_stay);
    return check_status();
}
