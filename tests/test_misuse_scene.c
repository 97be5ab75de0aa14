/* Misuse of readers, hierarchies, animation, cameras, light fields and the other parts of a scene. */
#include <limits.h>
#include <tia/debug.h>
#include <tia/fit.h>

#include "misuse_scene.h"

static struct tia_scene scene, out;
static const struct tia_bvh *bvh;

static int read_with(struct tia_reader reader, void *memory, size_t size)
{
    size_t need = 0;

    return tia_read(&reader, &out, memory, size, &need);
}

#define READER(...) ((struct tia_reader){__VA_ARGS__})

TEST(misuse_of_readers)
{
    struct tia_reader reader = misuse_reader();
    size_t need;

    REFUSES(tia_read(NULL, &out, misuse_memory, sizeof misuse_memory, &need));
    REFUSES(tia_read(&reader, NULL, misuse_memory, sizeof misuse_memory, &need));
    REFUSES(tia_read(&reader, &out, misuse_memory, sizeof misuse_memory, NULL));
    REFUSES(read_with(reader, MISALIGNED(misuse_memory), sizeof misuse_memory - 8));
    REFUSES(read_with(READER(.text = NULL, .length = 5), misuse_memory, sizeof misuse_memory));
    REFUSES(read_with(READER(.format = (enum tia_format)99, .text = "x", .length = 1), misuse_memory, 8));
    REFUSES(read_with(READER(.format = (enum tia_format) - 1, .text = "x", .length = 1), misuse_memory, 8));
    GIVES(TIA_ERR_MEMORY, read_with(reader, NULL, 0));
    GIVES(TIA_ERR_MEMORY, read_with(reader, NULL, SIZE_MAX));
    GIVES(TIA_ERR_MEMORY, read_with(reader, misuse_memory, 1));
    for (int f = TIA_FORMAT_TIA; f < TIA_FORMATS; f++)
        GIVES(1,
              read_with(READER(.format = (enum tia_format)f), misuse_memory, sizeof misuse_memory) != TIA_ERR_ARGUMENT);
    misuse_end();
}

TEST(misuse_of_hierarchies)
{
    static const struct tia_workers none = {.run = NULL};

    misuse_read();
    scene = misuse_scene;
    scene.bvh = NULL;
    size_t size = sizeof misuse_memory, need = tia_bvh_size(&scene);
    GIVES(SIZE_MAX, (intmax_t)tia_bvh_size(NULL));
    REFUSES(tia_bvh_build(NULL, misuse_memory, size, NULL, &scene, NULL));
    REFUSES(tia_bvh_build(&bvh, NULL, size, NULL, &scene, NULL));
    REFUSES(tia_bvh_build(&bvh, NULL, 0, NULL, &scene, NULL));
    REFUSES(tia_bvh_build(&bvh, MISALIGNED(misuse_memory), size - 8, NULL, &scene, NULL));
    REFUSES(tia_bvh_build(&bvh, misuse_memory, size, NULL, NULL, NULL));
    REFUSES(tia_bvh_build(&bvh, misuse_memory, size, NULL, &scene, &(struct tia_job){.workers = &none}));
    GIVES(TIA_ERR_MEMORY, tia_bvh_build(&bvh, misuse_memory, need - 1, NULL, &scene, NULL));
    GIVES(1, (tia_bvh_build(&bvh, NULL, size, NULL, &scene, NULL), bvh == NULL));
    GIVES(TIA_OK, tia_bvh_build(&bvh, misuse_memory, need, NULL, &scene, NULL));
    misuse_end();
}

