/* Mistakes in .tia files: each error's line, column and text. */
#include "reading.h"

static struct reading now;

static void check_refused(const char *text, const char *error)
{
    read_string(&now, TIA_FORMAT_TIA, text);
    check_read_error(&now, error);
}

static void read_bytes(const char *bytes, size_t length)
{
    read_end(&now);
    now = (struct reading){.reader = {.format = TIA_FORMAT_TIA, .text = bytes, .length = length}};
    read_begin(&now);
}

#define M "material m\n"
#define STATEMENTS "a shape, material, light, camera or the like"

TEST(statements)
{
    check_refused("\n  spher 1 2 3", "2:3: 'spher' is not a statement, expected sphere");
    check_refused("smaples 4", "1:1: 'smaples' is not a statement, expected samples");
    check_refused("edn", "1:1: 'edn' is not a statement, expected end");
    check_refused("en", "1:1: 'en' is not a statement, expected end");
    check_refused("discs", "1:1: 'discs' is not a statement, expected disc");
    check_refused("grop", "1:1: 'grop' is not a statement, expected group");
    check_refused("x", "1:1: 'x' is not a statement, expected " STATEMENTS);
    check_refused("materialname", "1:1: 'materialname' is not a statement, expected " STATEMENTS);
    check_refused("fog colour 1", "1:13: the line ends here, expected distance");
    check_refused("fog colour 1 distance 4 heigt 2", "1:25: 'heigt' is not a field of fog, expected height");
    check_refused("fog colour 1 distance 4 up 2",
                  "1:25: 'up' is not a field of fog, expected colour, distance, height or level");
    check_refused("fog colour 1 distance 4\nfog colour 1 distance 4", "2:1: 'fog' is given twice, expected once");
    check_refused("group\nfog colour 1 distance 4\nend",
                  "2:1: 'fog' is not moved by groups, expected it outside of them");
    check_refused("lens radius 1", "1:14: the line ends here, expected focus");
    check_refused("lens focus 1 radius 2 f 3", "1:23: 'f' is not a field of a lens, expected radius or focus");
    check_refused("depth 5 6", "1:9: '6' is too much, expected the end of the line");
    check_refused("depth 5\ndepth 5", "2:1: 'depth' is given twice, expected once");
    check_refused("depth 17", "1:7: '17' is out of range, expected a whole number from 1 to 16");
    check_refused("integrator radiosity", "1:12: 'radiosity' is not an integrator, expected whitted, ao or path");
    check_refused("integrator ao 0", "1:15: '0' is not a distance, expected more than 0");
    check_refused("integrator path 2", "1:17: '2' is too much, expected the end of the line");
    check_refused("spp 0", "1:5: '0' is out of range, expected a whole number from 1 to 16777216");
    check_refused("spp 16777217", "1:5: '16777217' is out of range, expected a whole number from 1 to 16777216");
    check_refused("tone mapped", "1:6: 'mapped' is not a tone, expected linear or srgb");
    check_refused("exposure -24.5", "1:10: '-24.5' is out of range, expected -24 to 24");
    check_refused("exposure nan", "1:10: 'nan' is not a number, expected a number from -32768 to below 32768");
    check_refused("samples 2", "1:9: '2' is not a number of samples, expected 1, 4 or 16");
    check_refused("background", "1:11: the line ends here, expected a number from 0 to 1");
    check_refused("background 0.1 0.2", "1:19: the line ends here, expected a number from 0 to 1");
    check_refused("background 2", "1:12: '2' is out of range, expected a number from 0 to 1");
    check_refused("\n\nbackground -0.5", "3:12: '-0.5' is out of range, expected a number from 0 to 1");
    check_refused("camera eye 0 0 0 up 0 1 0", "1:26: the line ends here, expected look, as there is up");
    check_refused("camera frustum window -1 1 -1 1", "1:32: the line ends here, expected near");
    check_refused("camera orthographic near 1",
                  "1:21: 'near' is not a field of an orthographic camera, expected eye, look, up or window");
    check_refused("camera eye 0 zero 0", "1:14: 'zero' is not a number, expected a number below 2147483648");
}

