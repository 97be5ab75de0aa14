/* The .mtl reader: the meaning of its statements. */
#include "obj_files.h"

/* Returns the material of a library with a single material, used by one triangle. */
static struct tia_material material_of(const char *statements)
{
    char library[500];
    struct files files = {.names = {"m"}, .texts = {library}};
    struct tia_material m = {.exponent = 0};
    struct reading r;

    (void)snprintf(library, sizeof library, "newmtl m\n%s", statements);
    read_model(&r, &files, "mtllib m\nusemtl m\n" TRIANGLE "f 1 2 3\n");
    if (!r.status)
        m = r.scene.materials[r.scene.shapes[0].material];
    finish(&r, &files);
    return m;
}

TEST(materials)
{
    struct tia_material m = material_of("");
    CHECK(m.colour.r == TIA_Q30(0.8) && !m.specular.r && !m.mirror.r && !m.refraction.r && !m.emission.r);
    m = material_of("Kd 0.5\nKe 3 0.5 0\nKs 0.1 0.2 0.3\nNs 1e6\nKa 1 1 1\nmap_bump -bm 2 x.png # nothing\n");
    CHECK(m.colour.b == TIA_Q30(0.5) && m.emission.r == TIA_Q30_ONE && m.emission.g == TIA_Q30(0.5) && !m.emission.b);
    CHECK(m.specular.b == TIA_Q30(0.3) && m.exponent == TIA_EXPONENT_MAX && !m.mirror.r && !m.fresnel);
    m = material_of("Ks 1 1 1\nNs 10\nillum 1\n");
    CHECK(!m.specular.r && !m.mirror.r);
    m = material_of("Ks 1 1 1\nillum 3\n");
    CHECK(!m.specular.r && m.mirror.r == TIA_Q30_ONE && !m.fresnel);
    m = material_of("Kd 1 1 1\nd 0.25\nNi 1.5\n");
    CHECK(m.colour.r == TIA_Q30(0.25) && m.refraction.r == TIA_Q30(0.75) && m.transmission.b == TIA_Q30(0.75));
    CHECK_EQ(m.index, TIA_Q16_ONE); /* illum 2 has no refraction */
    m = material_of("Tr 0.25\nillum 6\nNi 1.25\n");
    CHECK(m.refraction.r == TIA_Q30(0.25) && m.index == TIA_Q16(1.25) && !m.fresnel);
    m = material_of("Kd 1 1 1\nTf 0.5 0.25 1\nillum 7\nNi 1.25\nd -halo 0\n");
    CHECK(m.refraction.g == TIA_Q30(0.25) && m.fresnel && !m.colour.r);
    m = material_of("Tf 0.5 0.25 1\nillum 4\n");
    CHECK(m.refraction.g == TIA_Q30(0.25) && m.index == TIA_Q16_ONE);
    m = material_of("Tf 0.5 0.25 1\n");
    CHECK(!m.refraction.g && !m.transmission.g);
}

/* Programs that mean an opaque material write Tr 1 or d 0: it is drawn opaque, and the line is in a warning. */
TEST(materials_of_which_nothing_would_be_seen)
{
    static const struct {
        const char *statements, *warning; /* NULL: no warning, and the opacity stays */
        tia_q30 red;
    } cases[] = {
        {"Kd 1 0 0\nTr 1\n", "m:3:4: '1' hides the whole material, expected some opacity; drawn opaque", TIA_Q30_ONE},
        {"d 0\nKd 1 0 0\nTr 0.5\n", "m:2:3: '0' hides the whole material, expected some opacity; drawn opaque",
         TIA_Q30_ONE},
        {"Kd 1 0 0\nd 0\nmap_d x.png\n", "m:3:3: '0' hides the whole material, expected some opacity; drawn opaque",
         TIA_Q30_ONE},
        {"Kd 1 0 0\nTr 1\nd 0.5\n", NULL, TIA_Q30(0.5)},
        {"Kd 1 0 0\nTr 0.75\n", NULL, TIA_Q30(0.25)},
        {"Kd 1 0 0\nTr 1\nTf 1 0.5 1\n", NULL, 0},
        {"Kd 1 0 0\nd 0\nillum 7\nNi 1.5\n", NULL, 0},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char library[500], at[600] = "";
        struct files files = {.names = {"m"}, .texts = {library}};
        struct reading r;
        (void)snprintf(library, sizeof library, "newmtl m\n%s", cases[i].statements);
        read_model(&r, &files, "mtllib m\nusemtl m\n" TRIANGLE "f 1 2 3\n");
        const struct tia_read_warning *w = &files.warnings[TIA_WARN_OPACITY];
        CHECK_EQ(r.status, TIA_OK);
        CHECK_EQ(r.scene.materials[r.scene.shapes[0].material].colour.r, cases[i].red);
        if (w->count)
            (void)snprintf(at, sizeof at, "%s:%u:%u: %s", w->at.file, w->at.line, w->at.column, w->at.text);
        CHECK_EQ(w->count, cases[i].warning != NULL);
        CHECK_MSG(!strcmp(at, cases[i].warning ? cases[i].warning : ""), "%zu: %.400s", i, at);
        finish(&r, &files);
    }
}

