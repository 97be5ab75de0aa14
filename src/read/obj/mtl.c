/* mtl.c - Wavefront's material libraries, .mtl, and the meaning of their statements:
 *
 *     Kd Ke           diffuse and emission; Ke is clamped to 1. Kd is 0.8 by default
 *     Ks Ns           highlight and its exponent, with illum 2 and above; with illum 3 to 9 Ks is the mirror too
 *     d, Tr           opacity, and 1 - opacity; d takes precedence. Kd is multiplied by the opacity; refraction and
 *                     the transmission of shadow rays are (1 - opacity) Tf
 *                     An opacity of 0 counts as 1, with a warning, if illum and Tf leave nothing visible: some programs
 *                     write Tr 1 for opaque materials
 *     Tf              1 by default; with illum 4, 6, 7, 9 a Tf without d and Tr sets the opacity to 0
 *     Ni              index of refraction with illum 4, 6, 7, 9; otherwise light is not bent
 *     illum           2 by default; 0 means 1; Fresnel's equations apply with 5 and 7
 *     map_Kd          an image, bilinear
 *     map_d           the material's opacity texture, see mtl_map.c. Where it is 0 there is no surface, and Tf
 *                     filters nothing: the format defines that dissolving has no colour
 *
 * Ka, the other maps and newer programs' extensions are skipped silently. A mistake causes a warning, see obj.c.
 */
#include "mtl.h"
#include "read/surface.h"

/* ---- completing a material ---- */

static bool is_one_of(int64_t illum, unsigned set)
{
    return set >> illum & 1;
}

#define MIRRORS (1u << 3 | 1u << 4 | 1u << 5 | 1u << 6 | 1u << 7 | 1u << 8 | 1u << 9)
#define BENDS (1u << 4 | 1u << 6 | 1u << 7 | 1u << 9)
#define FRESNEL (1u << 5 | 1u << 7)

/* Makes a material opaque if its opacity of 0 would make it invisible: it neither bends nor filters light. */
static int keep_visible(struct mtl *m)
{
    const tia_q30 one = TIA_Q30_ONE;

    if (!(m->has_d || m->has_tr) || m->opacity > 0 || is_one_of(m->illum, BENDS) || m->tf.r < one || m->tf.g < one ||
        m->tf.b < one)
        return TIA_OK;
    m->opacity = one;
    (void)tia_text_error(&m->opacity_text, &m->opacity_word, "hides the whole material", "some opacity");
    return tia_obj_forgive(m->obj, TIA_WARN_OPACITY);
}

static int close_material(struct mtl *m)
{
    struct tia_material made = {
        .emission = m->ke, .index = TIA_Q16_ONE, .texture = m->texture, .opacity = m->opacity_texture};
    bool bends = is_one_of(m->illum, BENDS);
    int status = keep_visible(m);
    tia_q30 opacity = m->has_d || m->has_tr ? m->opacity : bends && m->has_filter ? 0 : TIA_Q30_ONE;

    if (!m->open || status)
        return status;
    made.colour = tia_rgb_product(m->kd, opacity);
    made.refraction = made.transmission = tia_rgb_product(m->tf, TIA_Q30_ONE - opacity);
    if (bends && m->index)
        made.index = m->index;
    made.fresnel = is_one_of(m->illum, FRESNEL);
    tia_set_highlight(&made, m->illum >= 2 ? m->ks : tia_grey(0), m->exponent);
    if (is_one_of(m->illum, MIRRORS))
        made.mirror = m->ks;
    tia_array_add(&m->obj->materials, &made);
    return TIA_OK;
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
    (void)close_material(&m); /* no error: the material is opaque */
}

/* ---- statements ---- */

/* Begins a material. Its name may be missing: some programs write and use materials without names. */
static int read_newmtl(struct mtl *m)
{
    struct tia_name name = {.kind = OBJ_MATERIAL, .index = m->obj->materials.count};
    int status = tia_obj_name(&m->text, &name.word, "a material's name");

    if (status)
        status = tia_obj_forgive(m->obj, TIA_WARN_STATEMENT);
    status = status ? status : close_material(m);
    if (status)
        return status;
    open_material(m);
    name.index = m->obj->materials.count;
    if (m->obj->pass != OBJ_FILL) {
        tia_array_add(&m->obj->names, &name);
    } else if (m->obj->reader->material) {
        char copy[TIA_NAME_MAX + 1];
        tia_word_copy(copy, &name.word);
        m->obj->reader->material(m->obj->reader->ctx, name.index, copy);
    }
    return TIA_OK;
}

/* Reads a number in 0..1; if `may_be_more`, larger ones count as 1. */
static int read_unit(struct mtl *m, tia_q30 *out, bool may_be_more)
{
    struct tia_text before = m->text;
    struct tia_word word;
    int64_t wide;

    (void)tia_text_peek(&m->text, &word);
    int status = tia_text_q32(&m->text, &wide);
    if (status)
        return status;
    *out = wide < 0 ? 0 : TIA_Q30_ONE;
    if (wide < 0 || (wide > INT64_C(1) << 32 && !may_be_more)) {
        (void)tia_text_error(&m->text, &word, "is out of range", "a number from 0 to 1");
        return tia_obj_forgive(m->obj, TIA_WARN_RANGE);
    }
    if (wide >= INT64_C(1) << 32)
        return TIA_OK;
    m->text = before;
    return tia_text_q30(&m->text, out);
}

