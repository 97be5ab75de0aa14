/* test_gl_picture.c - the built-in scene beside the same scene drawn by OpenGL (gl/gl_scene.c).
 *
 * The visible objects must agree to one pixel: where one picture shows an object, the other shows it there or in one of
 * the 8 pixels around; the same for lit regions, at the ball's terminator and around its shadow. Where they agree on
 * both, colours may differ by one level, GL's spheres being made of flat triangles; and in total less than one pixel in
 * a thousand may differ.
 *
 * Given a directory, the program leaves both pictures of each case there as PPM files.
 */
#include <stdlib.h>

#include "check.h"

#ifndef TIA_HAVE_OSMESA
TEST(gl_picture)
{
    SKIP("built without OSMesa and EGL (install libosmesa6-dev or libegl-dev)");
}
int main(void)
{
    RUN(gl_picture);
    return check_status();
}
#else
#include <tia/debug.h>
#include <tia/render.h>

#include "gl/gl_scene.h"
#include "ports.h"

static struct picture by_tia, by_gl;

/* Finds the light itself by its colour alone: full red, which no surface that it lights reaches. The surface behind it
 * may be lit or not. */
static void find_light(struct picture *picture)
{
    for (unsigned i = 0; i < picture->width * picture->height; i++) {
        picture->light[i] = picture->colour[i] == 0xf800;
        picture->lit[i] = picture->lit[i] && !picture->light[i];
    }
}

/* ---- drawing with tia ---- */

static void draw_by_tia(const struct tia_scene *scene, struct picture *picture)
{
    const struct tia_core *core = &tia_core_q16;
    struct tia_tile all = {0, 0, (uint16_t)picture->width, (uint16_t)picture->height};
    size_t view_size = core->view_size(core, scene, scene->light_count), hits_size = core->hits_size(core, scene, all);
    static uint32_t path_hash[PICTURE_PIXELS];
    struct tia_options options = {.debug = &(struct tia_debug){.path_hash = path_hash}};
    struct tia_surface surface = {.pixels = picture->colour, .step = 2, .pitch = 2 * (ptrdiff_t)picture->width};
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(
        core->view_init(core, &view, view_memory, view_size, scene, scene->light_count, all.width, all.height, NULL),
        TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, all), TIA_OK);
    CHECK_EQ(tia_view_light(view, hits, all, &surface, &options), TIA_OK);
    for (unsigned i = 0; i < picture->width * picture->height; i++) {
        uint32_t object = tia_hits_object(hits, i % picture->width, i / picture->width);
        picture->thing[i] = object == TIA_NO_OBJECT ? GL_SKY : (unsigned char)object;
        picture->lit[i] = path_hash[i] & 1;
    }
    free(view_memory);
    free(hits_memory);
}

/* ---- comparing ---- */

static bool near(const unsigned char *values, unsigned x, unsigned y, unsigned char value)
{
    for (unsigned v = y ? y - 1 : 0; v <= y + 1 && v < by_gl.height; v++) {
        for (unsigned u = x ? x - 1 : 0; u <= x + 1 && u < by_gl.width; u++)
            if (values[v * by_gl.width + u] == value)
                return true;
    }
    return false;
}

/* Compares the two sets of regions, which must agree within one pixel. */
static void compare_regions(const char *what, const unsigned char *tia, const unsigned char *other)
{
    for (unsigned y = 0; y < by_gl.height; y++) {
        for (unsigned x = 0; x < by_gl.width; x++) {
            unsigned i = y * by_gl.width + x;
            CHECK_MSG(near(other, x, y, tia[i]) && near(tia, x, y, other[i]), "%s at (%u, %u): %u, GL %u", what, x, y,
                      tia[i], other[i]);
        }
    }
}

static bool one_level(tia_rgb565 a, tia_rgb565 b)
{
    return abs((a >> 11) - (b >> 11)) <= 1 && abs((a >> 5 & 63) - (b >> 5 & 63)) <= 1 && abs((a & 31) - (b & 31)) <= 1;
}

static void compare_colours(void)
{
    unsigned different = 0;

    for (unsigned i = 0; i < by_gl.width * by_gl.height; i++) {
        bool same =
            by_tia.thing[i] == by_gl.thing[i] && by_tia.lit[i] == by_gl.lit[i] && by_tia.light[i] == by_gl.light[i];
        CHECK_MSG(!same || one_level(by_tia.colour[i], by_gl.colour[i]), "colour at (%u, %u): %04x, GL %04x",
                  i % by_gl.width, i / by_gl.width, by_tia.colour[i], by_gl.colour[i]);
        different += by_tia.colour[i] != by_gl.colour[i];
    }
    CHECK_MSG(different * 1000 < by_gl.width * by_gl.height, "%u pixels differ", different);
}

static bool seen(const unsigned char *values, unsigned char value)
{
    return memchr(values, value, (size_t)by_gl.width * by_gl.height);
}

