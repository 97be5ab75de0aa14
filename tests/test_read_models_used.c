/* Mistakes in models, models with many equal faces, and models as meshes of scenes. */
#include "model_bytes.h"

#define ONE TIA_Q16_ONE

/* ---- mistakes ---- */

TEST(mistakes)
{
    static const struct {
        enum tia_format format;
        const char *text, *want;
    } cases[] = {
        {TIA_FORMAT_STL, "solid x\nfacet\nvertex 0 0 nan\n",
         "3:12: 'nan' is not a number, expected a number below 2147483648"},
        {TIA_FORMAT_STL, "solid x\nvertex 0 0 3e9\n",
         "2:12: '3e9' is out of range, expected a number below 2147483648"},
        {TIA_FORMAT_STL, "solid x\n", "0:0: the model has no faces, expected some facets"},
        {TIA_FORMAT_STL, "stolid", "0:0: the file is too short, expected an STL file"},
        {TIA_FORMAT_PLY, "plot\n", "0:0: the file does not begin with ply, expected a PLY file"},
        {TIA_FORMAT_PLY, "ply\nformat utf8 1.0\n",
         "2:8: 'utf8' is not a format, expected ascii, binary_little_endian or binary_big_endian"},
        {TIA_FORMAT_PLY, "ply\nelement vertex 3\n", "0:0: the header does not end, expected end_header"},
        {TIA_FORMAT_PLY, "ply\nelement face 1\nproperty list uchar int vertex_index\nend_header\n",
         "0:0: the faces come before the vertices, expected them behind"},
        {TIA_FORMAT_PLY,
         "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
         "0 0 0\n1 1\n",
         "0:0: vertex 2: the file ends here, expected more numbers"},
        {TIA_FORMAT_OFF, "4OFF\n",
         "1:1: '4OFF' is not a form that can be read, expected OFF, COFF, NOFF, CNOFF or STOFF"},
        {TIA_FORMAT_OFF, "C", "1:1: 'C' is not a form that can be read, expected OFF, COFF, NOFF, CNOFF or STOFF"},
        {TIA_FORMAT_OFF, "OFF BINARY\n", "1:5: 'BINARY' is not a form that can be read, expected text"},
        {TIA_FORMAT_OFF, "OFF\n2 1 0\n0 0 0\n", "4:1: the file ends here, expected a vertex"},
        {TIA_FORMAT_PGM, "P6 2 2 255\n", "0:0: the file does not begin with P2 or P5, expected a PGM file"},
        {TIA_FORMAT_PGM, "P2 2 2 9\n1 2 3 10\n", "2:7: '10' is out of range, expected a whole number from 0 to 9"},
        {TIA_FORMAT_PGM, "P2 1 2 9\n1 2\n", "1:4: '1' is out of range, expected a whole number from 2 to 32767"},
        {TIA_FORMAT_PGM, "P5 30000 30000 255\n", "0:0: the picture is too large, expected at most 8388608 squares"},
        {TIA_FORMAT_PGM, "P5 2 2 255\nabc", "0:0: the file ends early, expected more levels"},
    };

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct reading r;
        read_string(&r, cases[i].format, cases[i].text);
        check_read_error(&r, cases[i].want);
    }
}

TEST(bad_floats)
{
    static const struct {
        uint32_t ieee;
        const char *want;
    } cases[] = {
        {0x7fc00000, "0:0: facet 2: a coordinate is not a number, expected a number below 2147483648"},
        {0x7f800000, "0:0: facet 2: a coordinate is out of range, expected a number below 2147483648"},
        {0xcf000000, "0:0: facet 2: a coordinate is out of range, expected a number below 2147483648"},
        {0xff800000, "0:0: facet 2: a coordinate is out of range, expected a number below 2147483648"},
        {0xffffffff, "0:0: facet 2: a coordinate is not a number, expected a number below 2147483648"},
    };
    struct reading r;

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct bytes stl = binary_stl();
        memcpy(stl.at + 84 + 50 + 12 + 16, &cases[i].ieee, 4);
        read_bytes(&r, TIA_FORMAT_STL, &stl);
        check_read_error(&r, cases[i].want);
    }
    struct bytes stl = binary_stl();
    stl.length--;
    read_bytes(&r, TIA_FORMAT_STL, &stl);
    check_read_error(&r, "0:0: the file has 283 bytes, expected 284 for its 4 facets");
}

