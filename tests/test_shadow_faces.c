/* A scene as flat faces, drawn by the rasteriser: each pixel must show the object that the tracer finds, for cameras of
 * every kind. The two share only the scene. The tracer rounds, so a few pixels at edges may differ. */
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "raster/target.h"
#include "shadow/volume.h"

#define WIDTH 160
#define HEIGHT 120

#define Q TIA_Q16

static struct cancel never;

/* A pyramid with a square base. Each face has its own corners, as many programs write models. */
static const struct tia_vec3 pyramid_points[] = {
    {Q(-1), 0, Q(-1)}, {Q(1), 0, Q(-1)}, {Q(1), 0, Q(1)},  {Q(-1), 0, Q(-1)}, {Q(1), 0, Q(1)}, {Q(-1), 0, Q(1)},
    {Q(-1), 0, Q(-1)}, {0, Q(2), 0},     {Q(1), 0, Q(-1)}, {Q(1), 0, Q(-1)},  {0, Q(2), 0},    {Q(1), 0, Q(1)},
    {Q(1), 0, Q(1)},   {0, Q(2), 0},     {Q(-1), 0, Q(1)}, {Q(-1), 0, Q(1)},  {0, Q(2), 0},    {Q(-1), 0, Q(-1)},
};

#define NO TIA_NO_INDEX
#define FACE(n)                                                                                                        \
    {                                                                                                                  \
        {                                                                                                              \
            {3 * (n), NO, NO}, {3 * (n) + 1, NO, NO},                                                                  \
            {                                                                                                          \
                3 * (n) + 2, NO, NO                                                                                    \
            }                                                                                                          \
        }                                                                                                              \
    }

static const struct tia_face pyramid_faces[] = {FACE(0), FACE(1), FACE(2), FACE(3), FACE(4), FACE(5)};
static const struct tia_mesh meshes[] = {
    {.vertices = pyramid_points, .faces = pyramid_faces, .vertex_count = 18, .face_count = 6},
    {.vertices = pyramid_points, .faces = pyramid_faces, .vertex_count = 18, .face_count = 5}, /* this mesh has a
                                                                                                  hole */
    {.vertices = pyramid_points},
};
static const struct tia_transform transforms[] = {
    {{Q(1), 0, Q(-2)}, {Q(20), Q(30), Q(40)}, {Q(1), Q(1.5), Q(1)}},
    {{Q(-3), Q(0.5), Q(1)}, {Q(0), Q(75), Q(-10)}, {Q(0.5), Q(0.5), Q(2)}},
    {{Q(2), Q(1), Q(2)}, {Q(-170), Q(5), Q(0)}, {Q(0.7), Q(0.7), Q(0.7)}},
};
static const struct tia_shape shapes[] = {
    {.kind = TIA_PLANE, .plane = {{0, Q(-1), 0}, {TIA_Q30(0.1), TIA_Q30(0.99), 0}}},
    {.kind = TIA_MESH, .mesh = 2},
    {.kind = TIA_BOX, .box = {{Q(-1.5), Q(-1), Q(-0.5)}, {Q(-0.25), Q(1), Q(1.25)}}},
    {.kind = TIA_BOX, .transform = 1, .box = {{Q(-1), Q(-0.5), Q(-1)}, {Q(1), Q(0.5), Q(1)}}},
    {.kind = TIA_MESH, .mesh = 0},
    {.kind = TIA_MESH, .mesh = 1, .transform = 2},
    {.kind = TIA_TRIANGLE, .triangle = {{{Q(2), Q(-0.5), Q(-3)}, {Q(4), Q(0), Q(1)}, {Q(3), Q(3), Q(0)}}}},
    {.kind = TIA_MESH, .mesh = 0, .transform = 3},
};
static const struct tia_material material = {.colour = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE}};

static const struct tia_scene scene = {.materials = &material,
                                       .material_count = 1,
                                       .shapes = shapes,
                                       .shape_count = sizeof shapes / sizeof *shapes,
                                       .transforms = transforms,
                                       .transform_count = 3,
                                       .meshes = meshes,
                                       .mesh_count = 3};

static void *trace(const struct tia_scene *s, struct tia_hits **hits, void **memory)
{
    struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    size_t view_size = tia_view_size(s, 0), size = tia_hits_size(s, all);
    struct tia_view *view;
    void *hit_memory = malloc(size);

    *memory = malloc(view_size);
    CHECK(!tia_view_init(&view, *memory, view_size, s, 0, WIDTH, HEIGHT, NULL));
    CHECK(!tia_hits_init(hits, hit_memory, size, view, all) && !tia_view_trace(view, *hits, all));
    return hit_memory;
}

