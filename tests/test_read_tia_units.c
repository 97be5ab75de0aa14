/* The unit of length of .tia scenes: every length is finer by scale_bits, no other number is, and the picture is the
 * same. */
#include "scaled.h"

/* Texts for read_scaled. */
#define SHAPES                                                                                                         \
    "material m colour 0.5 0.75 1\nmaterial shiny colour 0.25 mirror 0.5 specular 0.5 exponent 20\n"                   \
    "texture tiles checker even 1 odd 0.25 repeat 0.5\nmaterial floor colour 1 texture tiles\n"                        \
    "plane point @0 @-2 @0 normal 0 1 0 material floor\n"                                                              \
    "sphere centre @-4 @0 @-10 radius @1.5 material shiny\nsphere name ball radius @1 at @4 @0.5 @-9 scale 1 2 1 "     \
    "rotate 0 0 30 material m\n"                                                                                       \
    "disc centre @0 @-1 @-8 normal 1 3 1 radius @1 material shiny\n"                                                   \
    "cylinder base @-2 @-2 @-12 top @-2 @1 @-11 radius @0.5 capped material m\n"                                       \
    "cone base @2 @-2 @-12 top @2 @2 @-12 radii @1 @0.25 material m\n"                                                 \
    "box min @-1 @-1 @-1 max @1 @0.5 @1 rotate 30 40 0 at @0 @2 @-12 material m\n"                                     \
    "triangle a @-6 @-1 @-14 b @6 @-1 @-14 c @0 @5 @-15 material shiny\n"                                              \
    "mesh pyramid\n vertex @-1 @0 @-1\n vertex @1 @0 @-1\n vertex @1 @0 @1\n vertex @-1 @0 @1\n vertex @0 @1.5 @0\n"   \
    " face 1 2 3 4\n face 2 1 5\n face 3 2 5\n face 4 3 5\n face 1 4 5\nend\n"                                         \
    "grid hill size 3 2 1 corner @-1.5 @0 @0 cell @0.5\n row 1 1 1\n row 0 1 0\nend\n"                                 \
    "instance pyramid at @-3 @-2 @-8 rotate 0 45 0 scale 0.5 material m\n"                                             \
    "group at @1 @-2 @-7 rotate 0 30 0 scale 0.5\n instance hill material m\n"                                         \
    " group at @2 @0 @0.5\n  sphere radius @0.5 at @0 @0.5 @0 material shiny\n end\nend\n"
#define LIGHTS                                                                                                         \
    "light at @-5 @5 @0 emission 0.5 radius @0.25\nlight spot at @0 @8 @-10 direction 0 -1 0 inner 15 outer 25\n"      \
    "light rectangle at @0 @6 @-6 sides @1 @0 @0 @0 @0.5 @1 samples 4 emission 0.25\n"                                 \
    "light disc at @3 @6 @-10 direction 0 -1 0 radius @1 samples 4 emission 0.25\n"                                    \
    "light sphere name lamp at @-3 @6 @-10 radius @1 samples 4 emission 0.25\n"
#define CAMERA "camera eye @0.5 @1 @2 look @0 @0 @-9 up 0 1 0 fov 60\n"
#define MOVES                                                                                                          \
    "animate ball at smooth 0: @4 @0.5 @-9 1: @5 @1 @-8 2: @4 @3 @-9\nanimate ball rotate 0: 0 0 30 1: 0 90 30\n"      \
    "animate ball scale 0: 1 2 1 1: 2\nanimate lamp at 0: @-3 @6 @-10 1: @0 @6 @-10\n"                                 \
    "animate camera eye 0: @0.5 @1 @2 1: @1 @1 @3\nanimate camera look 0: @0 @0 @-9 1: @1 @0 @-9\n"
#define KEYS "key a light 1 at @1 @2 @3 radius @0.5\n"

/* ---- every length ---- */

static int finer_bits; /* scale_bits of the second scene; the first has 0 */

static void same_lengths(const char *what, const void *a, const void *b, unsigned count)
{
    const tia_q16 *x = a, *y = b;

    for (unsigned i = 0; i < count; i++)
        CHECK_MSG(x[i] * (INT64_C(1) << finer_bits) == y[i], "%s: %d << %d is not %d", what, (int)x[i], finer_bits,
                  (int)y[i]);
}

