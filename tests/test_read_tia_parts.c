/* Scenes in several files, names for numbers, and groups: their meaning and refusals. */
#include <math.h>

#include "obj_files.h"
#include "oracle/shape.h"

static struct reading now;
static struct files files;

static void read_scene(const char *text)
{
    read_end(&now);
    now = (struct reading){.reader = {.format = TIA_FORMAT_TIA,
                                      .text = text,
                                      .length = strlen(text),
                                      .library = fetch_library,
                                      .image = fetch_image,
                                      .ctx = &files}};
    read_begin(&now);
}

static void check_reads(const char *text)
{
    read_scene(text);
    CHECK_MSG(!now.status, "%.60s:%u:%u: %.150s: %.60s", now.reader.error.file, (unsigned)now.reader.error.line,
              (unsigned)now.reader.error.column, now.reader.error.text, text);
}

static void check_refused(const char *text, const char *error)
{
    read_scene(text);
    check_read_error(&now, error);
}

static bool is_vec(struct tia_vec3 v, double x, double y, double z)
{
    return v.x == TIA_Q16(x) && v.y == TIA_Q16(y) && v.z == TIA_Q16(z);
}

#define M "material m\n"

/* ---- define ---- */

TEST(names_for_numbers)
{
    const struct tia_scene *s = &now.scene;

    check_reads(
        "define RADIUS 2.5   # of the ball\ndefine Red 0.75 0.25 0\ndefine P 1 \\\n 2 3\ndefine N 7\ndefine Half 0.5\n"
        "material m colour Red mirror Half specular Half exponent N\n"
        "sphere radius RADIUS centre P material m\nbox min -P max P material m at N -N Half\ndepth N\n"
        "light at P emission Half Half 0\nmesh a\nvertex P\nend\n");
    CHECK(s->materials[0].colour.r == TIA_Q30(0.75) && s->materials[0].colour.g == TIA_Q30(0.25));
    CHECK(s->materials[0].mirror.r == TIA_Q30(0.5) && s->materials[0].mirror.b == TIA_Q30(0.5));
    CHECK(s->materials[0].exponent == TIA_Q16(7) && s->depth == 7);
    CHECK(s->spheres[0].radius == TIA_Q16(2.5) && is_vec(s->spheres[0].centre, 1, 2, 3));
    CHECK(is_vec(s->shapes[0].box.min, -1, -2, -3) && is_vec(s->shapes[0].box.max, 1, 2, 3));
    CHECK(is_vec(s->transforms[0].position, 7, -7, 0.5) && s->lights[0].emission.g == TIA_Q30(0.5));
    CHECK(s->lights[0].emission.b == 0 && is_vec(s->meshes[0].vertices[0], 1, 2, 3));
    check_reads("define A -32768\ndefine B 32768\n" M
                "sphere radius 1 centre A -B 0 material m\ncamera eye -32767 -32767 0");
    CHECK(is_vec(s->spheres[0].centre, -32768, -32768, 0));
}

TEST(names_for_numbers_refused)
{
    check_refused("define radius 1",
                  "1:8: 'radius' names no number, expected a name that begins with a capital letter");
    check_refused("define R", "1:9: the line ends here, expected numbers");
    check_refused("define R 1 x", "1:12: 'x' is not a number, expected numbers");
    check_refused("define R 1\ndefine S R", "2:10: 'R' is not a number, expected numbers");
    check_refused("define R 1\ndefine R 2", "2:8: 'R' is already defined, expected another name");
    check_refused(M "sphere radius R material m", "2:15: 'R' is not a number, expected a number below 2147483648");
    check_refused(M "define R 1 2\nsphere radius R material m",
                  "3:15: '2' is not a field of a sphere, expected material, appears, vanishes, name, at, rotate, "
                  "scale, centre or radius");
    check_refused(M "define R 4e9\nsphere radius R material m",
                  "3:15: '4e9' is out of range, expected a number below 2147483648");
    check_refused("define N 1.5\ndepth N", "2:7: '1.5' is not a whole number, expected a whole number from 1 to 16");
    check_refused("define N 9 9\ndepth N", "2:7: '9' is too much, expected the end of the line");
    check_refused("depth N\ndefine N 5", "1:7: 'N' is not a whole number, expected a whole number from 1 to 16");
}

TEST(too_many_names_for_numbers)
{
    static char text[4000];
    char *end = text;

    for (int i = 0; i < 128; i++)
        end += sprintf(end, "define N%d %d\n", i, i);
    (void)sprintf(end, "samples 1\ndepth N16\n");
    check_reads(text);
    CHECK_EQ(now.scene.depth, 16);
    (void)sprintf(end, "define N 1\n");
    check_refused(text, "129:8: 'N' is one name too many, expected at most 128");
}

