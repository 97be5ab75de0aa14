/* mtl.c - Wavefront's material libraries, .mtl, as tia understands them:
 *
 *     Kd Ke           diffuse and emission; Ke above 1 is 1, which is as white. Kd is 0.8 where there is none
 *     Ks Ns           highlight and its exponent, with illum 2 and more; Ks is the mirror too with illum 3 and more
 *     d, Tr           1 - d or Tr is let through: diffuse times d, refraction and what a shadow ray keeps
 *                     (1 - d) Tf
 *     Tf              1 where there is none; with illum 4, 6, 7, 9 and no d or Tr all of it is let through
 *     Ni              bends with illum 4, 6, 7, 9; else light goes straight on
 *     illum           2 where there is none; 0 is 1; Fresnel's equations with 5 and 7
 *     map_Kd          an image, bilinear; -s U V repeats it; other options are read and not used
 *
 * Ka, the other maps and what newer programs add are skipped; what is none of these is an error.
 */
#include "obj.h"
#include "read/surface.h"

struct mtl {
    struct obj *obj;
    struct tia_text text;
    bool open;
    struct tia_rgb kd, ks, ke, tf;
    tia_q30 opacity;
    bool has_opacity, has_filter;
    tia_q16 exponent, index;
    int64_t illum;
    uint32_t texture;
};

/* ---- what a material becomes ---- */

static bool is_one_of(int64_t illum, unsigned set)
{
    return set >> illum & 1;
}

#define MIRRORS (1u << 3 | 1u << 4 | 1u << 5 | 1u << 6 | 1u << 7 | 1u << 8 | 1u << 9)
#define BENDS (1u << 4 | 1u << 6 | 1u << 7 | 1u << 9)
#define FRESNEL (1u << 5 | 1u << 7)

static void close_material(struct mtl *m)
{
    struct tia_material made = {.emission = m->ke, .index = TIA_Q16_ONE, .texture = m->texture};
    bool bends = is_one_of(m->illum, BENDS);
    tia_q30 opacity = m->has_opacity ? m->opacity : bends && m->has_filter ? 0 : TIA_Q30_ONE;

    if (!m->open)
        return;
    made.colour = tia_rgb_product(m->kd, opacity);
    made.refraction = made.transmission = tia_rgb_product(m->tf, TIA_Q30_ONE - opacity);
    if (bends && m->index)
        made.index = m->index;
    made.fresnel = is_one_of(m->illum, FRESNEL);
    tia_set_highlight(&made, m->illum >= 2 ? m->ks : tia_grey(0), m->exponent);
    if (is_one_of(m->illum, MIRRORS))
        made.mirror = m->ks;
    tia_array_add(&m->obj->materials, &made);
}

static void open_material(struct mtl *m)
{
    *m = (struct mtl){.obj = m->obj,
                      .text = m->text,
                      .open = true,
                      .kd = tia_grey(TIA_Q30(0.8)),
                      .tf = tia_grey(TIA_Q30_ONE),
                      .opacity = TIA_Q30_ONE,
                      .index = TIA_Q16_ONE,
                      .illum = 2};
}

void tia_mtl_add_default(struct obj *o)
{
    struct mtl m = {.obj = o};

    open_material(&m);
    close_material(&m);
}

/* ---- statements ---- */

static int read_newmtl(struct mtl *m)
{
    struct tia_name name = {.kind = OBJ_MATERIAL, .index = m->obj->materials.count};
    int status = tia_obj_name(&m->text, &name.word, "a material's name");

    if (status)
        return status;
    close_material(m);
    open_material(m);
    name.index = m->obj->materials.count;
    if (m->obj->pass != OBJ_FILL)
        tia_array_add(&m->obj->names, &name);
    return TIA_OK;
}