TEST(names)
{
    check_refused(M M, "2:10: 'm' is already defined, expected another name");
    check_refused("material", "1:9: the line ends here, expected a name");
    check_refused("sphere radius 1 material m", "1:26: 'm' is not defined, expected the name of a material");
    check_refused("material m texture t", "1:20: 't' is not defined, expected the name of a texture");
    check_refused(M "instance m material m", "2:10: 'm' is not defined, expected the name of a mesh or grid");
    check_refused("mesh x\nend\ngrid x size 1 1 1\nrow 0\nend", "3:6: 'x' is already defined, expected another name");
    check_refused(M "light name x at 0 5 0\nsphere radius 1 material m name x",
                  "3:33: 'x' is already defined, expected another name");
    check_refused("light name camera at 0 5 0", "1:12: 'camera' is the camera's name, expected another");
    check_refused(M "sphere radius 1 material m name camera", "2:33: 'camera' is the camera's name, expected another");
}

TEST(looks)
{
    check_refused("material m colr 1", "1:12: 'colr' is not a field of a material, expected colour");
    check_refused("material m col 1",
                  "1:12: 'col' is not a field of a material, expected colour, texture, opacity or the like");
    check_refused("material m colors 1", "1:12: 'colors' is not a field of a material, expected colour");
    check_refused("material m shiny 1",
                  "1:12: 'shiny' is not a field of a material, expected colour, texture, opacity or the like");
    check_refused("material m mirror 1 mirror 1", "1:21: 'mirror' is given twice, expected once");
    check_refused(M "material n colour 0.5 1.5 0", "2:23: '1.5' is out of range, expected a number from 0 to 1");
    check_refused("texture t checker odd 1 1 -1", "1:27: '-1' is out of range, expected a number from 0 to 1");
    check_refused("filter", "1:7: the line ends here, expected none or footprint");
    check_refused("filter mip", "1:8: 'mip' is not a filter, expected none or footprint");
    check_refused("filter none\nfilter none", "2:1: 'filter' is given twice, expected once");
    check_refused("texture t stripes",
                  "1:11: 'stripes' is not a kind of texture, expected checker, image, opacity or noise");
    check_refused("texture t", "1:10: the line ends here, expected checker, image, opacity or noise");
    check_refused("texture t checker repeat 1 2 3",
                  "1:30: '3' is not a field of a checker, expected repeat, scale, offset, depth, even or odd");
    check_refused("texture t checker repeat 2 scale 3",
                  "1:1: 'texture' has a repeat and a scale, expected one of them");
    check_refused("texture t noise octaves 9", "1:25: '9' is out of range, expected a whole number from 1 to 8");
    check_refused("texture t noise odd 1",
                  "1:17: 'odd' is not a field of a noise, expected repeat, scale, offset, depth, low, high or octaves");
    check_refused("texture t checker offset 1e8 0",
                  "1:1: 'texture' has an offset out of range, expected less than 8388608");
    check_refused("shadows zfail tessellated -1", "1:27: '-1' is below 0, expected 0 or more");
    check_refused("texture t checker scale 0",
                  "1:1: 'texture' has a scale out of range, expected 1/1048576 to 1048576");
    check_refused("texture t checker offset 1", "1:27: the line ends here, expected a number below 2147483648");
    check_refused("texture t image", "1:16: the line ends here, expected an image's file");
    check_refused("texture t image \"x", "1:17: '\"x' has no closing quote, expected an image's file");
}

TEST(shapes)
{
    check_refused(M "sphere material m", "2:18: the line ends here, expected radius");
    check_refused(M "sphere radius 1", "2:16: the line ends here, expected material");
    check_refused(M "plane point 0 0 0 normal 0 0 0 material m",
                  "2:26: '0' begins a direction of no length, expected three numbers that are not all 0");
    check_refused(M "plane point 0 0 0 normal 0 1 0 material m at 0 0 0",
                  "2:43: 'at' is not a field of a plane, expected material, appears, vanishes, point or normal");
    check_refused(M "box min 0 0 0 max 1 1 1 1 material m", "2:25: '1' is not a field of a box, expected material, "
                                                            "min, max or the like");
    check_refused(M "cone base 0 0 0 top 0 1 0 radii 1 material m",
                  "2:35: 'material' is not a number, expected a number below 2147483648");
}