/* Numbers of rows in strips, and of those that the faces may cover. */
static unsigned rows, rows_covered;

/* Draws strips of 1 to 9 rows, in which most faces are passed over. */
static void draw_in_strips(struct tia_raster_target *target, const struct tia_flat_scene *flat)
{
    for (unsigned y = 0, height; y < HEIGHT; y += height) {
        struct tia_raster_target strip;
        height = 1 + y % 9;
        height = height < HEIGHT - y ? height : HEIGHT - y;
        const struct tia_tile area = {0, (uint16_t)y, WIDTH, (uint16_t)height};
        CHECK(!tia_raster_part(&strip, target, area));
        CHECK(!tia_shadow_faces(&strip, flat, &never));
        for (uint32_t f = 0; f < flat->face_count; f++)
            rows_covered += tia_flat_may_cover(flat, f, &area) ? height : 0;
        rows += height * flat->face_count;
    }
}

/* Returns the number of pixels that show a different object; seen[n] counts the pixels of object n, seen[0] also those
 * of the background. */
static unsigned compare(const struct tia_flat_scene *flat, const struct tia_scene *s, unsigned *seen)
{
    struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    size_t size = tia_raster_size(all, TIA_BUFFER_DEPTH, flat->face_count);
    void *memory = malloc(size), *view, *hit_memory;
    struct tia_raster_target target;
    struct tia_hits *hits;
    unsigned differ = 0;

    CHECK(!tia_raster_init(&target, memory, size, &flat->grid, all, TIA_BUFFER_DEPTH, flat->face_count));
    draw_in_strips(&target, flat);
    hit_memory = trace(s, &hits, &view);
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
        uint32_t face = target.face[i], object = TIA_NO_OBJECT;
        if (face != TIA_NO_FACE)
            object = tia_flat_object_of(flat, face)->object;
        differ += object != tia_hits_object(hits, i % WIDTH, i / WIDTH);
        seen[object == TIA_NO_OBJECT ? 0 : object] += 1;
    }
    free(memory);
    free(view);
    free(hit_memory);
    return differ;
}

static void check_camera(const struct tia_camera *camera, unsigned *seen)
{
    struct tia_scene s = scene;
    struct tia_flat_scene flat;

    s.camera = *camera;
    size_t size = tia_flat_size(&s);
    void *memory = malloc(size);
    CHECK_EQ(tia_flat_init(&flat, memory, size - 1, &s, WIDTH, HEIGHT, &never), TIA_ERR_MEMORY);
    CHECK_EQ(tia_flat_init(&flat, memory, size, &s, WIDTH, HEIGHT, &never), TIA_OK);
    CHECK_EQ(flat.face_count, 2 + 12 + 12 + 6 + 5 + 1 + 6);
    CHECK_EQ(flat.object_count, 7); /* all but the mesh without faces */
    for (uint32_t i = 0; i < flat.object_count; i++) {
        uint32_t object = flat.objects[i].object;
        CHECK_EQ(flat.objects[i].closed, object != 0 && object != 5 && object != 6);
    }
    unsigned differ = compare(&flat, &s, seen);
    CHECK_MSG(differ <= 2, "%u of %u pixels show another object", differ, WIDTH * HEIGHT);
    free(memory);
}

static tia_q16 within(int range)
{
    return (tia_q16)(random_double() * range * 65536);
}

static void check_cameras(struct tia_camera camera)
{
    unsigned seen[sizeof shapes / sizeof *shapes] = {0};

    for (int i = 0; i < 12; i++) {
        camera.eye = (struct tia_vec3){within(6), Q(3) + within(2), Q(4) + within(4)};
        camera.reference = (struct tia_vec3){within(1), within(1), Q(-1)};
        if (camera.projection == TIA_ORTHOGRAPHIC)
            camera.eye.z += Q(9);
        camera.up = (struct tia_vec3){within(1) / 4, Q(1), 0};
        check_camera(&camera, seen);
    }
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        CHECK_MSG(seen[i] > 200 || i == 1, "object %zu is seen by %u pixels", i, seen[i]);
    CHECK_MSG(rows_covered < rows / 2, "%u of %u rows may be covered", rows_covered, rows);
}