TEST(misuse_of_hierarchies_that_move)
{
    struct tia_scene fewer, bare, other;

    misuse_read();
    scene = misuse_scene;
    fewer = bare = other = scene;
    fewer.shape_count--;
    bare.bvh = NULL;
    other.transform_count++;
    size_t size = sizeof misuse_memory, need = tia_bvh_move_size(&scene);
    GIVES(SIZE_MAX, (intmax_t)tia_bvh_move_size(NULL));
    REFUSES(tia_bvh_move(NULL, misuse_memory, size, &scene, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, NULL, size, &scene, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, MISALIGNED(misuse_memory), size - 8, &scene, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, NULL, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &scene, NULL, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &scene, &bare, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &scene, &fewer, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &fewer, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &other, &scene, NULL));
    REFUSES(tia_bvh_move(&bvh, misuse_memory, size, &fewer, &fewer, NULL)); /* the hierarchy is another scene's */
    GIVES(TIA_ERR_MEMORY, tia_bvh_move(&bvh, misuse_memory, need - 1, &scene, &scene, NULL));
    GIVES(TIA_OK, tia_bvh_move(&bvh, misuse_memory, need, &bare, &scene, NULL));
    misuse_end();
}

static int64_t is_empty(struct tia_bounds b)
{
    return b.max.x < b.min.x && b.max.y < b.min.y && b.max.z < b.min.z;
}

TEST(misuse_of_objects)
{
    misuse_read();
    GIVES(1, is_empty(tia_object_bounds(NULL, 0)));
    GIVES(1, is_empty(tia_object_bounds(&misuse_scene, 3)));
    GIVES(1, is_empty(tia_object_bounds(&misuse_scene, 99999)));
    GIVES(1, is_empty(tia_object_bounds(&misuse_scene, UINT32_MAX)));
    GIVES(0, is_empty(tia_object_bounds(&misuse_scene, 1)));
    GIVES(0, tia_shape_fields((enum tia_shape_kind)99) != NULL);
    GIVES(0, tia_shape_fields((enum tia_shape_kind) - 1) != NULL);
    GIVES(0, tia_scene_bounces_off(NULL, 0));
    GIVES(0, tia_scene_bounces_off(&misuse_scene, 2));
    GIVES(0, tia_scene_bounces_off(&misuse_scene, UINT32_MAX));
    GIVES(1, tia_scene_bounces_off(&misuse_scene, 1));
    misuse_end();
}

TEST(misuse_of_animation)
{
    const struct tia_keyframe key = {TIA_Q16(1), TIA_VEC3(1, 2, 3)};
    const struct tia_track track = {.target = TIA_MOVES_LIGHT, .keys = &key, .key_count = 1};

    misuse_read();
    scene = misuse_scene;
    scene.tracks = &track;
    scene.track_count = 1;
    size_t size = sizeof misuse_memory, need = tia_scene_at_size(&scene);
    CHECK(need > 0);
    GIVES(SIZE_MAX, (intmax_t)tia_scene_at_size(NULL));
    REFUSES(tia_scene_at(NULL, misuse_memory, size, &scene, 0, NULL));
    REFUSES(tia_scene_at(&out, NULL, size, &scene, 0, NULL));
    REFUSES(tia_scene_at(&out, MISALIGNED(misuse_memory), size - 8, &scene, 0, NULL));
    REFUSES(tia_scene_at(&out, misuse_memory, size, NULL, 0, NULL));
    GIVES(TIA_ERR_MEMORY, tia_scene_at(&out, misuse_memory, need - 1, &scene, 0, NULL));
    GIVES(TIA_OK, tia_scene_at(&out, misuse_memory, need, &scene, INT32_MIN, NULL));
    GIVES(TIA_OK, tia_scene_at(&out, NULL, 0, &misuse_scene, INT32_MAX, NULL)); /* a scene without motion needs no
                                                                                   memory */
    GIVES(0, tia_scene_moves(NULL));
    GIVES(0, tia_scene_duration(NULL));
    misuse_end();
}

static int64_t eye_of(struct tia_camera camera, tia_q16 right, tia_q16 up)
{
    struct tia_camera before = camera;

    tia_camera_orbit(&camera, right, up);
    return memcmp(&before.eye, &camera.eye, sizeof before.eye) != 0;
}