TEST(solids)
{
    check_refused("mesh a\nvertex 0 0 0\n", "1:1: mesh of line 1 has no end");
    check_refused("mesh a\nvertex 0 0 0\nsphere radius 1\nend",
                  "3:1: 'sphere' is not a line of a mesh, expected vertex, normal, uv, face, group or end");
    check_refused("mesh a\nvertex 0 0\nend", "2:11: the line ends here, expected a number below 2147483648");
    check_refused("mesh a\nvertex 0 0 0\nface 1 2 1\nend",
                  "3:8: '2' does not exist, expected the number of a vertex of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nface 1 0 1\nend",
                  "3:8: '0' does not exist, expected the number of a vertex of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nface 1 -1 1\nend",
                  "3:8: '-1' does not exist, expected the number of a vertex of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nuv 0 0\nface 1/1 1/18446744073709551617\nend",
                  "4:12: '18446744073709551617' does not exist, expected the number of a uv of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nnormal 0 0 1\nface 1//2\nend",
                  "4:9: '2' does not exist, expected the number of a normal of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nnormal 0 0 1\nface 1//1 1//1 1\nend",
                  "4:16: '1' is not like the first corner, expected uv and normal in all corners or in none");
    check_refused("mesh a\nvertex 0 0 0\nuv 0 0\nface 1 1/1 1/1\nend",
                  "4:8: '1/1' is not like the first corner, expected uv and normal in all corners or in none");
    check_refused("mesh a\nvertex 0 0 0\nface 1 1\nend",
                  "3:9: the line ends here, expected the number of a vertex of the mesh, from 1 to 1");
    check_refused("mesh a\nvertex 0 0 0\nface 1x\nend",
                  "3:7: 'x' is too much, expected vertex, vertex/uv, vertex//normal or vertex/uv/normal");
    check_refused("grid g size 1 1 1025", "1:17: '1025' is out of range, expected a whole number from 1 to 1024");
    check_refused("grid g size 2 1 1\nrow 0\nend", "2:6: the line ends here, expected a whole number from 0 to 255");
    check_refused("grid g size 1 1 1\nrow 256\nend",
                  "2:5: '256' is out of range, expected a whole number from 0 to 255");
    check_refused("grid g size 1 1 1\nend", "2:1: 'end' is not the next line of the grid, expected row");
    check_refused("grid g size 1 1 1\nrow 0\nrow 0", "3:1: 'row' is not the next line of the grid, expected end");
    check_refused("grid g size 1 1 1\nrow 0", "1:1: grid of line 1 has no end");
}

TEST(lights)
{
    check_refused("light", "1:6: the line ends here, expected at");
    check_refused("material a emission 8192\nmaterial b emission 1 8192.5 1",
                  "2:23: '8192.5' is out of range, expected a number from 0 to 8192");
    check_refused("light ambient emission 16384",
                  "1:24: '16384' is out of range, expected a number from 0 to below 16384");
    check_refused("light ambient at 0 0 0", "1:15: 'at' is not a field of an ambient light, expected name, appears, "
                                            "vanishes, emission, occlusion or samples");
    check_refused("light spot at 0 0 0 direction 0 1 0", "1:36: the line ends here, expected outer");
    check_refused("light disc at 0 5 0 direction 0 1 0 radius 1 samples 257",
                  "1:54: '257' is out of range, expected a whole number from 1 to 256");
    check_refused("key A light 1 at 0 0 0",
                  "1:5: 'A' is not a key, expected a small letter, a digit, left, right, up, down, "
                  "page-up or page-down");
    check_refused("key a lamp 1 at 0 0 0", "1:7: 'lamp' cannot be moved by a key, expected light");
    check_refused("key a light 0 at 0 0 0", "1:13: '0' is out of range, expected a whole number from 1 to 65536");
    check_refused("key a light 1 at 0 0 0 name x",
                  "1:24: 'name' is not a field of a point light, expected emission, at, attenuation or radius");
}

