/* Models with common programs' mistakes, which are tolerated: one warning for each kind, and the rest is drawn. */
#include "obj_files.h"

/* The reader's warning of one mistake: "FILE:LINE:COLUMN: TEXT", and the number of its kind. */
struct mistake {
    const char *text; /* text of the model; its library "m" has the material `m`, which contains `lines` */
    enum tia_read_warning_kind kind;
    uint32_t count;
    const char *want;
    uint32_t faces; /* number of faces that are still drawn */
};

static const char library[] = "newmtl m\nKd 1 0 0\n";

static void check_warning(const struct files *files, enum tia_read_warning_kind kind, uint32_t count, const char *want)
{
    const struct tia_read_error *at = &files->warnings[kind].at;
    char got[700];

    for (unsigned i = 0; i < TIA_WARNINGS; i++)
        CHECK_MSG(files->warnings[i].count == (i == kind ? count : 0), "%u of kind %u, not %u of kind %u",
                  (unsigned)files->warnings[i].count, i, (unsigned)count, (unsigned)kind);
    (void)snprintf(got, sizeof got, "%s%s%u:%u: %s", at->file, *at->file ? ":" : "", (unsigned)at->line,
                   (unsigned)at->column, at->text);
    CHECK_MSG(!strcmp(got, want), "'%.150s', not '%.150s'", got, want);
}

static uint32_t faces_of(const struct tia_scene *scene)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->mesh_count; i++)
        count += scene->meshes[i].face_count;
    return count;
}

#define NO_FACE_LEFT "; the face is left out"
#define CORNERS "V, V/VT, V//VN or V/VT/VN"

TEST(mistakes)
{
    static const struct mistake cases[] = {
        {TRIANGLE "f 1 2 3\nf 1\nf\nf 1 2\n", TIA_WARN_FACE, 3,
         "5:4: the line ends here, expected " CORNERS NO_FACE_LEFT, 1},
        {TRIANGLE "f 1 2 4\nf 1 2 0\nf 1 2 3\n", TIA_WARN_FACE, 2,
         "4:7: '4' refers to a vertex that does not exist, expected 1 to 3, those before this line" NO_FACE_LEFT, 1},
        {TRIANGLE "f a b c\nf 1 2 3\n", TIA_WARN_FACE, 3, "4:3: 'a' is not a corner, expected " CORNERS NO_FACE_LEFT,
         1},
        {TRIANGLE "vt 0 0\nf 1/1 2/1 3/2\n", TIA_WARN_CORNER, 2,
         "5:11: '3/2' refers to a texture coordinate that does not exist, expected 1 to 1, those before this line; the "
         "face is drawn without",
         1},
        {TRIANGLE "vt 0 0\nvn 0 0 1\nf 1/1/1 2 3\n", TIA_WARN_CORNER, 1,
         "6:9: '2' is of another form, expected all corners of a face alike; the face is drawn without", 1},
        {TRIANGLE "vn 0 0 0\nf 1 2 3\n", TIA_WARN_NORMAL, 1,
         "4:4: '0' begins a direction of no length, expected three numbers that are not all 0; faces that use it are "
         "drawn flat",
         1},
        {TRIANGLE "vt nan 0\nvt 0 nan\nf 1/1 2/2 3/2\n", TIA_WARN_NUMBER, 2,
         "4:4: 'nan' is not a number, expected a number from -32768 to below 32768; 0 is used", 1},
        {TRIANGLE "vt 3443870976.0 -3e9\nf 1/1 2/1 3/1\n", TIA_WARN_RANGE, 2,
         "4:4: '3443870976.0' is out of range, expected a number from -32768 to below 32768; the nearest is used", 1},
        {TRIANGLE "usemtl none\nf 1 2 3\nusemtl nil\n", TIA_WARN_MATERIAL, 2,
         "4:8: 'none' is not a material, expected one that a mtllib has; grey is used", 1},
        {TRIANGLE "usemtl\nf 1 2 3\n", TIA_WARN_MATERIAL, 1,
         "4:7: the line ends here, expected one that a mtllib has; grey is used", 1},
        {"mtllib none.mtl\nmtllib other.mtl\n" TRIANGLE "f 1 2 3\n", TIA_WARN_LIBRARY, 2,
         "1:8: 'none.mtl' cannot be read: no such file, expected a material library; its materials are grey", 1},
        {"mtllib\n" TRIANGLE "f 1 2 3\n", TIA_WARN_LIBRARY, 1,
         "1:7: the line ends here, expected a file's name; its materials are grey", 1},
        {"cstype \\\n bezier\n" TRIANGLE "f 1 2 3\nsurf 0 1 \\\n0 1 1 2\n", TIA_WARN_STATEMENT, 2,
         "1:1: 'cstype' is not a statement, expected v, vt, vn, f, g, o, s, usemtl or mtllib; skipped", 1},
        {TRIANGLE "vn 0 0 1 0\nf 1 2 3\n", TIA_WARN_STATEMENT, 1,
         "4:10: '0' is too much, expected the end of the line; skipped", 1},
        {TRIANGLE "l 1 2\np 3\n", TIA_WARN_EMPTY, 1,
         "0:0: the model has no faces, expected some f; only the background is drawn", 0},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct files files = {.names = {"m"}, .texts = {library}};
        struct reading r;

        read_model(&r, &files, cases[i].text);
        check_warning(&files, cases[i].kind, cases[i].count, cases[i].want);
        CHECK_MSG(faces_of(&r.scene) == cases[i].faces, "%.40s: %u faces", cases[i].text, (unsigned)faces_of(&r.scene));
        finish(&r, &files);
        files.strict = true;
        read_obj(&r, &files, cases[i].text, strlen(cases[i].text));
        CHECK_MSG(r.status == TIA_ERR_RANGE && !strncmp(r.reader.error.text, strchr(cases[i].want, ' ') + 1, 12),
                  "strictly %d: %s", r.status, r.reader.error.text);
        finish(&r, &files);
    }
}