static int64_t walked(struct tia_camera camera, int right, int up, int ahead)
{
    struct tia_camera before = camera;

    tia_camera_walk(&camera, right, up, ahead);
    return memcmp(&before, &camera, sizeof before) != 0;
}

#define FAR TIA_Q16(32767)

TEST(misuse_of_cameras)
{
    const struct tia_camera good = {
        .eye = TIA_VEC3(0, 1, 9), .reference = TIA_VEC3(0, 0, 0), .up = TIA_VEC3(0, 1, 0), .fov = TIA_Q16(40)};
    struct tia_camera flat = good, far = good, long_up = good, changed = good;

    misuse_read();
    flat.up = (struct tia_vec3){0, 0, 0};
    far.eye = (struct tia_vec3){FAR, FAR, FAR};
    far.reference = (struct tia_vec3){-FAR, -FAR, -FAR};
    long_up.up = (struct tia_vec3){INT32_MAX, INT32_MIN, INT32_MAX};
    HARMLESS(tia_camera_aim(NULL, &misuse_scene));
    HARMLESS(tia_camera_aim(&changed, NULL));
    HARMLESS(tia_camera_orbit(NULL, 0, 0));
    HARMLESS(tia_camera_walk(NULL, 1, 1, 1));
    HARMLESS(tia_camera_zoom(NULL, true));
    GIVES(0, eye_of(good, INT32_MIN, 0));
    GIVES(0, eye_of(good, 0, INT32_MIN));
    GIVES(0, eye_of(good, INT32_MAX, INT32_MAX));
    GIVES(0, eye_of(good, TIA_Q16(180) + 1, 0));
    GIVES(0, eye_of(flat, TIA_Q16(10), TIA_Q16(10)));
    GIVES(0, eye_of(far, TIA_Q16(10), TIA_Q16(10)));
    GIVES(1, eye_of(good, TIA_Q16(10), TIA_Q16(10)));
    GIVES(0, walked(good, INT_MIN, INT_MAX, INT_MIN));
    GIVES(0, walked(good, 0, INT_MAX, 0));
    GIVES(0, walked(far, 1, 1, 1));
    GIVES(1, walked(flat, 1, 1, 1));
    GIVES(1, walked(long_up, 1, 1, 1));
    GIVES(1, walked(good, 1, 1, 1));
    misuse_end();
}

static int field_camera(struct tia_camera camera, tia_q16 place)
{
    struct tia_camera made;

    return tia_light_field_camera(&made, &camera, place);
}

TEST(misuse_of_light_fields)
{
    const struct tia_camera good = {.projection = TIA_FRUSTUM,
                                    .window = {TIA_Q16(-1), TIA_Q16(1), TIA_Q16(-1), TIA_Q16(1), TIA_Q16(4)},
                                    .line = TIA_Q16(2)};
    struct tia_camera bad = good, minus = good, edge = good, wild = good, made;
    const struct tia_camera_change turned = {.height = -(INT64_C(1) << 48)};
    const struct tia_placement placement = {.bits = 16};

    edge.eye.x = edge.reference.x = TIA_Q16(32767.5); /* an eye on its line is beyond 32768 */
    edge.reference.z = TIA_Q16(-1);
    edge.up.y = TIA_Q16(1);
    wild.eye = (struct tia_vec3){1755178984, -1543150763, 800496670};
    wild.reference = (struct tia_vec3){-1358659468, -65298, INT32_MIN};
    wild.up.y = TIA_Q16(1);
    wild.line = -INT32_MAX;
    bad.up = (struct tia_vec3){0, TIA_Q16(1), 0}; /* the reference coincides with the eye */
    minus.line = INT32_MIN;
    REFUSES(tia_light_field_camera(NULL, &good, 0));
    REFUSES(tia_light_field_camera(&made, NULL, 0));
    GIVES(TIA_ERR_RANGE, field_camera(good, INT32_MIN));
    GIVES(TIA_ERR_RANGE, field_camera(good, INT32_MAX));
    GIVES(TIA_ERR_RANGE, field_camera(good, TIA_Q16(2) + 1));
    GIVES(TIA_ERR_RANGE, field_camera(bad, 0));
    GIVES(TIA_ERR_RANGE, field_camera(minus, 0));
    GIVES(TIA_OK, field_camera(good, TIA_Q16(-2)));
    GIVES(TIA_OK, field_camera(edge, TIA_Q16(-2)));
    GIVES(TIA_ERR_RANGE, field_camera(edge, TIA_Q16(1)));
    GIVES(TIA_ERR_RANGE, field_camera(wild, 0));
    made = (struct tia_camera){.fov = TIA_Q16(40), .line = INT32_MIN};
    GIVES(TIA_ERR_RANGE, field_camera(made, INT32_MIN));
    made.line = 0;
    tia_camera_alter(&made, &turned, &placement);
    GIVES(INT32_MAX, made.window.bottom);
    GIVES(0, tia_light_field_place(NULL, 1, 5));
    GIVES(0, tia_light_field_place(&good, 5, 0));
    GIVES(0, tia_light_field_place(&good, 5, 1));
    GIVES(0, tia_light_field_place(&good, 5, 5));
    GIVES(0, tia_light_field_place(&good, UINT32_MAX, 2));
    GIVES(0, tia_light_field_place(&minus, 0, 2));
    GIVES(TIA_Q16(2), tia_light_field_place(&good, 4, 5));
    misuse_end();
}