TEST(images)
{
    struct files files = {
        .names = {"m", "n"},
        .texts = {"newmtl a\nmap_Kd -clamp off -s 2 0.5 1 -o 1 -7 my wood.ppm\nnewmtl b\nmap_Kd \"my wood.ppm\"\n",
                  "newmtl c\nmap_Kd other.ppm\nnewmtl a\nKd 0.125\n"}};
    struct reading r;

    read_model(&r, &files, "mtllib m n\nmtllib n m\n" TRIANGLE "usemtl b\nf 1 2 3\nusemtl a\nf 3 2 1\n");
    CHECK(r.scene.texture_count == 3 && files.images == 2 && r.scene.mesh_count == 2);
    CHECK(files.libraries == 2 * 3); /* tia_read was called three times */
    const struct tia_material *a = &r.scene.materials[r.scene.shapes[0].material];
    CHECK(a->colour.r == TIA_Q30(0.8) && a->texture == 1 && r.scene.materials[r.scene.shapes[1].material].texture == 2);
    CHECK(r.scene.textures[0].repeat[0] == TIA_Q16(2) && r.scene.textures[0].repeat[1] == TIA_Q16(0.5));
    CHECK(!r.scene.textures[0].offset[0] && !r.scene.textures[0].offset[1]); /* a whole number of images does not
                                                                                matter, as they repeat */
    CHECK(r.scene.textures[1].repeat[0] == TIA_Q16_ONE && r.scene.textures[1].width == 2 && r.scene.textures[1].texels);
    finish(&r, &files);
}

/* A texture's position is repeat (u - offset), while the format's is s u + o. */
TEST(offsets)
{
    struct files files = {.names = {"m"},
                          .texts = {"newmtl m\nmap_Kd -o 0.5 0.25 -s 2 0.5 a.ppm\nmap_d -o -0.25 -s 1024 b.ppm\n"}};
    struct reading r;

    read_model(&r, &files, "mtllib m\nusemtl m\n" TRIANGLE "f 1 2 3\n");
    CHECK_EQ(r.scene.texture_count, 2);
    const struct tia_texture *t = r.scene.textures;
    CHECK(t[0].offset[0] == TIA_Q16(-0.25) && t[0].offset[1] == TIA_Q16(-0.5)); /* 2 (u + 1/4), 1/2 (v + 1/2) */
    CHECK(t[1].offset[0] == TIA_Q16(-0.75 / 1024) && !t[1].offset[1] && t[1].repeat[1] == TIA_Q16_ONE);
    finish(&r, &files);
}