/* Parts that only some corners of a face have are not used; the others are. */
TEST(what_faces_become)
{
    struct files files = {.libraries = 0};
    struct reading r;

    read_model(&r, &files,
               TRIANGLE "vt 0 0\nvt 99999 -99999\nvn 0 0 0\nvn 0 0 5\nf 1/1/2 2/1/2 3/1/1\nf 1/1/2 2/2/2 3/1/2\n"
                        "f 1//2 2//2 3/1/2\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\n");
    const struct tia_mesh *mesh = r.scene.meshes;
    CHECK(mesh->face_count == 4);
    for (uint32_t i = 0; i < 12; i++) {
        const struct tia_corner *c = &mesh->faces[i / 3].corner[i % 3];
        CHECK_EQ(c->normal == TIA_NO_INDEX, i / 3 == 0);
        CHECK_EQ(c->uv == TIA_NO_INDEX, i / 3 == 2);
        CHECK_EQ(c->vertex, i % 3);
        if (c->normal != TIA_NO_INDEX)
            CHECK_EQ(mesh->normals[c->normal].z, TIA_Q30_ONE);
    }
    const struct tia_uv *far = &mesh->uvs[mesh->faces[1].corner[1].uv];
    CHECK(far->u == INT32_MAX && far->v == INT32_MIN);
    finish(&r, &files);
}

/* A missing material is found only in the second pass, when all materials are known, but not all groups. */
TEST(refused_in_the_second_pass)
{
    struct files files = {.strict = true};
    struct reading r;
    static const char text[] = "o a\n" TRIANGLE "usemtl none\nf 1 2 3\no b\no c\no d\n";

    read_obj(&r, &files, text, strlen(text));
    check_read_error(&r, "5:8: 'none' is not a material, expected one that a mtllib has");
    finish(&r, &files);
}

TEST(texts_of_other_systems)
{
    static const char text[] = "\xef\xbb\xbfmtllib my paint.mtl\r\nv 0 0 0\r\nv 1 \\\r\n 0 0\r\nv 0 1 0\r\n"
                               "usemtl deep red\r\nf 1 2 \\\r\n3\r\n";
    struct files files = {.names = {"my paint.mtl"}, .texts = {"\xef\xbb\xbfnewmtl deep red\r\nKd 1 0 0\r\n"}};
    struct reading r;

    read_model(&r, &files, text);
    CHECK_EQ(r.scene.meshes[0].face_count, 1);
    CHECK(r.scene.materials[r.scene.shapes[0].material].colour.r == TIA_Q30_ONE);
    for (unsigned i = 0; i < TIA_WARNINGS; i++)
        CHECK_EQ(files.warnings[i].count, 0);
    finish(&r, &files);
}