static void same_numbers(const char *what, const void *a, const void *b, unsigned count)
{
    const int32_t *x = a, *y = b;

    for (unsigned i = 0; i < count; i++)
        CHECK_MSG(x[i] == y[i], "%s: %d is not %d", what, (int)x[i], (int)y[i]);
}

static void same_light(const struct tia_light *a, const struct tia_light *b)
{
    same_lengths("light", &a->centre, &b->centre, 3);
    same_lengths("light's radius", &a->radius, &b->radius, 1);
    same_lengths("light's sides", a->side, b->side, 6);
    same_numbers("light's direction", &a->direction, &b->direction, 3);
    same_numbers("light's angles", &a->inner, &b->inner, 2);
    same_numbers("attenuation", &a->constant, &b->constant, 3);
}

static void same_shape(const struct tia_shape *a, const struct tia_shape *b)
{
    CHECK_EQ(a->kind, b->kind);
    for (const struct tia_shape_field *f = tia_shape_fields(a->kind); f && f->member; f++) {
        const char *x = (const char *)a + f->offset, *y = (const char *)b + f->offset;
        if (f->value == TIA_SHAPE_Q16 || f->value == TIA_SHAPE_VEC3)
            same_lengths(f->member, x, y, f->value == TIA_SHAPE_Q16 ? 1 : 3);
        else if (f->value == TIA_SHAPE_DIR3)
            same_numbers(f->member, x, y, 3);
    }
}

static void same_tracks(const struct tia_scene *a, const struct tia_scene *b)
{
    for (uint32_t i = 0; i < a->track_count; i++) {
        enum tia_target target = a->tracks[i].target;
        bool moves = target == TIA_MOVES_EYE || target == TIA_MOVES_REFERENCE || target == TIA_MOVES_LIGHT ||
                     target == TIA_MOVES_TRANSFORM;
        for (uint32_t k = 0; k < a->tracks[i].key_count; k++) {
            const struct tia_keyframe *x = &a->tracks[i].keys[k], *y = &b->tracks[i].keys[k];
            same_numbers("time", &x->time, &y->time, 1);
            (moves ? same_lengths : same_numbers)("keyframe", &x->value, &y->value, 3);
        }
    }
}

static void same_solids(const struct tia_scene *a, const struct tia_scene *b)
{
    for (uint32_t i = 0; i < a->mesh_count; i++)
        same_lengths("vertices", a->meshes[i].vertices, b->meshes[i].vertices, 3 * a->meshes[i].vertex_count);
    for (uint32_t i = 0; i < a->grid_count; i++) {
        same_lengths("corner", &a->grids[i].corner, &b->grids[i].corner, 3);
        same_lengths("cell", &a->grids[i].cell, &b->grids[i].cell, 1);
    }
}

static void same_scene(const struct tia_scene *a, const struct tia_scene *b)
{
    same_lengths("eye", &a->camera.eye, &b->camera.eye, 3);
    same_lengths("look", &a->camera.reference, &b->camera.reference, 3);
    same_lengths("window", &a->camera.window, &b->camera.window, 5);
    same_numbers("up", &a->camera.up, &b->camera.up, 3);
    same_numbers("fov", &a->camera.fov, &b->camera.fov, 1);
    for (uint32_t i = 0; i < a->sphere_count; i++)
        same_lengths("sphere", &a->spheres[i], &b->spheres[i], 4);
    for (uint32_t i = 0; i < a->shape_count; i++)
        same_shape(&a->shapes[i], &b->shapes[i]);
    for (uint32_t i = 0; i < a->transform_count; i++) {
        same_lengths("at", &a->transforms[i].position, &b->transforms[i].position, 3);
        same_numbers("rotate and scale", &a->transforms[i].rotation, &b->transforms[i].rotation, 6);
    }
    for (uint32_t i = 0; i < a->texture_count; i++)
        same_numbers("texture", a->textures[i].repeat, b->textures[i].repeat, 4);
    for (uint32_t i = 0; i < a->light_count; i++)
        same_light(&a->lights[i], &b->lights[i]);
    for (uint32_t i = 0; i < a->binding_count; i++)
        same_light(&a->bindings[i].state, &b->bindings[i].state);
    same_solids(a, b);
    same_tracks(a, b);
}

/* Checks lengths. The first text is exact in Q16.16; in the second one, a sphere of radius 0.1, which is not, makes the
 * unit finer. */
