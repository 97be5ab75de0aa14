/* The .obj and .mtl readers: models written by hand and those of scenes/obj, with areas and frames computed in
 * double. */
#include <math.h>

#include "obj_files.h"

static double at(const struct tia_vec3 *v, int axis)
{
    return (axis == 0 ? v->x : axis == 1 ? v->y : v->z) / 65536.0;
}

/* Returns the area of a mesh, and gives its volume if it is closed and its faces run counterclockwise seen from
 * outside. */
static double area_of(const struct tia_mesh *mesh, double *volume)
{
    double area = 0;

    *volume = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double e[2][3], n[3], square = 0;
        const struct tia_vec3 *a = &mesh->vertices[mesh->faces[f].corner[0].vertex];
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++)
                e[k][i] = at(&mesh->vertices[mesh->faces[f].corner[k + 1].vertex], i) - at(a, i);
        for (int i = 0; i < 3; i++) {
            n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
            square += n[i] * n[i];
            *volume += n[i] * at(a, i) / 6;
        }
        area += sqrt(square) / 2;
    }
    return area;
}

static bool is_near(double a, double b, double by)
{
    return fabs(a - b) <= by;
}

TEST(crate)
{
    struct files files = {.libraries = 0};
    struct reading r;
    double volume;
    char *text;

    if (!load(&r, &files, &text, SCENES "crate.obj"))
        return;
    CHECK(r.scene.mesh_count == 2 && r.scene.shape_count == 2 && r.scene.texture_count == 1);
    CHECK(is_near(area_of(&r.scene.meshes[0], &volume), 24, 1e-9) && is_near(volume, 8, 1e-9));
    CHECK(is_near(area_of(&r.scene.meshes[1], &volume), 64, 1e-9));
    CHECK(r.scene.meshes[0].vertex_count == 8 && r.scene.meshes[0].uv_count == 4 &&
          r.scene.meshes[1].vertex_count == 4);
    CHECK(r.scene.meshes[1].vertices[0].x == TIA_Q16(-4) && r.scene.meshes[1].vertices[0].z == TIA_Q16(4));
    CHECK(r.scene.meshes[1].uv_count == 0 && r.scene.meshes[1].faces[0].corner[2].uv == TIA_NO_INDEX);
    CHECK(r.scene.meshes[0].uvs[0].u == 0 && r.scene.meshes[0].uvs[0].v == 0);
    CHECK(r.scene.meshes[0].uvs[2].u == TIA_Q16_ONE && r.scene.meshes[0].uvs[2].v == TIA_Q16_ONE);
    const struct tia_material *wood = &r.scene.materials[r.scene.shapes[0].material];
    const struct tia_material *floor_of = &r.scene.materials[r.scene.shapes[1].material];
    CHECK(wood->texture == 1 && wood->colour.r == TIA_Q30_ONE && wood->specular.g == TIA_Q30(0.2));
    CHECK(wood->exponent == TIA_Q16(20) && !wood->mirror.r && !wood->refraction.r);
    CHECK(floor_of->texture == 0 && floor_of->colour.g == TIA_Q30(0.6));
    CHECK(r.scene.textures[0].width == 2 && r.scene.textures[0].texels[5] == 6 && r.scene.textures[0].bilinear);
    CHECK(r.scene.textures[0].kind == TIA_IMAGE && r.scene.textures[0].repeat[1] == TIA_Q16_ONE);
    CHECK(files.images == 1);
    finish(&r, &files);
    free(text);
}

TEST(ball)
{
    struct files files = {.libraries = 0};
    struct reading r;
    double volume;
    char *text;

    if (!load(&r, &files, &text, SCENES "ball.obj"))
        return;
    const struct tia_mesh *mesh = r.scene.meshes;
    CHECK(mesh->face_count == 320 && mesh->vertex_count == 162 && mesh->normal_count == 162);
    /* slightly less than 4 pi r^2 and 4/3 pi r^3 */
    CHECK(is_near(area_of(mesh, &volume), 50.27, 1.2) && is_near(volume, 33.51, 1.2) && volume < 33.51);
    for (uint32_t i = 0; i < 320 * 3; i++) {
        const struct tia_corner *c = &mesh->faces[i / 3].corner[i % 3];
        CHECK(c->normal == c->vertex && c->uv == TIA_NO_INDEX);
        CHECK(is_near(mesh->normals[c->normal].y / 1073741824.0 * 2, at(&mesh->vertices[c->vertex], 1), 1e-4));
    }
    CHECK(r.scene.material_count == 1 && r.scene.materials[0].colour.r == TIA_Q30(0.8) && !r.scene.texture_count);
    finish(&r, &files);
    free(text);
}