/* Reads a colour; a single number is a grey. If a number cannot be read, the colour does not change. */
static int read_colour(struct mtl *m, struct tia_rgb *out, bool may_be_more)
{
    struct tia_rgb colour;
    int status = read_unit(m, &colour.r, may_be_more);

    if (status)
        return status;
    colour = tia_grey(colour.r);
    if (tia_text_has_number(&m->text)) {
        status = read_unit(m, &colour.g, may_be_more);
        status = status ? status : read_unit(m, &colour.b, may_be_more);
    }
    if (!status)
        *out = colour;
    return status;
}

static int read_kd(struct mtl *m)
{
    return read_colour(m, &m->kd, false);
}

static int read_ks(struct mtl *m)
{
    return read_colour(m, &m->ks, false);
}

static int read_ke(struct mtl *m)
{
    return read_colour(m, &m->ke, true);
}

static int read_tf(struct mtl *m)
{
    int status = read_colour(m, &m->tf, false);

    m->has_filter |= !status;
    return status;
}

static int read_ns(struct mtl *m)
{
    struct tia_word word;
    tia_q16 exponent;

    (void)tia_text_peek(&m->text, &word);
    int status = tia_text_exponent(&m->text, &exponent);
    if (status)
        return status;
    m->exponent = exponent < 0 ? 0 : exponent;
    if (exponent >= 0)
        return TIA_OK;
    (void)tia_text_error(&m->text, &word, "is out of range", "0 or more");
    return tia_obj_forgive(m->obj, TIA_WARN_RANGE);
}

/* Reads a number from 0 to 1, and sets the opacity; d takes precedence over a later Tr. */
static int read_opacity(struct mtl *m, bool is_transparency)
{
    struct tia_text line = m->text;
    struct tia_word word;
    tia_q30 number;

    (void)tia_text_peek(&m->text, &word);
    int status = read_unit(m, &number, false);
    if (status || (is_transparency && m->has_d))
        return status;
    m->opacity = is_transparency ? TIA_Q30_ONE - number : number;
    m->opacity_text = line;
    m->opacity_word = word;
    return TIA_OK;
}

static int read_d(struct mtl *m)
{
    struct tia_word word;

    if (tia_text_peek(&m->text, &word) && tia_word_is(&word, "-halo"))
        (void)tia_text_word(&m->text, &word);
    int status = read_opacity(m, false);
    m->has_d |= !status;
    return status;
}

static int read_tr(struct mtl *m)
{
    int status = read_opacity(m, true);

    m->has_tr |= !status;
    return status;
}

static int read_ni(struct mtl *m)
{
    struct tia_word word;
    tia_q16 index;

    (void)tia_text_peek(&m->text, &word);
    int status = tia_text_q16(&m->text, &index);
    if (status)
        return status;
    m->index = !index || index > TIA_INDEX_MIN ? index : TIA_INDEX_MIN;
    m->index = index < TIA_INDEX_MAX ? m->index : TIA_INDEX_MAX;
    if (m->index == index)
        return TIA_OK;
    (void)tia_text_error(&m->text, &word, "is out of range", "an index of refraction from 0.25 to 4");
    return tia_obj_forgive(m->obj, TIA_WARN_RANGE);
}

static int read_illum(struct mtl *m)
{
    int64_t illum;
    int status = tia_text_integer(&m->text, &illum, 0, 10);

    if (!status)
        m->illum = illum;
    return status;
}

/* ---- the whole library ---- */

static const struct {
    const char *name;
    int (*read)(struct mtl *);
} statements[] = {
    {"newmtl", read_newmtl},
    {"Kd", read_kd},
    {"Ks", read_ks},
    {"Ke", read_ke},
    {"Tf", read_tf},
    {"Ns", read_ns},
    {"d", read_d},
    {"Tr", read_tr},
    {"Ni", read_ni},
    {"illum", read_illum},
    {"map_Kd", tia_mtl_map_kd},
    {"map_d", tia_mtl_map_d},
};

static const char *const skipped[] = {
    "Ka",     "bump",    "disp",        "decal",    "refl",     "norm",     "sharpness", "Km",      "Pr",
    "Pm",     "Ps",      "Pc",          "Pcr",      "aniso",    "anisor",   "map_Ka",    "map_Ks",  "map_Ke",
    "map_Ns", "map_Tr",  "map_opacity", "map_bump", "map_Bump", "map_refl", "map_Pr",    "map_Pm",  "map_Ps",
    "map_Ni", "map_aat", "Kt",          "Tm",       "map_Disp", "map_disp", "map_norm",  "map_Norm"};

/* Skips the rest of a line with a mistake, and warns. */
static int skip_mistake(struct mtl *m)
{
    tia_obj_skip(&m->text);
    return tia_obj_forgive(m->obj, TIA_WARN_STATEMENT);
}

static int read_statement(struct mtl *m, const struct tia_word *word)
{
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (tia_word_is(word, statements[i].name)) {
            int status = m->open || !i ? statements[i].read(m)
                                       : tia_text_error(&m->text, word, "comes too early", "newmtl first");
            return status || tia_text_end(&m->text) ? skip_mistake(m) : TIA_OK;
        }
    for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
        if (tia_word_is(word, skipped[i])) {
            tia_obj_skip(&m->text);
            return TIA_OK;
        }
    (void)tia_text_error(&m->text, word, "is not a statement of a material", "newmtl, Kd, Ks, Ns, d or the like");
    return skip_mistake(m);
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
    return close_material(&m);
}
