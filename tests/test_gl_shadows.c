/* test_gl_shadows.c - faces and shadow volumes beside Mesa's rasterisers: each polygon that goes to tia_raster_draw is
 * also drawn by GL, whose corners, edges and depths are rounded. A face may differ in 1 of 10000 pixels of a view,
 * light in 1 of 20000; and at 95 % of all these pixels the exact picture must change, too, when pixel centres move by
 * 1/128. */
#include <math.h>
#include <stdlib.h>
#include <tia/raster.h>

#include "check.h"

#ifndef TIA_HAVE_LIBOSMESA
TEST(gl_shadows)
{
    SKIP("built without OSMesa (install libosmesa6-dev)");
}
int main(void)
{
    RUN(gl_shadows);
    return check_status();
}
#else
#include "gl/drivers.h"
#include "random.h"
#include "shadow/volume.h"

#define WIDTH 640
#define HEIGHT 480
#define PIXELS (WIDTH * HEIGHT)
#define VIEWS 8

/* ---- the scene: a ring and a box on the ground ---- */

#define AROUND 32
#define ACROSS 16
#define Q(x) ((tia_q16)((x)*65536 + ((x) > 0) - 0.5))

static struct cancel never;
static struct tia_vec3 ring_points[AROUND * ACROSS];
static struct tia_face ring_faces[2 * AROUND * ACROSS];
static const struct tia_mesh ring = {
    .vertices = ring_points, .faces = ring_faces, .vertex_count = AROUND * ACROSS, .face_count = 2 * AROUND * ACROSS};

static uint32_t ring_point(int i, int k)
{
    return (uint32_t)(i % AROUND * ACROSS + k % ACROSS);
}

static struct tia_face face_of(uint32_t a, uint32_t b, uint32_t c)
{
    return (struct tia_face){
        {{a, TIA_NO_INDEX, TIA_NO_INDEX}, {b, TIA_NO_INDEX, TIA_NO_INDEX}, {c, TIA_NO_INDEX, TIA_NO_INDEX}}};
}

static void make_ring(void)
{
    for (int i = 0; i < AROUND; i++)
        for (int k = 0; k < ACROSS; k++) {
            double u = 2 * M_PI * i / AROUND, v = 2 * M_PI * k / ACROSS, away = 0.9 + 0.3 * cos(v);
            uint32_t at = ring_point(i, k);
            ring_points[at] = (struct tia_vec3){Q(away * cos(u)), Q(0.3 * sin(v)), Q(away * sin(u))};
            ring_faces[2 * at] = face_of(at, ring_point(i, k + 1), ring_point(i + 1, k + 1));
            ring_faces[2 * at + 1] = face_of(at, ring_point(i + 1, k + 1), ring_point(i + 1, k));
        }
}

static const struct tia_shape shapes[] = {
    {TIA_TRIANGLE, .triangle = {{{Q(-12), 0, Q(-12)}, {Q(-12), 0, Q(12)}, {Q(12), 0, Q(12)}}}},
    {TIA_TRIANGLE, .triangle = {{{Q(-12), 0, Q(-12)}, {Q(12), 0, Q(12)}, {Q(12), 0, Q(-12)}}}},
    {TIA_MESH, 0, 1, .mesh = 0},
    {TIA_BOX, 0, 2, .box = {{Q(-0.8), 0, Q(-0.7)}, {Q(0.8), Q(1.7), Q(0.7)}}},
};
static const struct tia_transform transforms[] = {
    {{Q(0.4), Q(1.3), Q(2)}, {Q(57), 0, 0}, {Q(1), Q(1), Q(1)}},
    {{Q(1.9), 0, Q(-0.6)}, {0, Q(29), 0}, {Q(1), Q(1), Q(1)}},
};
static const struct tia_material white = {.colour = {Q(1), Q(1), Q(1)}};