/* ---- include ---- */

TEST(files_within_files)
{
    files = (struct files){
        .names = {"room/a.tia", "room/chair/b.tia", "room/chair/c d.tia"},
        .texts = {"define R 2\nsphere radius R material m\ninclude chair/b.tia\nsphere radius 3 material late",
                  "include \"c d.tia\"\ntexture t image wood.ppm\nmaterial late texture t",
                  "box min 0 0 0 max 1 R 1 material m # no line's end"}};
    check_reads(M "include room/a.tia\nsphere radius R material late\ninclude \"room/chair/c d.tia\"\n");
    CHECK(now.scene.sphere_count == 3 && now.scene.shape_count == 2 && now.scene.material_count == 2);
    CHECK(now.scene.spheres[0].radius == TIA_Q16(2) && now.scene.spheres[0].material == 0);
    CHECK(now.scene.spheres[1].radius == TIA_Q16(3) && now.scene.spheres[1].material == 1);
    CHECK(now.scene.shapes[1].box.max.y == TIA_Q16(2));
    files = (struct files){.names = {"room/a.tia", "/top/b.tia"},
                           .texts = {"include /top/b.tia", "material m\nsphere radius 1 material m"}};
    check_reads("include room/a.tia");
    CHECK_EQ(now.scene.sphere_count, 1);
}

static char image_asked[300];

static int keep_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)strcpy(image_asked, name);
    return fetch_image(ctx, name, texture, why);
}

TEST(pictures_lie_beside_the_file_that_names_them)
{
    static const char text[] = "include room/a.tia\ntexture u image /top/b.ppm\n";

    files = (struct files){.names = {"room/a.tia"}, .texts = {"texture t image wood/a.ppm"}};
    read_end(&now);
    now = (struct reading){.reader = {.text = "include room/a.tia", .length = 18, .library = fetch_library}};
    now.reader.image = keep_image;
    now.reader.ctx = &files;
    read_begin(&now);
    CHECK_MSG(!strcmp(image_asked, "room/wood/a.ppm"), "%s", image_asked);
    read_end(&now);
    now.reader.text = text;
    now.reader.length = strlen(text);
    read_begin(&now);
    CHECK_MSG(!strcmp(image_asked, "/top/b.ppm"), "%s", image_asked);
    read_end(&now);
}

TEST(errors_name_the_innermost_file)
{
    files = (struct files){.names = {"a", "b", "d/e", "g", "twice", "bad", "fault", "empty", "to", "fro"},
                           .texts = {"\n  include a", "sphere x", "include f", "group\n", "material m", "end",
                                     "\nsphere radius 0 material m\n", "", "include fro", "include to"}};
    check_refused("include a", "a:2:11: 'a' is already being read, expected a file that does not include itself");
    check_refused("include to", "fro:1:9: 'to' is already being read, expected a file that does not include itself");
    check_refused(
        "\ninclude b",
        "b:1:8: 'x' is not a field of a sphere, expected material, appears, vanishes, name, at, rotate, scale, "
        "centre or radius");
    check_refused("include d/e", "d/e:1:9: 'f': no such file, expected a scene's file");
    check_refused("include g\nend", "g:2:1: the text ends within a group, expected end");
    check_refused("group\ninclude bad", "bad:1:1: 'end' ends nothing, expected a group before it, in the same file");
    check_refused(M "include twice", "twice:1:10: 'm' is already defined, expected another name");
    check_refused("include twice\n" M, "2:10: 'm' is already defined, expected another name");
    check_refused("include twice\ninclude twice", "twice:1:10: 'm' is already defined, expected another name");
    check_refused(M "include fault\nsphere radius 1 material m", "fault:2:8: sphere: radius: must be at least 2^-10");
    check_refused(M "include empty x", "2:15: 'x' is too much, expected the end of the line");
    check_refused("include", "1:8: the line ends here, expected a file's name");
    check_refused("mesh x\ninclude empty",
                  "2:1: 'include' is not a line of a mesh, expected vertex, normal, uv, face or end");
    check_reads(M "include empty\ninclude empty\nsphere radius 1 material m");
    read_end(&now);
    read_string(&now, TIA_FORMAT_TIA, "include a");
    check_read_error(&now, "1:9: 'a' cannot be fetched here, expected a scene of one file");
}