static void check_lengths(const char *text)
{
    struct reading exact, finer;

    read_scaled(&exact, text, 1, "");
    read_scaled(&finer, text, 1, "sphere centre 0 0 -9 radius 0.1 material m\n");
    finer_bits = finer.scene.scale_bits;
    CHECK_EQ(exact.scene.scale_bits, 0);
    CHECK(finer_bits > 0);
    CHECK_EQ(finer.scene.sphere_count, exact.scene.sphere_count + 1);
    if (!check_failed)
        same_scene(&exact.scene, &finer.scene);
    read_end(&exact);
    read_end(&finer);
}

TEST(every_length_is_finer)
{
    check_lengths(CAMERA SHAPES LIGHTS MOVES KEYS);
    check_lengths("material m colour 1\ngrid g size 1 1 1\nrow 1\nend\ninstance g material m\n"
                  "light at @1 @2 @3 attenuation 1 0.5 0.25\nlight directional direction 1 2 3\n"
                  "camera frustum eye @0 @1 @2 look @0 @0 @-9 window @-1 @2 @-1 @1 near @3\n");
    check_lengths("material m colour 1\nsphere radius @1 material m\n"
                  "camera orthographic eye @0 @1 @2 look @0 @0 @-9 up 0 3 1 window @0 @0 @-1 @1\n");
}

/* ---- the choice of the unit ---- */

static int bits_of(const char *text)
{
    struct reading r;

    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_MSG(!r.status, "%s: %s", text, r.reader.error.text);
    int scale_bits = r.scene.scale_bits;
    read_end(&r);
    return r.status ? 99 : scale_bits;
}

#define M "material m colour 1\n"
#define TENTH "sphere centre 0 0 -5 radius 0.1 material m\n"

/* No point is 32768 or more from an eye, and no eye more than 8 above a plane. */
TEST(as_fine_as_there_is_room)
{
    CHECK_EQ(bits_of(M "sphere centre 0 0 -5 radius 0.125 material m\n"), 0);
    CHECK_EQ(bits_of(M TENTH), 12);
    CHECK_EQ(bits_of(M TENTH "light at 0 200 0\n"), 7);
    CHECK_EQ(bits_of(M TENTH "key a light 1 at 0 200 0\n"), 7);
    CHECK_EQ(bits_of(M TENTH "camera eye 0 0 200 look 0 0 0\n"), 7);
    CHECK_EQ(bits_of(M TENTH "camera look 0 0 -200\n"), 7);
    CHECK_EQ(bits_of(M TENTH "box min -1 -1 -1 max 1 1 1 at 0 0 -200 material m\n"), 7);
    CHECK_EQ(bits_of(M TENTH "group at 0 0 -100 scale 0.5\nsphere radius 1 at 0 0 -200 material m\nend\n"), 7);
    CHECK_EQ(bits_of(M TENTH "camera eye 140 0 0\ngroup at 100 0 0\ngroup at 100 0 0\n"
                             "sphere radius 1 at 90 0 0 material m\nend\nend\n"),
             6);
    CHECK_EQ(bits_of(M TENTH "sphere radius 1 scale 100 at 0 0 -9 material m\n"), 7);
    CHECK_EQ(bits_of(M TENTH "box name b min 0 0 0 max 1 1 1 material m\nanimate b at 0: 0 0 0 1: 0 0 -200\n"), 7);
    CHECK_EQ(bits_of(M TENTH "animate camera eye 0: 0 0 0 1: 0 200 0\n"), 7);
    CHECK_EQ(bits_of(M TENTH "animate camera look smooth 0: 0 0 -120 1: 0 0 -9\n"), 7);
    CHECK_EQ(bits_of(M TENTH "plane point 0 -2 0 normal 0 1 0 material m\n"), 2);
    CHECK_EQ(bits_of(M TENTH "plane point 0 -200 0 normal 0 1 0 material m\n"), -5);
    CHECK_EQ(bits_of(M TENTH "plane point 7 -1 9 normal 0 3 0 material m\nanimate camera eye 0: 0 0 0 1: 0 3 0\n"), 1);
    CHECK_EQ(bits_of(M TENTH "sphere radius 30000 material m\n"), 0);
    CHECK_EQ(bits_of(M "sphere centre 0 0 -0.001 radius 0.0001 material m\n"), 16);
    CHECK_EQ(bits_of(M TENTH "camera orthographic window 0 0 -4 4\n"), 6);
}