/* Faces with a vertex that does not exist, or with two corners, are left out with a warning, or refused if strict. */
TEST(tolerated)
{
    static const char text[] = "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n2 0 1\n3 0 1 2\n";
    struct tia_read_warning warnings[TIA_WARNINGS];
    struct reading r = {
        .reader = {.format = TIA_FORMAT_OFF, .text = text, .length = sizeof text - 1, .warnings = warnings}};

    read_begin(&r);
    CHECK(!r.status && r.scene.meshes[0].face_count == 1 && warnings[TIA_WARN_FACE].count == 2);
    CHECK(!strcmp(warnings[TIA_WARN_FACE].at.text,
                  "'3' is not a vertex of the file, expected 0 to 2; the face is left out"));
    CHECK_EQ(warnings[TIA_WARN_FACE].at.line, 6);
    read_end(&r);
    r.reader.strict = true;
    read_begin(&r);
    check_read_error(&r, "6:7: '3' is not a vertex of the file, expected 0 to 2");
}

/* ---- many equal faces ---- */

TEST(copies)
{
    enum { FACES = 20000 };
    static const char head[] = "OFF\n4 20001 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 3\n";
    char *text = malloc(sizeof head + 8 * FACES), *at = text + sizeof head - 1;
    struct reading r;

    memcpy(text, head, sizeof head);
    for (int i = 0; i < FACES; i++, at += 8)
        memcpy(at, "3 0 1 2\n", 9);
    read_string(&r, TIA_FORMAT_OFF, text);
    CHECK(!r.status && r.scene.meshes[0].face_count == 2);
    CHECK(r.scene.meshes[0].faces[1].corner[2].vertex == 2);
    read_end(&r);
    memcpy(strstr(text, "20001"), " 4098", 5); /* of the 4097, 4096 are copies: they stay */
    read_string(&r, TIA_FORMAT_OFF, text);
    CHECK(!r.status && r.scene.meshes[0].face_count == 4098);
    read_end(&r);
    free(text);
}

/* In a large mesh most faces are known to be no copies by their hashes alone. */
TEST(copies_among_many)
{
    enum { SIDE = 200, EXTRA = 4097 };
    char *text = malloc((size_t)40 * SIDE * SIDE + (size_t)24 * (SIDE * SIDE + EXTRA) + 64), *at = text;
    struct reading r;

    for (int copies = EXTRA - 1; copies <= EXTRA; copies++) {
        at = text + sprintf(text, "OFF\n%d %d 0\n", SIDE * SIDE, (SIDE - 1) * (SIDE - 1) + copies);
        for (int i = 0; i < SIDE * SIDE; i++)
            at += sprintf(at, "%d %d 0\n", i % SIDE, i / SIDE);
        for (int i = 0; i < (SIDE - 1) * (SIDE - 1) + copies; i++) {
            int face = i % ((SIDE - 1) * (SIDE - 1)), from = face / (SIDE - 1) * SIDE + face % (SIDE - 1);
            at += sprintf(at, "3 %d %d %d\n", from, from + 1, from + SIDE);
        }
        read_string(&r, TIA_FORMAT_OFF, text);
        CHECK(!r.status);
        CHECK_EQ(r.scene.meshes[0].face_count, (SIDE - 1) * (SIDE - 1) + (copies == EXTRA ? 0 : copies));
        read_end(&r);
    }
    free(text);
}

/* ---- in scenes ---- */

