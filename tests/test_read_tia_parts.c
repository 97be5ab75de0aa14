/* Scenes in several files, and names for numbers: their meaning and refusals. */
#include "scene_texts.h"

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
                  "3:15: '2' is not a field of a sphere, expected material, radius, appears or the like");
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
    files =
        (struct files){.names = {"a", "b", "d/e", "g", "twice", "bad", "fault", "empty", "to", "fro", "own"},
                       .texts = {"\n  include a", "sphere x", "include f", "group\n", "material m", "end",
                                 "\nsphere radius 0 material m\n", "", "include fro", "include to", M "include own"}};
    check_refused("include a", "a:2:11: 'a' is already being read, expected a file that does not include itself");
    check_refused("include to\n", "fro:1:9: 'to' is already being read, expected a file that does not include itself");
    check_refused(M "include own", "2:9: 'own' is already being read, expected a file that does not include itself");
    check_refused("\ninclude b",
                  "b:1:8: 'x' is not a field of a sphere, expected material, radius, appears or the like");
    check_refused("include d/e", "d/e:1:9: 'f': no such file, expected a scene's file");
    check_refused("include g\nend", "g:1:1: group of line 1 has no end");
    check_refused("group\ninclude bad\nend",
                  "bad:1:1: 'end' ends nothing, expected a group before it, in the same file");
    check_refused(M "include twice", "twice:1:10: 'm' is already defined, expected another name");
    check_refused("include twice\n" M, "2:10: 'm' is already defined, expected another name");
    check_refused("include twice\ninclude twice", "twice:1:10: 'm' is already defined, expected another name");
    check_refused(M "include fault\nsphere radius 1 material m", "fault:2:8: sphere: radius: must be at least 2^-10");
    check_refused(M "include empty x", "2:15: 'x' is too much, expected the end of the line");
    check_refused("include", "1:8: the line ends here, expected a file's name");
    check_refused("mesh x\ninclude empty\nend",
                  "2:1: 'include' is not a line of a mesh, expected vertex, normal, uv, face, group or end");
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
    RUN(cut_anywhere);
    read_end(&now);
    return check_status();
}