/* A number in 0..1; where it may be more, that is 1. */
static int read_unit(struct tia_text *t, tia_q30 *out, bool may_be_more)
{
    struct tia_text before = *t;
    struct tia_word word;
    int64_t wide;

    (void)tia_text_peek(t, &word);
    int status = tia_text_q32(t, &wide);
    if (status)
        return status;
    if (wide < 0 || (wide > INT64_C(1) << 32 && !may_be_more))
        return tia_text_error(t, &word, "is out of range", "a number from 0 to 1");
    *out = TIA_Q30_ONE;
    if (wide >= INT64_C(1) << 32)
        return TIA_OK;
    *t = before;
    return tia_text_q30(t, out);
}

/* One number is a grey. */
static int read_colour(struct tia_text *t, struct tia_rgb *out, bool may_be_more)
{
    int status = read_unit(t, &out->r, may_be_more);

    *out = tia_grey(out->r);
    if (status || !tia_text_has_number(t))
        return status;
    status = read_unit(t, &out->g, may_be_more);
    return status ? status : read_unit(t, &out->b, may_be_more);
}

static int read_kd(struct mtl *m)
{
    return read_colour(&m->text, &m->kd, false);
}

static int read_ks(struct mtl *m)
{
    return read_colour(&m->text, &m->ks, false);
}

static int read_ke(struct mtl *m)
{
    return read_colour(&m->text, &m->ke, true);
}

static int read_tf(struct mtl *m)
{
    m->has_filter = true;
    return read_colour(&m->text, &m->tf, false);
}

static int read_ns(struct mtl *m)
{
    return tia_text_exponent(&m->text, &m->exponent);
}

static int read_d(struct mtl *m)
{
    struct tia_word word;

    if (tia_text_peek(&m->text, &word) && tia_word_is(&word, "-halo"))
        (void)tia_text_word(&m->text, &word);
    m->has_opacity = true;
    return read_unit(&m->text, &m->opacity, false);
}

static int read_tr(struct mtl *m)
{
    int status = read_d(m);

    m->opacity = TIA_Q30_ONE - m->opacity;
    return status;
}

static int read_ni(struct mtl *m)
{
    struct tia_word word;

    (void)tia_text_peek(&m->text, &word);
    int status = tia_text_q16(&m->text, &m->index);
    if (!status && m->index && (m->index < TIA_INDEX_MIN || m->index > TIA_INDEX_MAX))
        return tia_text_error(&m->text, &word, "is out of range", "an index of refraction from 0.25 to 4");
    return status;
}

static int read_illum(struct mtl *m)
{
    return tia_text_integer(&m->text, &m->illum, 0, 10);
}

/* ---- images ---- */

/* -s U [V [W]] gives the repeats; what else begins with - takes one to three words. */
static int read_option(struct tia_text *t, const struct tia_word *option, tia_q16 repeat[2])
{
    struct tia_word word;
    bool scales = tia_word_is(option, "-s");

    if (!scales && !tia_word_is(option, "-o") && !tia_word_is(option, "-t") && !tia_word_is(option, "-mm")) {
        (void)tia_text_word(t, &word);
        return TIA_OK;
    }
    for (int i = 0; i < 3 && tia_text_has_number(t); i++) {
        tia_q16 number;
        (void)tia_text_peek(t, &word);
        int status = tia_text_q16(t, &number);
        if (status)
            return status;
        if (scales && i < 2) {
            if (number < TIA_Q16_ONE / 1024 || number > TIA_Q16(1024))
                return tia_text_error(t, &word, "is out of range", "a number from 1/1024 to 1024");
            repeat[i] = number;
        }
    }
    return TIA_OK;
}

/* The image, fetched once however often it is named. */
static int fetch_image(struct mtl *m, const struct tia_word *name, struct tia_texture *texture)
{
    struct obj *o = m->obj;
    struct tia_name *known =
        tia_names_find((struct tia_name *)(void *)o->names.items, o->names.capacity, OBJ_IMAGE, name);
    const char *why = "there is nothing that could";
    char file[TIA_NAME_MAX + 1];

    if (known->index < o->textures.count) {
        *texture = ((struct tia_texture *)(void *)o->textures.items)[known->index];
        return TIA_OK;
    }
    *texture = (struct tia_texture){.kind = TIA_IMAGE};
    tia_word_copy(file, name);
    if (!o->reader->image || o->reader->image(o->reader->ctx, file, texture, &why) < 0) {
        (void)tia_text_error_at(&m->text, name);
        tia_say_word(m->text.error, name);
        tia_say(m->text.error, " cannot be read: ");
        tia_say(m->text.error, why);
        tia_say(m->text.error, ", expected an image");
        return TIA_ERR_RANGE;
    }
    known->index = o->textures.count;
    return TIA_OK;
}