/* Each channel is fetched once, as a texture of its own; the colour's texture is a separate one. */
TEST(opacities)
{
    struct files files = {
        .names = {"m"},
        .texts = {"newmtl a\nmap_Kd x.ppm\nmap_d -s 3 2 x.ppm\nd 0.5\nKd 1 1 1\nTf 1 0.5 1\n"
                  "newmtl b\nmap_d x.ppm\nnewmtl c\nmap_d -imfchan r x.ppm\nnewmtl d\nmap_d -imfchan g x.ppm\n"
                  "newmtl e\nmap_d -imfchan b x.ppm\nnewmtl f\nmap_d -imfchan m x.ppm\n"
                  "newmtl g\nmap_d -imfchan l x.ppm\nnewmtl h\nmap_d whole.ppm\nnewmtl i\nmap_d none\n"}};
    struct reading r;

    read_model(&r, &files, "mtllib m\nusemtl a\n" TRIANGLE "f 1 2 3\n");
    CHECK(r.scene.texture_count == 10 && r.scene.material_count == 10 && files.images == 1);
    CHECK_EQ(files.opacities, 8);
    const struct tia_material *m = r.scene.materials + 1;
    const struct tia_texture *t = r.scene.textures;
    CHECK(m[0].texture == 1 && m[0].opacity == 2 && t[0].kind == TIA_IMAGE && t[1].kind == TIA_OPACITY);
    CHECK(t[1].repeat[0] == TIA_Q16(3) && t[1].repeat[1] == TIA_Q16(2) && t[1].bilinear && t[1].texels == t[2].texels);
    CHECK(m[0].colour.r == TIA_Q30(0.5) && m[0].refraction.g == TIA_Q30(0.25) && m[0].transmission.g == TIA_Q30(0.25));
    for (uint32_t i = 1; i < 7; i++) /* the six channels, in the order of their numbers from 0 */
        CHECK(!m[i].texture && m[i].opacity == i + 2 && *t[i + 1].texels == i - 1);
    CHECK(!m[7].opacity && !m[8].opacity); /* opaque; missing */
    finish(&r, &files);
}

TEST(errors_of_libraries)
{
    static const struct wrong cases[] = {
        {"Kd 1 1 1\n", "m:1:1: 'Kd' comes too early, expected newmtl first"},
        {"newmtl\n", "m:1:7: the line ends here, expected a material's name"},
        {"newmtl m\nKd 1 1.5 1\n", "m:2:6: '1.5' is out of range, expected a number from 0 to 1"},
        {"newmtl m\nKs -1\n", "m:2:4: '-1' is out of range, expected a number from 0 to 1"},
        {"newmtl m\n  Kd spectral x.rfl\n", "m:2:6: 'spectral' is not a number, expected a number below 2147483648"},
        {"newmtl m\nillum 11\n", "m:2:7: '11' is out of range, expected a whole number from 0 to 10"},
        {"newmtl m\nNi 5\n", "m:2:4: '5' is out of range, expected an index of refraction from 0.25 to 4"},
        {"newmtl m\nd 1 1\n", "m:2:5: '1' is too much, expected the end of the line"},
        {"newmtl m\nwhat 1\n",
         "m:2:1: 'what' is not a statement of a material, expected newmtl, Kd, Ks, Ns, d or the like"},
        {"newmtl m\nmap_Kd -s 2000 a.ppm\n", "m:2:11: '2000' is out of range, expected a number from 1/1024 to 1024"},
        {"newmtl m\nmap_Kd -clamp on a.ppm\n", "m:2:8: '-clamp' has no effect here, expected -s, -o or -imfchan"},
        {"newmtl m\nmap_d -imfchan z a.ppm\n", "m:2:7: '-imfchan' has no effect here, expected -s, -o or -imfchan"},
        {"newmtl m\nmap_d -mm 0.1 1 a.ppm\n", "m:2:7: '-mm' has no effect here, expected -s, -o or -imfchan"},
        {"newmtl m\nmap_d -t 0 0 1 a.ppm\n", "m:2:7: '-t' has no effect here, expected -s, -o or -imfchan"},
        {"newmtl m\nmap_d -blendv off a.ppm\n", "m:2:7: '-blendv' has no effect here, expected -s, -o or -imfchan"},
        {"newmtl m\nmap_d -mm 0 1 -t 0 -cc off -blendu on -texres 64 no.jpg\n",
         "m:2:50: 'no.jpg' cannot be read: no such picture, expected an image"},
        {"newmtl m\nmap_Kd -s 2\n", "m:2:12: the line ends here, expected an image's file name"},
        {"newmtl m\nmap_Kd no.jpg\n", "m:2:8: 'no.jpg' cannot be read: no such picture, expected an image"},
    };
    struct reading r;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct files files = {.names = {"m"}, .texts = {cases[i].text}, .strict = true};
        const char text[] = "mtllib m\n" TRIANGLE "f 1 2 3\n";
        read_obj(&r, &files, text, strlen(text));
        check_read_error(&r, cases[i].want);
    }
}

int main(void)
{
    RUN(materials);
    RUN(materials_of_which_nothing_would_be_seen);
    RUN(images);
    RUN(offsets);
    RUN(opacities);
    RUN(errors_of_libraries);
    return check_status();
}