TEST(motion)
{
    check_refused("animate ball at 0: 0 0 0",
                  "1:9: 'ball' is not defined, expected the name of a shape or light, or camera");
    check_refused("light name l at 0 5 0\nanimate l scale 0: 1",
                  "2:11: 'scale' cannot be animated, expected at or direction, "
                  "of a light");
    check_refused("animate camera at 0: 0 0 0", "1:16: 'at' cannot be animated, expected eye or look, of the camera");
    check_refused("animate camera eye", "1:19: the line ends here, expected seconds and a colon, as in 2.5:");
    check_refused("animate camera eye smooth 0 0 0",
                  "1:27: '0' is not a time, expected seconds and a colon, as in 2.5:");
    check_refused("animate camera eye :", "1:20: ':' is not a time, expected seconds and a colon, as in 2.5:");
    check_refused("animate camera eye -1: 0 0 0", "1:20: '-1:' is out of range, expected 0 to below 32768 seconds");
    check_refused("animate camera eye 32768: 0 0 0",
                  "1:20: '32768:' is out of range, expected 0 to below 32768 seconds");
    check_refused("animate camera eye 1: 0 0 0 1: 0 0 0",
                  "1:29: '1:' is not after the time before it, expected rising times");
    check_refused("animate camera eye 1: 0 0", "1:26: the line ends here, expected a number below 2147483648");
}

/* Faults of the scene as a whole are reported at the word responsible, in the file's own words. */
TEST(faults_of_the_scene)
{
    check_refused(M "\nsphere radius 1 material m\n  sphere radius 0 material m",
                  "4:10: sphere: radius: must be at least 2^-10");
    check_refused(M "sphere radius 1 material m\nfog colour 1 distance 0",
                  "3:14: fog: distance: must be at least 2^-10");
    check_refused(M "sphere radius 1 material m\nlens radius 3 focus 2",
                  "3:6: lens: radius: must be above 0 and at most focus");
    check_refused(M "sphere radius 1 material m\nshadows zfail\nfog colour 1 distance 2",
                  "4:14: fog: distance: needs traced rays for shadows");
    check_refused(M "sphere material m \\\n radius 0 name ball\nsphere radius 1 material m name other\n"
                    "animate other at 0: 0 0 0",
                  "3:2: sphere: radius: must be at least 2^-10");
    check_refused("material index index 9 refraction 1", "1:16: material: index: must be in 0.25..4");
    check_refused("samples 4\ncamera fov 200", "2:8: camera: fov: must be in 1..170 degrees");
    check_refused("key a light 1 at 0 0 0 radius 1e-8", "1:24: key: radius: must be 0 or at least 2^-26");
    check_refused(M "light ambient\nlight at 2e9 2e9 0",
                  "3:7: light: at: every point must be nearer to the eye than 2147483648");
    check_refused("light rectangle at 0 5 0 sides 1 0 0 2 0 0",
                  "1:26: light: sides: the sides must not be on one line, unless both are 0");
    check_refused(M "sphere radius 1 material m scale 1\n  sphere radius 1 scale 0 material m",
                  "3:19: sphere: scale: must be in 2^-10..1024");
    check_refused(M "box min 0 0 0 max 1e6 1e6 1e6 at 2e9 2e9 0 material m",
                  "2:31: box: at: every point must be nearer to the eye than 2147483648");
    check_refused(M "box min 0 0 0 max 2e9 2e9 1e6 material m",
                  "2:1: box: every point must be nearer to the eye than 2147483648");
    check_refused(M "cone base 0 0 0 top 0 1 0 radii 1 1 material m", "2:27: cone: radii: must differ from the base's");
    check_refused(M "sphere radius 9e8 scale 0.01 1 1 material m",
                  "2:19: sphere: scale: too flat for its size: the radius around it, over the least scale, must be "
                  "below 32768");
    check_refused(M "triangle a 0 0 0 b 1 0 0 c 0 1 0 material m\n\ntriangle a 0 0 0 b 0 0 0 c 1 1 1 material m",
                  "4:1: triangle: must not be on one line");
    check_refused("texture a checker\ntexture t checker repeat 0",
                  "2:1: 'texture' has a repeat out of range, expected 1/1048576 to 1048576");
    check_refused("texture a checker\nmaterial m texture a opacity a",
                  "2:22: material: opacity: must be 0 or the number of an opacity texture");
    check_refused("grid a size 1 1 1\nrow 1\nend\ngrid g size 1 1 1 cell 0\nrow 1\nend",
                  "4:19: grid: cell: must be at least 2^-10");
    check_refused("light name l at 0 0 0\nanimate l at 0: 0 0 0\nanimate l at 0: 2e9 2e9 0",
                  "3:1: animate: every point must be nearer to the eye than 2147483648");
    check_refused("camera look 0 0 0", "1:8: camera: look: must not be the eye");
}