TEST(perspective)
{
    check_cameras((struct tia_camera){.fov = Q(60)});
}

TEST(frustum)
{
    check_cameras(
        (struct tia_camera){.projection = TIA_FRUSTUM, .window = {Q(-0.7), Q(0.5), Q(-0.3), Q(0.6), Q(0.75)}});
}

TEST(orthographic)
{
    check_cameras((struct tia_camera){.projection = TIA_ORTHOGRAPHIC, .window = {0, 0, Q(-4), Q(3.5), 0}});
}

/* The corners of a solid's faces run counterclockwise seen from outside, so that faces turned to a distant eye are
 * front faces. */
TEST(faces_turn_outward)
{
    struct tia_scene s = scene;
    struct tia_flat_scene flat;
    size_t size = tia_flat_size(&s);
    void *memory = malloc(size);

    for (int flatly = 0; flatly < 2; flatly++) {
        s.camera = (struct tia_camera){.eye = {Q(1), Q(2), Q(9)}, .fov = Q(50)};
        if (flatly)
            s.camera = (struct tia_camera){
                .projection = TIA_ORTHOGRAPHIC, .eye = {Q(1), Q(2), Q(9)}, .window = {0, 0, Q(-4), Q(4), 0}};
        CHECK_EQ(tia_flat_init(&flat, memory, size, &s, WIDTH, HEIGHT, &never), TIA_OK);
        const struct tia_flat_object *box = &flat.objects[1]; /* object 2: the empty mesh before it has no faces */
        for (uint32_t f = 0; f < 12; f++) /* two each of -x +x -y +y -z +z; orthographic views see some edge-on */
            CHECK_EQ(tia_flat_side_of_eye(&flat, &flat.faces[box->first_face + f]),
                     flatly                                   ? (f / 2 == 5) - (f / 2 == 4)
                     : f / 2 == 1 || f / 2 == 3 || f / 2 == 5 ? 1
                                                              : -1);
        CHECK_EQ(tia_flat_side_of_eye(&flat, &flat.faces[0]), !flatly);
    }
    free(memory);
}

static const struct tia_light sun = {.kind = TIA_DIRECTIONAL_LIGHT, .direction = {0, TIA_Q30(-1), 0}};

static void check_fault(const struct tia_scene *s, const char *thing, const char *field)
{
    struct tia_fault fault = {"nothing", 0, "", ""};

    CHECK_EQ(tia_scene_check(s, &fault), TIA_ERR_RANGE);
    CHECK_MSG(!strcmp(fault.thing, thing) && !strcmp(fault.field, field) && strstr(fault.rule, "with these shadows"),
              "%s %u: %s: %s", fault.thing, (unsigned)fault.index, fault.field, fault.rule);
}

/* Scenes that these techniques cannot draw are refused, and the fault names the part. */
TEST(refuses)
{
    static const struct tia_material glass = {.transmission = {0, 1, 0}}, leaf = {.opacity = 1};
    static const uint8_t texel;
    static const struct tia_texture hole = {
        .kind = TIA_OPACITY, .repeat = {Q(1), Q(1)}, .width = 1, .height = 1, .texels = &texel};
    struct tia_light lights[2] = {sun,
                                  {.kind = TIA_RECTANGLE_LIGHT, .side = {{Q(1), 0, 0}, {0, Q(1), 0}}, .samples = 63}};
    struct tia_scene s = scene, bad;

    s.camera = (struct tia_camera){.eye = {0, 0, Q(9)}, .fov = Q(50)};
    s.lights = lights;
    s.light_count = 2;
    s.shadows = TIA_SHADOWS_ZPASS;
    CHECK_EQ(tia_scene_check(&s, NULL), TIA_OK);
    lights[1].samples = 64;
    check_fault(&s, "light", "samples");
    lights[1].kind = TIA_DISC_LIGHT;
    lights[1].direction = sun.direction;
    lights[1].radius = Q(1);
    check_fault(&s, "light", "samples");
    lights[1].kind = TIA_SPHERE_LIGHT;
    check_fault(&s, "light", "kind");
    bad = s;
    bad.textures = &hole;
    bad.texture_count = 1;
    bad.materials = &leaf;
    check_fault(&bad, "material", "opacity");
    bad.materials = &glass;
    check_fault(&bad, "material", "transmission");
}

int main(void)
{
    RUN(perspective);
    RUN(frustum);
    RUN(orthographic);
    RUN(faces_turn_outward);
    RUN(refuses);
    return check_status();
}