TEST(star_of_glass)
{
    struct files files = {.libraries = 0};
    struct reading r;
    double volume;
    char *text;

    if (!load(&r, &files, &text, SCENES "star.obj"))
        return;
    /* ten triangles of sides 2 and 0.8 and 36 degrees, 0.8 thick */
    double front = 10 * 0.5 * 2 * 0.8 * sin(0.6283185307179586);
    CHECK_EQ(r.scene.meshes[0].face_count, 8 + 8 + 20);
    (void)area_of(r.scene.meshes, &volume);
    CHECK_MSG(is_near(volume, front * 0.8, 1e-3), "volume %g, not %g", volume, front * 0.8);
    const struct tia_material *m = &r.scene.materials[r.scene.shapes[0].material];
    CHECK(m->fresnel && m->index == TIA_Q16(1.5) && m->mirror.b == TIA_Q30(0.3));
    CHECK(abs(m->colour.b - TIA_Q30(0.225)) <= 1 && abs(m->refraction.r - TIA_Q30(0.675)) <= 1);
    CHECK(m->refraction.g == TIA_Q30(0.75) && m->transmission.r == m->refraction.r);
    finish(&r, &files);
    free(text);
}

/* Projects a point by a camera as any viewer does: its position in the picture, from -1 to 1 along the shorter side. */
static void project(const struct tia_camera *c, const struct tia_vec3 *p, double *x, double *y, double *distance)
{
    double n[3], v[3], length = 0, square = 0;

    for (int i = 0; i < 3; i++) {
        n[i] = at(&c->eye, i) - at(&c->reference, i);
        v[i] = at(p, i) - at(&c->eye, i);
        length += n[i] * n[i];
        square += v[i] * v[i];
    }
    for (int i = 0; i < 3; i++)
        n[i] /= sqrt(length);
    double ux = n[2], uz = -n[0], u = sqrt(ux * ux + uz * uz); /* (0, 1, 0) x n */
    double right[3] = {ux / u, 0, uz / u};
    double up[3] = {n[1] * right[2], n[2] * right[0] - n[0] * right[2], -n[1] * right[0]}, depth = 0;
    double tangent = tan(c->fov / 65536.0 * 3.141592653589793 / 360);

    *x = *y = 0;
    for (int i = 0; i < 3; i++) {
        depth -= n[i] * v[i];
        *x += right[i] * v[i];
        *y += up[i] * v[i];
    }
    *x /= depth * tangent;
    *y /= depth * tangent;
    *distance = sqrt(square);
}

/* Checks that all of the model is in the picture and near enough, and that it is not tiny. */
static void check_frame(const struct tia_scene *scene)
{
    const struct tia_camera *c = &scene->camera;
    double most = 0;

    CHECK(c->eye.x > c->reference.x && c->eye.y > c->reference.y && c->eye.z > c->reference.z);
    CHECK(scene->light_count == 2 && scene->lights[0].direction.y < 0 && scene->background.r == TIA_Q30(0.8));
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        for (uint32_t i = 0; i < 3 * scene->meshes[m].face_count; i++) {
            double x, y, distance;
            const struct tia_mesh *mesh = &scene->meshes[m];
            project(c, &mesh->vertices[mesh->faces[i / 3].corner[i % 3].vertex], &x, &y, &distance);
            CHECK_MSG(hypot(x, y) <= 1.0001 && distance < 32768, "at %g, %g, %g away", x, y, distance);
            most = fmax(most, hypot(x, y));
        }
    CHECK_MSG(most > 0.4, "it fills only %g of the picture", most);
}