TEST(files_have_bounds)
{
    static char many[2000];
    char *end = many;

    files = (struct files){.names = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "e"},
                           .texts = {"include 2", "include 3", "include 4", "include 5", "include 6", "include 7",
                                     "include 8", "include e", "", ""}};
    check_reads("include 2");
    check_refused("include 1", "8:1:9: 'e' is one file too deep, expected at most 8 within each other");
    for (int i = 0; i < 64; i++)
        end += sprintf(end, "include e\n");
    check_reads(many);
    (void)sprintf(end, "include e\n");
    check_refused(many, "65:9: 'e' is one file too many, expected at most 64 includes");
    files = (struct files){.names = {"d/a"}, .texts = {many}};
    (void)sprintf(many, "include %0254d", 1);
    check_refused("include d/a",
                  "d/a:1:9: '0000000000000000000000000000000000000000...' has too long a path, expected a path "
                  "of at most 255 bytes from the scene");
}

/* ---- groups ---- */

TEST(groups_move_and_scale)
{
    check_reads(M "group at 1 2 3 scale 2\n  sphere radius 1 centre 0 1 0 material m\n"
                  "  group at 1 0 0 scale 1 3 1\n    box min 0 0 0 max 1 1 1 at 0 1 0 scale 0.5 material m\n  end\n"
                  "  mesh x\n  vertex 0 0 0\n  end\nend\nsphere radius 1 material m\n");
    CHECK(now.scene.shape_count == 2 && now.scene.transform_count == 2 && now.scene.sphere_count == 1);
    CHECK(is_vec(now.scene.transforms[0].position, 1, 2, 3) && is_vec(now.scene.transforms[0].scale, 2, 2, 2));
    CHECK(is_vec(now.scene.transforms[1].position, 3, 8, 3) && is_vec(now.scene.transforms[1].scale, 1, 3, 1));
    CHECK(is_vec(now.scene.transforms[1].rotation, 0, 0, 0));
}

/* Angles from a single line are unchanged, those about one axis add up, and right angles are exact. */
TEST(groups_rotate)
{
    check_reads(
        M "group rotate 10.3 20.7 -30.1\nsphere radius 1 at 1 0 0 material m\nend\n"
          "group at 5 0 0\nsphere radius 1 rotate 77 123 -170 material m\nend\n"
          "group rotate 0 30.25 0\nsphere radius 1 rotate 0 20.5 0 material m\nend\n"
          "group rotate 0 90 0 scale 1 2 3\nsphere radius 1 at 1 0 0 rotate 0 0 90 scale 4 5 6 material m\nend\n");
    const struct tia_transform *t = now.scene.transforms;
    CHECK(is_vec(t[0].rotation, 10.3, 20.7, -30.1) && is_vec(t[1].rotation, 77, 123, -170));
    CHECK(is_vec(t[2].rotation, 0, 50.75, 0));
    /* x becomes y, and so is scaled by 2, y becomes x and is scaled by 1; then x becomes -z */
    CHECK(is_vec(t[3].position, 0, 0, -1) && is_vec(t[3].scale, 8, 5, 18));
}

static uint32_t seed = 1;

static double any(double least, double most)
{
    seed = seed * 1664525 + 1013904223;
    return least + (most - least) * (seed >> 8) / (double)(1 << 24);
}

static struct tia_transform any_transform(double uneven)
{
    double s = any(0.5, 2);

    return (struct tia_transform){
        {(tia_q16)(any(-9, 9) * 65536), (tia_q16)(any(-9, 9) * 65536), (tia_q16)(any(-9, 9) * 65536)},
        {(tia_q16)(any(-200, 200) * 65536), (tia_q16)(any(-200, 200) * 65536), (tia_q16)(any(-200, 200) * 65536)},
        {(tia_q16)(s * 65536), (tia_q16)(s * (1 + uneven) * 65536), (tia_q16)(s * (1 + uneven / 2) * 65536)}};
}

static char *say(char *to, const char *what, const struct tia_transform *t)
{
    return to + sprintf(to, "%s at %.9f %.9f %.9f rotate %.9f %.9f %.9f scale %.9f %.9f %.9f\n", what,
                        t->position.x / 65536.0, t->position.y / 65536.0, t->position.z / 65536.0,
                        t->rotation.x / 65536.0, t->rotation.y / 65536.0, t->rotation.z / 65536.0, t->scale.x / 65536.0,
                        t->scale.y / 65536.0, t->scale.z / 65536.0);
}

/* Compares a point placed by the oracle's transforms, one after the other, with the point placed by the single
 * transform that was read. Positions and scales are half of 2^-16 off, three angles half of 2^-16 degrees each: at 2 by
 * 8 from the position 1.6e-5. */
static void check_composed(const struct tia_transform t[3], const struct tia_transform *read, int bits)
{
    for (int i = 0; i < 8; i++) {
        struct oracle_vec v = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        struct oracle_vec want = transform_point(&t[0], transform_point(&t[1], transform_point(&t[2], v)));
        struct oracle_vec got = transform_point(read, scaled(v, ldexp(1, bits)));
        double off = length(sub(scaled(got, ldexp(1, -bits)), want));
        CHECK_MSG(off < 5e-5, "%g off", off);
    }
}