/* Makes a scene seen from a random point around it, with a random light above. */
static void make_scene(struct tia_scene *scene, struct tia_light *light)
{
    double angle = M_PI * random_double(), away = 8.5 + 2.5 * random_double();

    *light =
        (struct tia_light){.emission = {Q(1), Q(1), Q(1)},
                           .centre = {Q(5 * random_double()), Q(6.5 + 2.5 * random_double()), Q(5 * random_double())}};
    *scene =
        (struct tia_scene){.camera = {.eye = {Q(away * cos(angle)), Q(4 + 3 * random_double()), Q(away * sin(angle))},
                                      .reference = {Q(0.2), Q(0.9), Q(0.3)},
                                      .up = {0, Q(1), 0},
                                      .fov = Q(45)},
                           .materials = &white,
                           .material_count = 1,
                           .lights = light,
                           .light_count = 1,
                           .shapes = shapes,
                           .shape_count = sizeof shapes / sizeof *shapes,
                           .transforms = transforms,
                           .transform_count = sizeof transforms / sizeof *transforms,
                           .meshes = &ring,
                           .mesh_count = 1,
                           .shadows = TIA_SHADOWS_ZFAIL};
}

/* ---- recording ---- */

struct drawn {
    struct tia_raster_state state;
    struct tia_raster_vertex corner[4];
    unsigned count;
    uint32_t face;
};

static struct drawn *drawn;
static size_t drawn_count, drawn_room;

/* The rasteriser's function: with the linker's option --wrap, calls reach __wrap_tia_raster_draw instead. */
int __real_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face);
int __wrap_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face);

int __wrap_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    if (drawn_count == drawn_room) {
        drawn_room = 2 * drawn_room + 1024;
        drawn = realloc(drawn, drawn_room * sizeof *drawn);
        if (!drawn)
            abort();
    }
    struct drawn *d = &drawn[drawn_count++];
    *d = (struct drawn){.state = *state, .count = count, .face = face};
    memcpy(d->corner, corners, count * sizeof *corners);
    return __real_tia_raster_draw(target, state, corners, count, face);
}

struct picture {
    uint32_t face[PIXELS];
    uint8_t stencil[PIXELS], lit[PIXELS];
};

struct view {
    struct tia_flat_scene flat;
    tia_flat_light light;
    void *memory;
};

static void light_picture(const struct view *v, struct picture *p)
{
    for (size_t i = 0; i < PIXELS; i++)
        p->lit[i] = p->face[i] == TIA_NO_FACE ? 2
                                              : !p->stencil[i] && p->face[i] < v->flat.face_count &&
                                                    tia_flat_is_turned(&v->flat, p->face[i], &v->light);
}

static void take_picture(const struct view *v, const struct tia_raster_target *t, struct picture *p)
{
    memcpy(p->face, t->face, sizeof p->face);
    memcpy(p->stencil, t->stencil, sizeof p->stencil);
    light_picture(v, p);
}

static const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
#define BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL)

static struct tia_raster_target target_of(const struct view *v, void **memory)
{
    size_t size = tia_raster_size(all, BUFFERS, v->flat.face_count);
    struct tia_raster_target t = {0};

    *memory = malloc(size);
    CHECK_EQ(tia_raster_init(&t, *memory, size, &v->flat.grid, all, BUFFERS, v->flat.face_count), TIA_OK);
    return t;
}

/* Draws by tia, and records the polygons. */
static void draw_exactly(struct view *v, const struct tia_scene *scene, struct picture *p)
{
    size_t size = tia_flat_size(scene);
    void *memory;

    v->memory = malloc(size);
    CHECK_EQ(tia_scene_check(scene, NULL), TIA_OK);
    CHECK_EQ(tia_flat_init(&v->flat, v->memory, size, scene, WIDTH, HEIGHT, &never), TIA_OK);
    tia_flat_light_at(&v->flat, &scene->lights[0], 0, &v->light);
    struct tia_raster_target t = target_of(v, &memory);
    drawn_count = 0;
    CHECK_EQ(tia_shadow_faces(&t, &v->flat, &never), TIA_OK);
    CHECK_EQ(tia_shadow_zfail(&t, &v->flat, (struct tia_shadow_light){&v->light, NULL}, &never), TIA_OK);
    take_picture(v, &t, p);
    free(memory);
}

/* Draws the recorded polygons with pixel centres moved by dx/128, dy/128. */
static void draw_moved(const struct view *v, int dx, int dy, struct picture *p)
{
    void *memory;
    struct tia_raster_target t = target_of(v, &memory);

    for (size_t i = 0; i < drawn_count; i++) {
        struct drawn d = drawn[i];
        for (unsigned k = 0; k < d.count; k++) {
            d.corner[k].x += dx * d.corner[k].w / (64 * WIDTH);
            d.corner[k].y += dy * d.corner[k].w / (64 * HEIGHT);
        }
        CHECK_EQ(__real_tia_raster_draw(&t, &d.state, d.corner, d.count, d.face), TIA_OK);
    }
    take_picture(v, &t, p);
    free(memory);
}