static int read_map_kd(struct mtl *m)
{
    struct tia_texture texture = {.kind = TIA_IMAGE};
    struct tia_name name = {.kind = OBJ_IMAGE, .index = UINT32_MAX};
    tia_q16 repeat[2] = {TIA_Q16_ONE, TIA_Q16_ONE};
    struct tia_word word;
    int status = TIA_OK;

    while (!status && tia_text_peek(&m->text, &word) && *word.at == '-' && word.length > 1) {
        (void)tia_text_word(&m->text, &word);
        status = read_option(&m->text, &word, repeat);
    }
    status = status ? status : tia_obj_name(&m->text, &name.word, "an image's file name");
    if (!status && m->obj->pass == OBJ_FILL)
        status = fetch_image(m, &name.word, &texture);
    if (status)
        return status;
    if (m->obj->pass != OBJ_FILL)
        tia_array_add(&m->obj->names, &name);
    texture.kind = TIA_IMAGE;
    texture.bilinear = true;
    texture.repeat[0] = repeat[0];
    texture.repeat[1] = repeat[1];
    tia_array_add(&m->obj->textures, &texture);
    m->texture = m->obj->textures.count;
    return TIA_OK;
}

/* ---- all of it ---- */

static const struct {
    const char *name;
    int (*read)(struct mtl *);
} statements[] = {
    {"newmtl", read_newmtl}, {"Kd", read_kd},       {"Ks", read_ks},         {"Ke", read_ke},
    {"Tf", read_tf},         {"Ns", read_ns},       {"d", read_d},           {"Tr", read_tr},
    {"Ni", read_ni},         {"illum", read_illum}, {"map_Kd", read_map_kd},
};

static const char *const skipped[] = {
    "Ka",     "bump",   "disp",    "decal",       "refl",     "norm",     "sharpness", "Km",       "Pr",
    "Pm",     "Ps",     "Pc",      "Pcr",         "aniso",    "anisor",   "map_Ka",    "map_Ks",   "map_Ke",
    "map_Ns", "map_d",  "map_Tr",  "map_opacity", "map_bump", "map_Bump", "map_refl",  "map_Pr",   "map_Pm",
    "map_Ps", "map_Ni", "map_aat", "Kt",          "Tm",       "map_Disp", "map_disp",  "map_norm", "map_Norm"};

static int read_statement(struct mtl *m, const struct tia_word *word)
{
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (tia_word_is(word, statements[i].name)) {
            if (!m->open && i > 0)
                return tia_text_error(&m->text, word, "comes too early", "newmtl first");
            int status = statements[i].read(m);
            return status ? status : tia_text_end(&m->text);
        }
    for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
        if (tia_word_is(word, skipped[i])) {
            tia_text_skip(&m->text);
            return TIA_OK;
        }
    return tia_text_error(&m->text, word, "is no statement of a material", "newmtl, Kd, Ks, Ns, d or the like");
}

int tia_mtl_read(struct obj *o, const struct obj_library *library)
{
    char file[TIA_NAME_MAX + 1];
    struct mtl m = {.obj = o};
    struct tia_word word;

    tia_word_copy(file, &library->name);
    m.text = tia_text_begin(library->text, library->length, file, &o->reader->error);
    while (tia_text_line(&m.text)) {
        (void)tia_text_word(&m.text, &word);
        int status = read_statement(&m, &word);
        if (status)
            return status;
    }
    close_material(&m);
    return TIA_OK;
}