/* Boxes of any size and position have the same picture. */
TEST(frames)
{
    static const struct {
        const char *numbers[4]; /* lower and upper end, the same for x, y and z */
        bool moved;
    } cases[] = {
        {{"-1", "1"}, false},
        {{"-4096", "4096"}, false},
        {{"-4097", "4096"}, true},
        {{"0", "1"}, false},
        {{"0", "0.99"}, true},
        {{"1000000", "1000010"}, true},
        {{"0", "0.0001"}, true},
        {{"-2e9", "2e9"}, true},
        {{"-2147483000", "-2147482000.5"}, true},
        {{"5e-5", "9.5e-5"}, true},
        {{"-0.0000200", "0.00002"}, true},
    };
    char text[600];
    struct files files = {.libraries = 0};
    struct reading r;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *a = cases[i].numbers[0], *b = cases[i].numbers[1];
        (void)snprintf(text, sizeof text, "v %s %s %s\nv %s %s %s\nv %s %s %s\nv %s %s %s\nf 1 2 3 4\n", a, a, a, b, a,
                       b, b, b, b, a, b, a);
        read_model(&r, &files, text);
        if (r.status)
            continue;
        check_frame(&r.scene);
        const struct tia_vec3 *v = r.scene.meshes[0].vertices;
        double size = at(&v[2], 0) - at(&v[0], 0), want = strtod(b, NULL) - strtod(a, NULL);
        if (cases[i].moved) {
            double scale = log2(size / want);
            CHECK(is_near(at(&v[0], 1), -at(&v[2], 1), 0.02) && fabs(at(&v[0], 2)) <= 16.1);
            CHECK_MSG(size > 15.9 && size <= 32.1, "%s: size %g", a, size);
            CHECK_MSG(fabs(scale - round(scale)) < 0.01, "%s: scale %g", a, scale);
        } else {
            CHECK(is_near(size, want, 1e-9) && v[0].x == TIA_Q16_ONE * strtod(a, NULL));
        }
        finish(&r, &files);
    }
}

TEST(frames_of_models)
{
    static const char *const paths[] = {SCENES "crate.obj", SCENES "ball.obj", SCENES "star.obj"};

    for (int i = 0; i < 3; i++) {
        struct files files = {.libraries = 0};
        struct reading r;
        char *text;

        if (load(&r, &files, &text, paths[i]))
            check_frame(&r.scene);
        finish(&r, &files);
        free(text);
    }
}

/* Materials that alternate make one mesh each, with no more vertices than it needs. */
TEST(faces_by_material)
{
    struct files files = {.names = {"m"}, .texts = {"newmtl a b\nnewmtl c\nnewmtl unused\n"}};
    struct reading r;

    read_model(&r, &files,
               "mtllib m\n" TRIANGLE
               "v 5 5 5 1 0.5 0.5 0.5\nv 6 5 5\nv 5 6 5\nvn 1 0 0\nvn 0 0 3\nf 1 2 3\nusemtl a b\nf 4 5 6\n"
               "usemtl c\nf 1//2 2//2 3//-1\nusemtl a b\nf -1 -2 -3\n");
    CHECK(r.scene.mesh_count == 3 && r.scene.shapes[0].material == 0);
    CHECK(r.scene.meshes[0].face_count == 1 && r.scene.meshes[1].face_count == 2 && r.scene.meshes[2].face_count == 1);
    CHECK(r.scene.meshes[1].vertex_count == 3 && r.scene.meshes[1].vertices[0].x == TIA_Q16(5));
    CHECK(r.scene.meshes[1].faces[1].corner[0].vertex == 2 && r.scene.meshes[1].faces[1].corner[2].vertex == 0);
    CHECK(r.scene.meshes[2].normal_count == 1 && r.scene.meshes[2].normals[0].z == TIA_Q30_ONE);
    CHECK(r.scene.meshes[2].faces[0].corner[2].normal == 0 && r.scene.meshes[0].normal_count == 0);
    finish(&r, &files);
}

#define OUT_OF_Q16 "' is out of range, expected a number from -32768 to below 32768"