/* Where the eye is so high above a plane that the least lengths would be too small, the unit is finer at the cost of
 * the plane's horizon. */
TEST(small_things_are_not_refused)
{
    CHECK_EQ(bits_of(M "camera eye 0 1000 0\nplane point 0 0 0 normal 0 1 0 material m\n"), -7);
    CHECK_EQ(bits_of(M "camera eye 0 1000 0\nplane point 0 0 0 normal 0 1 0 material m\n"
                       "sphere centre 0 1 0 radius 0.015625 material m\n"),
             -4);
    CHECK_EQ(bits_of(M "camera eye 0 1000 0\nplane point 0 0 0 normal 0 1 0 material m\n"
                       "sphere centre 0 1 0 radius 0.0009765625 material m\n"),
             0);
}

/* ---- the same picture ---- */

/* Returns the number of pixels that change when everything is a thousandth as large. */
static unsigned changed(const char *text, const char *small_text)
{
    static tia_rgb565 pixels[2][WIDTH * HEIGHT];
    struct reading r;
    unsigned count = 0;

    read_scaled(&r, text, 1, "");
    if (!r.status)
        draw(&r, pixels[0]);
    read_end(&r);
    read_scaled(&r, small_text, 0.001, "");
    CHECK(r.scene.scale_bits > 8);
    if (!r.status)
        draw(&r, pixels[1]);
    read_end(&r);
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        count += pixels[0][i] != pixels[1][i];
    return count;
}

/* Attenuation is given in the smaller unit, and so are the floor's tiles. */
TEST(a_thousandth_is_the_same_picture)
{
    static const char whole[] = CAMERA SHAPES LIGHTS;
    static char small[] = CAMERA SHAPES LIGHTS;

    memcpy(strstr(small, "repeat 0.5"), "repeat 500", 10);
    unsigned count = changed(whole, small);
    CHECK_MSG(1000 * count <= WIDTH * HEIGHT, "%u pixels of the whole differ", count);
    count = changed(CAMERA "material m colour 1\nlight at @0 @5 @-9 attenuation 0 0.125 0.03125\n"
                           "sphere centre @0 @0 @-10 radius @3 material m\n",
                    CAMERA "material m colour 1\nlight at @0 @5 @-9 attenuation 0 125 31250\n"
                           "sphere centre @0 @0 @-10 radius @3 material m\n");
    CHECK_EQ(count, 0);
}

/* Names of materials, for programs that need them and lengths in the file's unit. */
static char names[3][TIA_NAME_MAX + 1];

static void keep_name(void *ctx, uint32_t index, const char *name)
{
    (void)ctx;
    if (index < 3)
        memcpy(names[index], name, strlen(name) + 1);
}

static void read_named(struct reading *r, enum tia_format format, const char *text)
{
    *r = (struct reading){
        .reader = {.format = format, .text = text, .length = strlen(text), .material = keep_name, .unscaled = true}};
    memset(names, 0, sizeof names);
    read_begin(r);
    CHECK_EQ(r->status, TIA_OK);
    CHECK_EQ(r->scene.scale_bits, 0);
}

TEST(units_of_the_file_and_names)
{
    struct reading r;

    read_named(&r, TIA_FORMAT_TIA,
               "material brick colour 1\nmaterial itu_glass colour 0.5\n"
               "sphere centre 0 0 -5 radius 1.25 material itu_glass\nmaterial last colour 1\n");
    CHECK_EQ(r.scene.spheres[0].radius, TIA_Q16(1.25));
    CHECK(!strcmp(names[0], "brick") && !strcmp(names[1], "itu_glass") && !strcmp(names[2], "last"));
    read_end(&r);
    read_named(&r, TIA_FORMAT_NFF,
               "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 9 9\n"
               "f 1 1 1 1 0 0 0 0\ns 0 0 0 1.25\n");
    CHECK_EQ(r.scene.spheres[0].radius, TIA_Q16(1.25));
    CHECK(names[0][0] == '\0');
    read_end(&r);
}

int main(void)
{
    RUN(every_length_is_finer);
    RUN(as_fine_as_there_is_room);
    RUN(a_thousandth_is_the_same_picture);
    RUN(small_things_are_not_refused);
    RUN(units_of_the_file_and_names);
    return check_status();
}