/* ---- libraries ---- */

static struct tia_material material_of(const char *statements, struct files *files)
{
    char text[500];
    struct tia_material m = {.exponent = 0};
    struct reading r;

    (void)snprintf(text, sizeof text, "newmtl m\n%s", statements);
    files->names[0] = "m";
    files->texts[0] = text;
    read_model(&r, files, "mtllib m\nusemtl m\n" TRIANGLE "f 1 2 3\n");
    if (!r.status)
        m = r.scene.materials[r.scene.shapes[0].material];
    finish(&r, files);
    return m;
}

TEST(mistakes_of_libraries)
{
    struct files files = {.libraries = 0};
    struct tia_material m = material_of("Kd 1.2 1 -1\nKs 2 2 2\nNs 10\n", &files);

    CHECK(m.colour.r == TIA_Q30_ONE && m.colour.b == 0 && m.specular.g == TIA_Q30_ONE);
    check_warning(&files, TIA_WARN_RANGE, 5,
                  "m:2:4: '1.2' is out of range, expected a number from 0 to 1; the nearest is used");
    m = material_of("Kd 0.5 0.5\nillum 11\nfoo 1\nKs 1\nNs 5\nNs x\nNi\nd 0.5 0.5\nmap_Kd\n", &files);
    CHECK(m.colour.r == TIA_Q30(0.4) && m.specular.r == TIA_Q30_ONE && m.exponent == TIA_Q16(5));
    CHECK(m.refraction.r == TIA_Q30(0.5) && !m.texture);
    check_warning(&files, TIA_WARN_STATEMENT, 7,
                  "m:2:11: the line ends here, expected a number below 2147483648; skipped");
    m = material_of("Ni 9\nillum 4\nTf 0.5\nNs -1\nKs 1\n", &files);
    CHECK(m.index == TIA_Q16(4) && !m.specular.r);
    check_warning(&files, TIA_WARN_RANGE, 2,
                  "m:2:4: '9' is out of range, expected an index of refraction from 0.25 to 4; the nearest is used");
    m = material_of("d 0.25\nTr 0.25\n", &files); /* some programs mean the same by both; d takes precedence */
    CHECK(m.refraction.r == TIA_Q30(0.75));
    m = material_of("Tr 0.25\nd 1\n", &files);
    CHECK(!m.refraction.r);
    m = material_of("map_Kd none.jpg\nKd 1 0 0\n", &files);
    CHECK(!m.texture && m.colour.r == TIA_Q30_ONE);
    check_warning(&files, TIA_WARN_IMAGE, 1,
                  "m:2:8: 'none.jpg' cannot be read: no such picture, expected an image; left out");
}

TEST(options_of_images)
{
    struct files files = {.libraries = 0};
    struct tia_material m =
        material_of("Kd 1 1 1\nmap_d -clamp on -mm 0.5 2 -s 2 half.ppm\nmap_Kd -cc on -blendu off a.ppm\n", &files);

    CHECK(m.opacity == 1 && m.texture == 2 && m.colour.r == TIA_Q30_ONE);
    check_warning(&files, TIA_WARN_OPTION, 4,
                  "m:3:7: '-clamp' has no effect here, expected -s, -o or -imfchan; ignored");
    m = material_of("Kd 1 1 1\nmap_d none\n", &files);
    CHECK(m.colour.r == TIA_Q30_ONE && !m.opacity);
    check_warning(&files, TIA_WARN_IMAGE, 1,
                  "m:3:7: 'none' cannot be read: no such picture, expected an image; left out");
}

int main(void)
{
    RUN(mistakes);
    RUN(what_faces_become);
    RUN(refused_in_the_second_pass);
    RUN(texts_of_other_systems);
    RUN(mistakes_of_libraries);
    RUN(options_of_images);
    return check_status();
}