static int fetch(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    static const char two[] =
        "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 9\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\n";
    static const char library[] = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
    static struct bytes stl;

    (void)ctx;
    stl = binary_stl();
    *why = "no such file";
    if (!strcmp(name, "models/four.STL")) {
        *text = (const char *)stl.at;
        *length = stl.length;
    } else if (!strcmp(name, "models/two.obj") || !strcmp(name, "models/two.mtl")) {
        *text = strstr(name, "obj") ? two : library;
        *length = strlen(*text);
    } else {
        return TIA_ERR_DEVICE;
    }
    return TIA_OK;
}

static void read_scene(struct reading *r, const char *text)
{
    *r = (struct reading){.reader = {.format = TIA_FORMAT_TIA, .text = text, .length = strlen(text), .library = fetch}};
    read_begin(r);
}

#define BEGIN "camera eye 0 0 20\nlight ambient\nmaterial m colour 0.5\n"

TEST(meshes_of_scenes)
{
    struct reading r;

    read_scene(&r, BEGIN "instance four material m scale 2\ninstance two\nmesh four file models/four.STL\n"
                         "mesh two file models/two.obj\ninstance two material m at 1 2 3\ninstance four\n");
    CHECK_EQ(r.status, TIA_OK);
    const struct tia_scene *s = &r.scene;
    unsigned red = 0, blue = 0, grey = 0, own = 0;
    for (uint32_t i = 0; i < s->shape_count; i++) {
        const struct tia_mesh *m = &s->meshes[s->shapes[i].mesh];
        const struct tia_rgb *c = &s->materials[s->shapes[i].material].colour;
        red += m->face_count && c->r == TIA_Q30_ONE && !c->b;
        blue += m->face_count && c->b == TIA_Q30_ONE && !c->r;
        grey += m->face_count && c->g == TIA_Q30(0.5);
        own += m->face_count && c->g == TIA_Q30(0.8);
    }
    CHECK(red == 1 && blue == 1 && grey == 3 && own == 1);
    CHECK(s->meshes[0].face_count == 4 && s->meshes[0].vertices[1].y == TIA_Q16(1.25) && s->scale_bits == 0);
    read_end(&r);
}

TEST(mistakes_in_scenes)
{
    static const char *const cases[][2] = {
        {"mesh a file nix.stl\n", "4:13: 'nix.stl': no such file, expected a model's file"},
        {"mesh a file a.glb\n",
         "4:13: 'a.glb' is not a format of models, expected a file in .obj, .stl, .ply, .off or .pgm"},
        {"mesh a file models/two.obj 1\n", "4:28: '1' is too much, expected the end of the line"},
        {"mesh a\nvertex 0 0 0\nend\ninstance a\n", "7:11: the line ends here, expected material"},
        {"mesh a file models/two.obj\ninstance a appears 1\n",
         "5:1: 'instance' has several materials, expected one if it appears or vanishes"},
    };

    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct reading r;
        char text[400];
        (void)snprintf(text, sizeof text, BEGIN "%s", cases[i][0]);
        read_scene(&r, text);
        check_read_error(&r, cases[i][1]);
    }
}

/* A line `group N` gives the faces behind it the group N. */
TEST(groups_of_meshes)
{
    struct reading r;

    read_scene(&r, BEGIN "mesh plain\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nface 1 2 3\nend\n"
                         "mesh a\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nface 1 2 3\ngroup 7\nface 3 2 1\nend\n"
                         "instance a material m\n");
    CHECK_EQ(r.status, TIA_OK);
    CHECK(!r.scene.meshes[0].groups && r.scene.meshes[1].groups && r.scene.meshes[1].groups[0] == 0 &&
          r.scene.meshes[1].groups[1] == 7);
    read_end(&r);
}

int main(void)
{
    RUN(mistakes);
    RUN(bad_floats);
    RUN(tolerated);
    RUN(copies);
    RUN(copies_among_many);
    RUN(meshes_of_scenes);
    RUN(mistakes_in_scenes);
    RUN(groups_of_meshes);
    return check_status();
}
