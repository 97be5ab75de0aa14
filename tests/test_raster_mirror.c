/* A plane mirror by the stencil buffer, as tia/raster.h draws it, against the mirror that rays trace: the scene is
 * drawn, then the mirror's own pixels are marked, and the mirrored scene is drawn where the mark is. Triangles emit
 * light, each in a colour of its own, so a colour identifies the visible one.
 *
 * Given a directory, the program leaves pictures of the first scene there: mirror-mark.png, mirror-stencil.png and
 * mirror-traced.png. */
#include <stdlib.h>

#include <tia/raster.h>
#include <tia/tia.h>

#include "ports.h"

#include "check.h"
#include "common/image/image.h"
#include "flat/faces.h"
#include "random.h"

enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT, TRIANGLES = 40, MIRROR = 2, SCENES = 20 };

/* The triangles, the mirror's two, and the mirrored triangles, which are not in the traced scene. */
static struct tia_shape shapes[2 * TRIANGLES + MIRROR];
static struct tia_material materials[TRIANGLES + 1];
static tia_rgb565 traced[PIXELS], drawn[PIXELS], marked[PIXELS];

/* ---- scenes ---- */

#define PLACE (TIA_Q16_ONE * -8) /* the mirror's z */
#define BEHIND 0x5b0f            /* a colour of no triangle */

static tia_rgb565 colour_of(uint32_t i)
{
    return (tia_rgb565)((7 * i + 9) % 32 << 11 | (23 * i + 11) % 64 << 5 | (13 * i + 5) % 32);
}

static struct tia_rgb light_of(tia_rgb565 colour)
{
    return (struct tia_rgb){(tia_q30)((int64_t)(colour >> 11) * TIA_Q30_ONE / 31),
                            (tia_q30)((int64_t)(colour >> 5 & 63) * TIA_Q30_ONE / 63),
                            (tia_q30)((int64_t)(colour & 31) * TIA_Q30_ONE / 31)};
}

static tia_q16 within(double low, double high)
{
    return (tia_q16)((low + (high - low) * (random_double() + 1) / 2) * 65536);
}

static void make_triangle(uint32_t i)
{
    struct tia_triangle *t = &shapes[i].triangle, *m = &shapes[TRIANGLES + MIRROR + i].triangle;
    tia_q16 x = within(-3, 3), y = within(-2, 2), z = within(-6.5, -3.5);

    for (int k = 0; k < 3; k++) {
        t->corner[k] = (struct tia_vec3){x + within(-0.6, 0.6), y + within(-0.6, 0.6), z + within(-0.6, 0.6)};
        m->corner[k] = t->corner[k];
        m->corner[k].z = 2 * PLACE - t->corner[k].z;
    }
    shapes[i].kind = shapes[TRIANGLES + MIRROR + i].kind = TIA_TRIANGLE;
    shapes[i].material = shapes[TRIANGLES + MIRROR + i].material = i;
    materials[i] = (struct tia_material){.emission = light_of(colour_of(i))};
}

static void make_scene(struct tia_scene *scene)
{
    const struct tia_vec3 corner[4] = {{TIA_Q16(-3), TIA_Q16(-2), PLACE},
                                       {TIA_Q16(3), TIA_Q16(-2), PLACE},
                                       {TIA_Q16(3), TIA_Q16(2), PLACE},
                                       {TIA_Q16(-3), TIA_Q16(2), PLACE}};

    for (uint32_t i = 0; i < TRIANGLES; i++)
        make_triangle(i);
    for (uint32_t i = 0; i < MIRROR; i++)
        shapes[TRIANGLES + i] = (struct tia_shape){
            .kind = TIA_TRIANGLE, .material = TRIANGLES, .triangle = {{corner[0], corner[1 + i], corner[2 + i]}}};
    materials[TRIANGLES] = (struct tia_material){.mirror = TIA_RGB(1, 1, 1)};
    *scene = (struct tia_scene){.background = light_of(BEHIND),
                                .camera = {.eye = {within(-2, 2), within(-1, 1), 0}, .fov = TIA_Q16(45)},
                                .materials = materials,
                                .shapes = shapes,
                                .material_count = TRIANGLES + 1,
                                .shape_count = TRIANGLES + MIRROR};
}

/* ---- the two mirrors ---- */

static void trace(const struct tia_core *core, const struct tia_scene *scene)
{
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    const struct tia_surface surface = {.pixels = traced, .step = 2, .pitch = 2 * WIDTH};
    size_t view_size = core->view_size(core, scene, 0), hits_size = core->hits_size(core, scene, all);
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(core->view_init(core, &view, view_memory, view_size, scene, 0, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, all), TIA_OK);
    CHECK_EQ(tia_view_light(view, hits, all, &surface, NULL), TIA_OK);
    free(view_memory);
    free(hits_memory);
}

static void draw_objects(struct tia_raster_target *target, const struct tia_flat_scene *flat, uint32_t first,
                         uint32_t count, struct tia_raster_state *state)
{
    for (uint32_t i = first; i < first + count; i++) {
        struct tia_raster_vertex corners[TIA_SIDES];
        uint32_t face = flat->objects[i].first_face, material = shapes[flat->objects[i].object].material;
        unsigned sides = tia_flat_corners(flat, face, corners);
        state->colour[0] = material < TRIANGLES ? colour_of(material) : BEHIND;
        CHECK_EQ(tia_raster_draw(target, state, corners, sides, face), TIA_OK);
    }
}

#define ANY                                                                                                            \
    {                                                                                                                  \
        .test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255                                                          \
    }