/* A byte order mark, with which many editors begin a text, is skipped. */
TEST(byte_order_mark)
{
    check_refused("\xef\xbb\xbfspher 1", "1:1: 'spher' is not a statement, expected sphere");
    check_refused("\xef\xbb\xbf\xef\xbb\xbf", "1:1: '?\?\?' is not a statement, expected " STATEMENTS);
    check_refused("\xef\xbb\xbf# \xef\xbb\xbf\nspher", "2:1: 'spher' is not a statement, expected sphere");
    check_refused("\xef\xbb", "1:1: '?\?' is not a statement, expected " STATEMENTS);
    read_string(&now, TIA_FORMAT_TIA,
                "\xef\xbb\xbf"
                "depth 5");
    CHECK(!now.status && now.scene.depth == 5);
    read_end(&now);
}

TEST(bytes_that_are_no_text)
{
    static const char bytes[] = "\0\xff\xfe\x01\n";
    char lengthy[5000];

    read_bytes(bytes, sizeof bytes);
    check_read_error(&now, "1:1: '?\?\?\?' is not a statement, expected " STATEMENTS);
    memset(lengthy, '9', sizeof lengthy);
    memcpy(lengthy, "background ", 11);
    read_bytes(lengthy, sizeof lengthy);
    check_read_error(&now, "1:12: '9999999999999999999999999999999999999999...' is out of range, expected a number "
                           "from 0 to 1");
    now.reader.length = UINT32_MAX; /* refused before a byte is read */
    CHECK_EQ(tia_read(&now.reader, &now.scene, NULL, 0, &now.need), TIA_ERR_RANGE);
    CHECK(!strcmp(now.reader.error.text, "the text is too long, expected less than 4 GiB"));
    memset(lengthy, '\n', sizeof lengthy);
    read_bytes(lengthy, sizeof lengthy);
    CHECK_EQ(now.status, TIA_OK);
}

TEST(texts_that_are_cut_off)
{
    static const char text[] = M "mesh a\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nface 1 2 3\nend\n"
                                 "grid g size 1 1 1\nrow 1\nend\ninstance a material m at 1 2 -3 name ball\n"
                                 "animate ball at smooth 0: 0 0 0 \\\n 1: 0 3 0\nlight spot at 0 5 0 direction 0 -1 0 "
                                 "outer 30\nkey a light 1 at 0 5 0\ntexture t checker even 1 odd 0\n";
    struct tia_reader reader = {.format = TIA_FORMAT_TIA, .text = text, .length = sizeof text - 1};

    check_truncated(&reader);
}

/* ---- all mistakes ---- */

struct list {
    uint32_t count, line[TIA_MISTAKES_MAX + 1];
    char word[TIA_MISTAKES_MAX + 1][20];
};