/* Checks that the compared regions exist: both spheres and the sky; with a light, lit and unlit parts of both. */
static void check_contents(bool light)
{
    bool parts[2][2] = {{false, false}, {false, false}};

    for (unsigned i = 0; i < by_tia.width * by_tia.height; i++)
        if (by_tia.thing[i] != GL_SKY)
            parts[by_tia.thing[i]][by_tia.lit[i]] = true;
    CHECK(seen(by_tia.thing, GL_SKY));
    for (int i = 0; i < 2; i++)
        CHECK(parts[i][0] && parts[i][1] == light);
}

static const char *directory;

static void leave(const char *name, const struct picture *picture, const char *by)
{
    char path[512];
    FILE *file;

    (void)snprintf(path, sizeof path, "%s/%s-%ux%u-%s.ppm", directory, name, picture->width, picture->height, by);
    file = fopen(path, "wb");
    if (!file) {
        perror(path);
        return;
    }
    (void)fprintf(file, "P6 %u %u 255\n", picture->width, picture->height);
    for (unsigned i = 0; i < picture->width * picture->height; i++) {
        unsigned c = picture->colour[i];
        (void)fputc((int)((c >> 11) * 255 / 31), file);
        (void)fputc((int)((c >> 5 & 63) * 255 / 63), file);
        (void)fputc((int)((c & 31) * 255 / 31), file);
    }
    (void)fclose(file);
}

static void compare(const char *name)
{
    compare_regions("thing", by_tia.thing, by_gl.thing);
    compare_regions("lit", by_tia.lit, by_gl.lit);
    compare_regions("light", by_tia.light, by_gl.light);
    compare_colours();
    if (directory) {
        leave(name, &by_tia, "tia");
        leave(name, &by_gl, "gl");
    }
}

/* ---- cases: the light of each key, and one within the picture ---- */

static const struct state {
    const char *name;
    uint16_t key; /* key whose binding is the same light; 0: none */
    struct gl_ball light;
} states[] = {
    {"no_light", 0, {{0, 0, 0}, 0, {0, 0, 0}}},
    {"above_left", 'a', {{-20, 20, -20}, 3, {1, 1, 1}}},
    {"above_right", 'd', {{20, 20, -20}, 3, {1, 1, 1}}},
    {"near_the_eye", 's', {{0, 20, -8}, 3, {1, 1, 1}}},
    {"far_from_the_eye", 'w', {{0, 20, -32}, 3, {1, 1, 1}}},
    {"light_in_view", 0, {{7, 1, -32}, 3, {1, 0, 0}}},
};
static const struct tia_light red = {TIA_VEC3(7, 1, -32), TIA_Q16(3), TIA_RGB(1, 0, 0)};

static const char *library;
static const struct state *state;

static void check_state(unsigned width, unsigned height)
{
    struct tia_light lights[1] = {red};
    struct tia_scene scene = tia_thesis_scene;
    char why[PORT_WHY] = "";

    by_tia.width = by_gl.width = width;
    by_tia.height = by_gl.height = height;
    scene.lights = lights;
    scene.light_count = !state->key && state->light.radius > 0;
    for (uint32_t i = 0; i < scene.binding_count; i++) {
        if (scene.bindings[i].key == state->key) {
            lights[0] = scene.bindings[i].state;
            scene.light_count = 1;
        }
    }
    CHECK_EQ(scene.light_count, state->light.radius > 0);
    draw_by_tia(&scene, &by_tia);
    find_light(&by_tia);
    check_contents(scene.light_count > 0);
    CHECK(seen(by_tia.light, 1) == (state->light.radius > 0 && !state->key));
    if (!gl_scene_draw(library, &state->light, &by_gl, why)) {
        CHECK_MSG(false, "%s", why);
        return;
    }
    find_light(&by_gl);
    compare(state->name);
}

TEST(landscape)
{
    check_state(640, 480);
}
TEST(portrait)
{
    check_state(243, 321);
}

/* Runs all cases; in make check-quick each library draws only two of the states, since both are Mesa. */
static void run_all(const char *name)
{
    size_t count = check_count(sizeof states / sizeof states[0]);
    char title[64];

    library = name;
    for (size_t i = 0; i < count; i++) {
        state = &states[i];
        (void)snprintf(title, sizeof title, "%s_%s", name, state->name);
        check_run(title, landscape);
    }
    state = &states[1];
    (void)snprintf(title, sizeof title, "%s_portrait", name);
    check_run(title, portrait);
}

int main(int argc, char **argv)
{
    directory = argc > 1 && !check_is_word(argv[1]) ? argv[1] : NULL;
    /* keeps Mesa from storing compiled shaders in the user's home */
    (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
#ifdef TIA_HAVE_EGL
    run_all("egl");
#endif
#ifdef TIA_HAVE_LIBOSMESA
    run_all("osmesa");
#endif
    return check_status();
}
#endif