static struct tia_scene with_shadows(int shadows)
{
    struct tia_scene changed = misuse_scene;

    changed.shadows = (enum tia_shadows)shadows;
    return changed;
}

TEST(misuse_of_shadows)
{
    static struct tia_mesh mesh;
    struct tia_scene odd, mapped, broken;

    misuse_read();
    odd = with_shadows(77);
    mapped = with_shadows(TIA_SHADOWS_RAYS);
    broken = mapped;
    broken.materials = NULL;
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(NULL, 8, 8));
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(&misuse_scene, 0, 8));
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(&mapped, 0, 0));
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(&mapped, UINT_MAX, 8));
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(&odd, 8, 8));
    GIVES(TIA_NO_OBJECT, tia_shadow_too_far(&broken, 8, 8));
    unsigned range;
    GIVES(TIA_NO_OBJECT, tia_shadow_light_too_far(NULL, NULL, 0, 8, 8, &range));
    GIVES(TIA_NO_OBJECT, tia_shadow_light_too_far(&mapped, NULL, 1, 8, 8, &range));
    GIVES(TIA_NO_OBJECT, tia_shadow_light_too_far(&mapped, mapped.lights, mapped.light_count, 8, 8, NULL));
    GIVES(TIA_NO_OBJECT, tia_shadow_light_too_far(&broken, NULL, 0, 8, 8, &range));
    GIVES(SIZE_MAX, (intmax_t)tia_shadow_mesh_room(NULL));
    GIVES(0, tia_shadow_mesh_closes(NULL, misuse_memory));
    GIVES(0, tia_shadow_mesh_closes(&mesh, NULL));
    GIVES(0, tia_shadow_mesh_closes(&mesh, MISALIGNED(misuse_memory)));
    misuse_end();
}

TEST(misuse_of_names)
{
    const char *(*const names[])(unsigned) = {tia_tone_name, tia_integrator_name, tia_shadows_name,
                                              tia_bias_name, tia_filter_name,     tia_shown_guide_name};

    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        GIVES(0, names[i](99) != NULL);
        GIVES(0, names[i](INT_MAX) != NULL);
        GIVES(0, names[i](UINT_MAX) != NULL);
    }
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_readers);
    RUN(misuse_of_hierarchies);
    RUN(misuse_of_hierarchies_that_move);
    RUN(misuse_of_objects);
    RUN(misuse_of_animation);
    RUN(misuse_of_cameras);
    RUN(misuse_of_light_fields);
    RUN(misuse_of_shadows);
    RUN(misuse_of_names);
    return check_status();
}