/* Draws by GL. The near plane is at 1, in front of all faces; depths beyond the planes are clamped. */
static void draw_by_gl(struct gl_raster *gl, const struct view *v, struct picture *p)
{
    gl_raster_clear(gl, 0);
    for (size_t i = 0; i < drawn_count; i++) {
        struct drawn *d = &drawn[i];
        double corner[4][4];
        for (unsigned k = 0; k < d->count; k++) {
            const struct tia_raster_vertex *c = &d->corner[k];
            double one = ldexp(1, v->flat.grid.fraction), w = (double)c->w / one;
            corner[k][0] = (double)c->x / one;
            corner[k][1] = (double)c->y / one;
            corner[k][2] = w - (c->h ? 2 : 0);
            corner[k][3] = w;
        }
        d->state.colour_write[0] = d->state.depth_write;
        gl_raster_draw(gl, &d->state, (const double(*)[4])corner, d->count, d->face);
    }
    CHECK(gl_raster_read(gl, p->face, p->stencil));
    light_picture(v, p);
}

/* ---- comparing ---- */

struct differences {
    size_t faces, lights, explained_faces, explained_lights;
};

static struct picture exact, strange, moved;
static bool face_changes[PIXELS], light_changes[PIXELS];

/* Finds the pixels that change when the centres move. */
static void find_edges(const struct view *v)
{
    memset(face_changes, 0, sizeof face_changes);
    memset(light_changes, 0, sizeof light_changes);
    for (int d = 0; d < 9; d++) {
        draw_moved(v, d % 3 - 1, d / 3 - 1, &moved);
        for (size_t i = 0; i < PIXELS; i++) {
            face_changes[i] = face_changes[i] || moved.face[i] != exact.face[i];
            light_changes[i] = light_changes[i] || face_changes[i] || moved.lit[i] != exact.lit[i];
        }
    }
}

static void compare(struct gl_raster *gl, struct differences *sum)
{
    struct differences d = {0};
    struct view v = {.memory = NULL};
    struct tia_scene scene;
    struct tia_light light;

    make_scene(&scene, &light);
    draw_exactly(&v, &scene, &exact);
    draw_by_gl(gl, &v, &strange);
    find_edges(&v);
    for (size_t i = 0; i < PIXELS; i++) {
        bool face = strange.face[i] != exact.face[i], lit = strange.lit[i] != exact.lit[i];
        d.faces += face;
        d.lights += lit;
        d.explained_faces += face && face_changes[i];
        d.explained_lights += lit && light_changes[i];
    }
    CHECK_MSG(d.faces <= PIXELS / 10000 && d.lights <= PIXELS / 20000, "%zu faces and %zu lights of %d differ", d.faces,
              d.lights, PIXELS);
    sum->faces += d.faces;
    sum->lights += d.lights;
    sum->explained_faces += d.explained_faces;
    sum->explained_lights += d.explained_lights;
    free(v.memory);
}

static void compare_views(const char *driver)
{
    struct gl_raster *gl = gl_opened(driver, WIDTH, HEIGHT);
    struct differences sum = {0};
    int views = (int)check_count(VIEWS);

    if (!gl)
        return;
    for (int i = 0; i < views; i++)
        compare(gl, &sum);
    printf("# %s: of %d pixels %zu see another face, %zu other light; %zu and %zu where edges are\n", driver,
           views * PIXELS, sum.faces, sum.lights, sum.explained_faces, sum.explained_lights);
    CHECK((sum.explained_faces + sum.explained_lights) * 100 >= (sum.faces + sum.lights) * 95);
    gl_raster_close(gl);
}

TEST(llvmpipe_sees_almost_the_same)
{
    compare_views("llvmpipe");
}

TEST(softpipe_sees_almost_the_same)
{
    compare_views("softpipe");
}

static void by_llvmpipe(void)
{
    RUN(llvmpipe_sees_almost_the_same);
}

static void by_softpipe(void)
{
    RUN(softpipe_sees_almost_the_same);
}

int main(void)
{
    make_ring();
    return gl_in_both(by_llvmpipe, by_softpipe);
}
#endif