/* Draws in three passes, as in the manuals of OpenGL. No object is behind the mirror, so no clipping at its plane is
 * needed. */
static void draw_mirrored(struct tia_raster_target *target, const struct tia_flat_scene *flat)
{
    struct tia_raster_state state = {
        .depth = TIA_COMPARE_LESS, .depth_write = true, .front = ANY, .back = ANY, .colour_write = {true, true, true}};

    draw_objects(target, flat, 0, TRIANGLES + MIRROR, &state);
    state.depth = TIA_COMPARE_EQUAL;
    state.front.reference = state.back.reference = 1;
    state.front.zpass = state.back.zpass = TIA_STENCIL_REPLACE;
    draw_objects(target, flat, TRIANGLES, MIRROR, &state);
    tia_raster_clear_depth(target);
    state.depth = TIA_COMPARE_LESS;
    state.front.test = state.back.test = TIA_COMPARE_EQUAL;
    state.front.zpass = state.back.zpass = TIA_STENCIL_KEEP;
    draw_objects(target, flat, TRIANGLES + MIRROR, TRIANGLES, &state);
}

static unsigned draw(const struct tia_scene *given)
{
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    const unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR;
    struct tia_scene scene = *given;
    struct tia_raster_target target;
    struct tia_flat_scene flat;
    struct cancel never = {NULL, NULL, 0, false};
    unsigned mirrored = 0;

    scene.shape_count += TRIANGLES;
    size_t flat_size = tia_flat_size(&scene), size;
    void *flat_memory = malloc(flat_size);
    CHECK_EQ(tia_flat_init(&flat, flat_memory, flat_size, &scene, WIDTH, HEIGHT, &never), TIA_OK);
    size = tia_raster_size(all, buffers, flat.face_count);
    void *memory = malloc(size);
    CHECK_EQ(tia_raster_init(&target, memory, size, &flat.grid, all, buffers, flat.face_count), TIA_OK);
    tia_raster_clear_colour(&target, (const uint16_t[3]){BEHIND, 0, 0});
    draw_mirrored(&target, &flat);
    for (unsigned i = 0; i < PIXELS; i++) {
        drawn[i] = target.colour[3 * i];
        marked[i] = target.stencil[i] == 1 ? 0xffff : 0;
        mirrored += marked[i] && drawn[i] != BEHIND;
    }
    free(flat_memory);
    free(memory);
    return mirrored;
}

/* ---- pictures ---- */

static const char *directory;

static void leave(const char *name, const tia_rgb565 *pixels)
{
    static char why[PORT_WHY];
    char path[4096];

    (void)snprintf(path, sizeof path, "%s/%s.png", directory, name);
    struct image *image = image_create(path, image_format_of(path), WIDTH, HEIGHT, why);
    CHECK_MSG(image, "%s: %s", name, why);
    if (!image)
        return;
    (void)image_band(image, pixels, HEIGHT);
    CHECK_MSG(image_finish(image) == 0, "%s: %s", name, why);
}

TEST(pictures_are_left)
{
    struct tia_scene scene;

    if (!image_format_built(IMAGE_PNG)) {
        SKIP("built without libpng");
        return;
    }
    random_state = 11;
    make_scene(&scene);
    trace(&tia_core_q16, &scene);
    (void)draw(&scene);
    leave("mirror-mark", marked);
    leave("mirror-stencil", drawn);
    leave("mirror-traced", traced);
}

/* ---- comparison ---- */

/* True if a neighbour of the pixel has the same colour. A ray that leaves the mirror has a rounded point and direction:
 * it may pass an edge on the other side. */
static bool is_beside(unsigned i)
{
    unsigned x = i % WIDTH, y = i / WIDTH;

    for (unsigned v = y ? y - 1 : 0; v <= y + 1 && v < HEIGHT; v++)
        for (unsigned u = x ? x - 1 : 0; u <= x + 1 && u < WIDTH; u++)
            if (drawn[v * WIDTH + u] == traced[i])
                return true;
    return false;
}

static void compare(const struct tia_core *core)
{
    unsigned mirrored = 0, differ = 0, scenes = check_count(SCENES);

    random_state = 11;
    for (unsigned s = 0; s < scenes; s++) {
        struct tia_scene scene;
        make_scene(&scene);
        trace(core, &scene);
        mirrored += draw(&scene);
        for (unsigned i = 0; i < PIXELS; i++) {
            bool other = drawn[i] != traced[i];
            CHECK_MSG(!other || is_beside(i), "scene %u, pixel %u: %04x, traced %04x", s, i, drawn[i], traced[i]);
            differ += other;
        }
    }
    printf("# %s: %u of %u pixels differ; %u see a triangle in the mirror\n", core->name, differ, scenes * PIXELS,
           mirrored);
    CHECK(mirrored > scenes * 500);
    CHECK(differ * 20000 <= scenes * PIXELS);
}

TEST(the_traced_mirror_in_integers)
{
    compare(&tia_core_q16);
}

#ifdef TIA_HAVE_F64
TEST(the_traced_mirror_in_double)
{
    compare(&tia_core_f64);
}
#endif

int main(int argc, char **argv)
{
    directory = argc > 1 && !check_is_word(argv[1]) ? argv[1] : NULL;
    if (directory)
        RUN(pictures_are_left);
    RUN(the_traced_mirror_in_integers);
#ifdef TIA_HAVE_F64
    RUN(the_traced_mirror_in_double);
#endif
    return check_status();
}