static void note(void *ctx, const struct tia_read_error *error)
{
    struct list *list = ctx;

    CHECK(list->count < TIA_MISTAKES_MAX);
    list->line[list->count] = error->line;
    (void)snprintf(list->word[list->count++], 20, "%.*s", (int)error->length, error->source + error->column - 1);
}

/* Reads a text with that much memory. Checks the status, and the lines and words of the mistakes: "1 a 2 b". */
static size_t check_mistakes(const char *text, size_t size, const char *want)
{
    struct list list = {.count = 0};
    struct tia_reader reader = {
        .format = TIA_FORMAT_TIA, .text = text, .length = strlen(text), .mistake = note, .ctx = &list};
    uint64_t *memory = calloc(1, size + 8);
    char got[400] = "";
    size_t need = 0;

    CHECK_EQ(tia_read(&reader, &now.scene, memory, size, &need), TIA_ERR_RANGE);
    for (uint32_t i = 0; i < list.count; i++)
        (void)snprintf(got + strlen(got), sizeof got - strlen(got), "%s%u %s", i ? " " : "", (unsigned)list.line[i],
                       list.word[i]);
    CHECK_MSG(!strcmp(got, want), "'%s', not '%s'", got, want);
    CHECK(reader.mistakes == list.count && reader.error.line == list.line[0]);
    free(memory);
    return need;
}

/* Undefined names are told if there is memory; *need says how much. */
TEST(all_mistakes)
{
    const char *text = M "sphere radius 1 material n\ndepth x\nsphere radius 1 materal m\n";
    size_t need = check_mistakes(text, 0, "3 x 4 materal");

    CHECK(need > 0);
    CHECK_EQ(check_mistakes(text, need - 1, "3 x 4 materal"), need);
    CHECK_EQ(check_mistakes(text, need, "2 n 3 x 4 materal"), need);
    (void)check_mistakes("group\nlight at 0 0 0 \\\n radus 1\ngroup\ngroup\nend\nend\n", 9999, "1 group 3 radus");
    (void)check_mistakes(M "group\n  group\n  sphere radius 1 material m\nend\n", 9999, "3 group");
    (void)check_mistakes(M "group\n  group\n  sphere radius 1 material m\n  end\n", 9999, "2 group");
    (void)check_mistakes("group at 0 x 0\nend\nunion at x 0 0\nend\nrepeat 0\nend\n", 9999, "1 x 3 x 5 0");
    (void)check_mistakes(M "sphere radius 0 material m", 9999, "2 radius");
    (void)check_mistakes("repeat 9\nsphere radius 1 material n\nend\n", 9999, "2 n");
    (void)check_mistakes("define R 1\ndefine S x\nsphere radius S\nsphere radius Q material n", 9999, "2 x 4 Q");
}

/* Every mistake is counted up to one more than are told. */
TEST(mistakes_counted)
{
    char text[400] = "";
    struct list list;
    size_t need;

    for (uint32_t count = 1; count < 40; count++) {
        struct tia_reader reader = {.format = TIA_FORMAT_TIA, .text = text, .mistake = note, .ctx = &list};
        strcat(text, "xyzzy\n");
        reader.length = strlen(text);
        list.count = 0;
        CHECK_EQ(tia_read(&reader, &now.scene, NULL, 0, &need), TIA_ERR_RANGE);
        CHECK_EQ(reader.mistakes, count < TIA_MISTAKES_MAX + 1 ? count : TIA_MISTAKES_MAX + 1);
        CHECK_EQ(list.count, reader.mistakes < TIA_MISTAKES_MAX ? reader.mistakes : TIA_MISTAKES_MAX);
    }
}

int main(void)
{
    RUN(statements);
    RUN(names);
    RUN(looks);
    RUN(shapes);
    RUN(solids);
    RUN(lights);
    RUN(motion);
    RUN(faults_of_the_scene);
    RUN(byte_order_mark);
    RUN(bytes_that_are_no_text);
    RUN(texts_that_are_cut_off);
    RUN(all_mistakes);
    RUN(mistakes_counted);
    read_end(&now);
    return check_status();
}