/* Some programs write the slashes of parts that a corner does not have. */
TEST(corners_with_empty_parts)
{
    static const char *const corners[] = {"f 1// 2// 3//\n", "f 1/2/ 2/2/ 3/1/\n", "f -3// 2 3\n"};

    for (int i = 0; i < 3; i++) {
        struct files files = {.strict = true};
        struct reading r;
        char text[200];
        (void)snprintf(text, sizeof text, TRIANGLE "vt 0 0\nvt 1 0.5\n%s", corners[i]);
        read_model(&r, &files, text);
        if (!r.status) {
            const struct tia_face *face = &r.scene.meshes[0].faces[0];
            CHECK(r.scene.meshes[0].face_count == 1 && face->corner[1].vertex == 1 && face->corner[2].vertex == 2);
            CHECK_EQ(face->corner[0].normal, TIA_NO_INDEX);
            CHECK_EQ(face->corner[0].uv, i == 1 ? 1 : TIA_NO_INDEX);
        }
        finish(&r, &files);
    }
}

/* Faces after lines with the same names are one group; an o is not a g; the faces before the first line are a group
 * too. */
TEST(groups)
{
    static const uint8_t same[] = {0, 1, 2, 1, 3, 4, 3, 5}; /* faces of equal numbers */
    static const char faces[] =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng a b\nf 1 2 3\ng b\nf 1 2 3\ng a b # again\nf 1 2 3\n"
        "o a b\nf 1 2 3\ng\nf 1 2 3\no a b\nf 1 2 3\ng a\nf 1 2 3\n";
    struct reading r;

    read_string(&r, TIA_FORMAT_OBJ, faces);
    CHECK_EQ(r.status, TIA_OK);
    CHECK(r.scene.mesh_count == 1 && r.scene.meshes[0].face_count == 8 && r.scene.meshes[0].groups);
    for (uint32_t i = 0; i < 64 && !check_failed; i++) {
        const uint32_t *g = r.scene.meshes[0].groups;
        CHECK_MSG((g[i / 8] == g[i % 8]) == (same[i / 8] == same[i % 8]), "faces %u, %u: %u, %u", i / 8, i % 8,
                  g[i / 8], g[i % 8]);
    }
    read_end(&r);
    read_string(&r, TIA_FORMAT_OBJ, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(!r.status && r.scene.mesh_count == 1 && !r.scene.meshes[0].groups);
    read_end(&r);
}

TEST(errors)
{
    static const struct wrong cases[] = {
        {"", "0:0: the model has no faces, expected some f"},
        {TRIANGLE, "0:0: the model has no faces, expected some f"},
        {"v 0 0 0\nf 1 1 1\n", "0:0: the model is too small, expected an extent of more than 1/32768"},
        {TRIANGLE "v 3 3 3\nf 1 1 1\n", "0:0: all faces lie in one point, expected a model"},
        {"v 1 2\n", "1:6: the line ends here, expected a number below 2147483648"},
        {"v 1 2 x\n", "1:7: 'x' is not a number, expected a number below 2147483648"},
        {"v 1 2 3e9\n", "1:7: '3e9' is out of range, expected a number below 2147483648"},
        {"vt 40000\n", "1:4: '40000" OUT_OF_Q16},
        {"vt 0 -32769\n", "1:6: '-32769" OUT_OF_Q16},
        {"vn 0 0 0\n", "1:4: '0' begins a direction of no length, expected three numbers that are not all 0"},
        {"face 1 2 3\n", "1:1: 'face' is not a statement, expected v, vt, vn, f, g, o, s, usemtl or mtllib"},
        {TRIANGLE "f 1 2\n", "4:6: the line ends here, expected V, V/VT, V//VN or V/VT/VN"},
        {TRIANGLE "f 1 2 4\n",
         "4:7: '4' refers to a vertex that does not exist, expected 1 to 3, those before this line"},
        {TRIANGLE "f 1 2 -4\n",
         "4:7: '-4' refers to a vertex that does not exist, expected 1 to 3, those before this line"},
        {TRIANGLE "f 1 2 18446744073709551617\n",
         "4:7: '18446744073709551617' refers to a vertex that does not exist, expected 1 to 3, those before this line"},
        {TRIANGLE "f 1//1 2//1 3//1\n",
         "4:3: '1//1' refers to a normal that does not exist, expected one before this line"},
        {TRIANGLE "vt 0 0\nf 1/2 2/1 3/1\n",
         "5:3: '1/2' refers to a texture coordinate that does not exist, expected 1 to 1, those before this line"},
        {TRIANGLE "vt 0\nf 1/1 2/1 3\n", "5:11: '3' is of another form, expected all corners of a face alike"},
        {TRIANGLE "f 0 1 2\n", "4:3: '0' is not a corner, expected V, V/VT, V//VN or V/VT/VN"},
        {TRIANGLE "f 1/ 1 2\n", "4:3: '1/' is not a corner, expected V, V/VT, V//VN or V/VT/VN"},
        {TRIANGLE "f 1/// 1 2\n", "4:3: '1///' is not a corner, expected V, V/VT, V//VN or V/VT/VN"},
        {TRIANGLE "f 1/1/1/1 1 2\n", "4:3: '1/1/1/1' is not a corner, expected V, V/VT, V//VN or V/VT/VN"},
        {TRIANGLE "usemtl none\nf 1 2 3\n", "4:8: 'none' is not a material, expected one that a mtllib has"},
        {"mtllib none.mtl\n", "1:8: 'none.mtl' cannot be read: no such file, expected a material library"},
        {"mtllib\n", "1:7: the line ends here, expected a file's name"},
        {"\x7f\x45LF\x02", "1:1: '?ELF\?' is not a statement, expected v, vt, vn, f, g, o, s, usemtl or mtllib"},
        {"mtllib q0 q1 q2 q3 q4 q5 q6 q7 q8 q9 qa qb qc qd qe qf q0 qg\n",
         "1:59: 'qg' is one too many, expected at most 16 material libraries"},
    };
    struct files files = {
        .names = {"q0", "q1", "q2", "q3", "q4", "q5", "q6", "q7", "q8", "q9", "qa", "qb", "qc", "qd", "qe", "qf"},
        .strict = true,
        .texts = {"", "", "", "", "", "", "", "", "", "", "", "", "", "", "", ""}};
    struct reading r;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        read_obj(&r, &files, cases[i].text, strlen(cases[i].text));
        check_read_error(&r, cases[i].want);
    }
    r = (struct reading){.reader = {.format = TIA_FORMAT_OBJ, .text = "mtllib a.mtl\n", .length = 13, .strict = true}};
    read_begin(&r);
    check_read_error(&r, "1:8: 'a.mtl' cannot be read: no files can be loaded here, expected a material library");
}