TEST(groups_within_groups)
{
    for (int i = 0; i < 300; i++) {
        char text[1000], *end = text + sprintf(text, M);
        struct tia_transform t[3] = {any_transform(0), any_transform(0), any_transform(0.5)};
        if (i % 3 == 0) /* the innermost group is uneven along the axis about which the shape turns */
            t[1].scale.y += TIA_Q16_ONE, t[2].rotation.x = t[2].rotation.z = 0;
        if (i % 3 == 1) /* near the poles of the angles */
            t[0].rotation.y = TIA_Q16(90), t[1].rotation.x = t[1].rotation.z = 0, t[1].rotation.y = i % 2 * 3,
            t[2].rotation.y = i - 150;
        end = say(say(end, "group", &t[0]), "group", &t[1]);
        end = say(end, "box min 0 0 0 max 1 1 1 material m", &t[2]);
        (void)sprintf(end, "end\nend\n");
        check_reads(text);
        if (!now.status)
            check_composed(t, &now.scene.transforms[0], (int)now.scene.scale_bits);
    }
}

TEST(groups_refused)
{
    const char *deep = "group\ngroup\ngroup\ngroup\ngroup\ngroup\ngroup\ngroup\n";
    char text[200];

    check_refused("group", "1:6: the text ends within a group, expected end");
    check_refused("group\nend\nend", "3:1: 'end' ends nothing, expected a group before it, in the same file");
    check_refused("group name x", "1:7: 'name' is not a field of a group, expected at, rotate or scale");
    check_refused(
        M "group scale 1 2 1\nsphere radius 1 rotate 0 0 30 material m\nend",
        "3:1: 'sphere' would be sheared: it is rotated in a group that is scaled unevenly, expected one scale "
        "for that group, or the rotation around it");
    check_refused(M "group scale 1 2 1\n group rotate 1 0 0\nend\nend",
                  "3:2: 'group' would be sheared: it is rotated in a group that is scaled unevenly, expected one scale "
                  "for that group, or the rotation around it");
    check_refused("group scale 0", "1:1: 'group' is scaled out of range, expected 1/1024 to 1024");
    check_refused("group scale 100\ngroup scale 100",
                  "2:1: 'group' is scaled out of range with its groups, expected 1/1024 to 1024 in all");
    check_refused("group scale 1000\ngroup at 2e9 0 0\nend\nend",
                  "2:1: 'group' is moved out of range by its groups, expected a place nearer to 0");
    check_refused("group scale 1000\ngroup at 0 0 -2e9\nend\nend",
                  "2:1: 'group' is moved out of range by its groups, expected a place nearer to 0");
    check_refused(M "group scale 100\nsphere radius 1 at 0 0 4e7 material m\nend",
                  "3:1: 'sphere' is moved out of range by its groups, expected a place nearer to 0");
    check_refused("group\nlight at 0 1 0\nend", "2:1: 'light' is not moved by groups, expected it outside of them");
    check_refused(M "group\nplane normal 0 1 0 material m\nend",
                  "3:1: 'plane' is not moved by groups, expected it outside of them");
    check_refused("group\ncamera eye 0 0 0\nend", "2:1: 'camera' is not moved by groups, expected it outside of them");
    check_refused("group\nkey a light 1 ambient\nend",
                  "2:1: 'key' is not moved by groups, expected it outside of them");
    check_refused(M "group\nsphere radius 1 name ball material m\nend\nanimate ball at 0: 0 0 0",
                  "3:22: 'ball' moves, expected it outside of groups");
    (void)sprintf(text, "%sgroup\n", deep);
    check_refused(text, "9:1: 'group' is one too deep, expected at most 8 groups within each other");
}

TEST(cut_anywhere)
{
    static const char text[] = M "define R 2\ngroup at R 0 0\ninclude a\nsphere radius R material m\nend\n";
    struct tia_reader reader = {.text = text, .length = sizeof text - 1, .library = fetch_library, .ctx = &files};

    files = (struct files){.names = {"a"}, .texts = {"group\nbox min 0 0 0 max R R R material m\nend\n"}};
    check_truncated(&reader);
}

int main(void)
{
    RUN(names_for_numbers);
    RUN(names_for_numbers_refused);
    RUN(too_many_names_for_numbers);
    RUN(files_within_files);
    RUN(pictures_lie_beside_the_file_that_names_them);
    RUN(errors_name_the_innermost_file);
    RUN(files_have_bounds);
    RUN(groups_move_and_scale);
    RUN(groups_rotate);
    RUN(groups_within_groups);
    RUN(groups_refused);
    RUN(cut_anywhere);
    read_end(&now);
    return check_status();
}