TEST(too_many_corners)
{
    static char text[5 * 4200];
    struct files files = {.libraries = 0};
    struct reading r;
    size_t length = (size_t)sprintf(text, TRIANGLE "f");

    for (int i = 0; i < 4096; i++)
        length += (size_t)sprintf(text + length, " %d", i % 3 + 1);
    read_obj(&r, &files, text, length);
    CHECK(!r.status && r.scene.meshes[0].face_count == 4094);
    finish(&r, &files);
    strcpy(text + length, " 1");
    read_obj(&r, &files, text, length + 2);
    check_read_error(&r, "4:8195: '1' is one too many, expected at most 4096 corners");
}

TEST(truncated)
{
    const char *paths[] = {SCENES "crate.obj", SCENES "star.obj"};

    for (int i = 0; i < 2; i++) {
        struct files files = {.names = {"crate.mtl", "star.mtl"},
                              .texts = {"newmtl wood\nmap_Kd a.ppm\nnewmtl floor\n", "newmtl glass\n"}};
        struct reading r;
        char *text;

        if (load(&r, &files, &text, paths[i])) {
            read_end(&r);
            check_truncated(&r.reader);
        }
        finish(&r, &files);
        free(text);
    }
}

int main(void)
{
    RUN(crate);
    RUN(ball);
    RUN(star_of_glass);
    RUN(frames);
    RUN(frames_of_models);
    RUN(faces_by_material);
    RUN(corners_with_empty_parts);
    RUN(groups);
    RUN(errors);
    RUN(too_many_corners);
    RUN(truncated);
    return check_status();
}
