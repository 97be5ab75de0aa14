/* statement.c - one line of an .obj file: vertices, texture coordinates and normals here, the others in files of their
 * own. */
#include "obj.h"

/* Reads a vertex; a weight or a colour behind it is skipped. */
static int read_v(struct obj *o)
{
    unsigned bits = tia_model_bits(&o->model);
    int64_t v[3] = {0, 0, 0}, more;
    int status = TIA_OK;

    for (int i = 0; !status && i < 3; i++)
        status = tia_text_long(&o->text, &v[i], bits);
    struct tia_vec3 vertex = tia_model_vertex(&o->model, v);
    for (int i = 0; !status && i < 4 && tia_text_has_number(&o->text); i++)
        status = tia_text_q32(&o->text, &more);
    tia_array_add(&o->vertices, &vertex);
    return status;
}

/* Reads a texture coordinate. A coordinate out of range is clamped: useful ones are far smaller. */
static int read_texture_coordinate(struct obj *o, tia_q16 *out)
{
    struct tia_word word;
    int64_t wide = 0;

    (void)tia_text_peek(&o->text, &word);
    int status = tia_text_q16(&o->text, out);
    if (!status)
        return status;
    enum tia_decimal result = tia_decimal(&wide, &word, 16);
    bool below = word.length && *word.at == '-';
    *out = result == TIA_DECIMAL_NONE ? 0 : below ? INT32_MIN : INT32_MAX;
    return tia_obj_forgive(o, result == TIA_DECIMAL_NONE ? TIA_WARN_NUMBER : TIA_WARN_RANGE);
}

static int read_uv(struct obj *o)
{
    struct tia_uv uv = {0, 0};
    struct tia_word word;
    tia_q16 more;
    int status = read_texture_coordinate(o, &uv.u);

    if (!status && tia_text_peek(&o->text, &word))
        status = read_texture_coordinate(o, &uv.v);
    if (!status && tia_text_has_number(&o->text))
        status = read_texture_coordinate(o, &more);
    tia_array_add(&o->uvs, &uv);
    return status;
}

/* Reads a normal. A normal without a direction becomes (0, 0, 0); faces that use it are drawn flat, see
 * strip_corners. */
static int read_vn(struct obj *o)
{
    struct tia_dir3 normal = {0, 0, 0};
    int status = tia_text_dir3(&o->text, &normal);

    if (status) {
        normal = (struct tia_dir3){0, 0, 0};
        status = tia_obj_forgive(o, TIA_WARN_NORMAL);
        tia_obj_skip(&o->text);
    }
    tia_array_add(&o->normals, &normal);
    return status;
}

/* ---- all statements ---- */

static const struct {
    const char *name;
    int (*read)(struct obj *);
} statements[] = {
    {"v", read_v},    {"f", tia_obj_f},           {"vn", read_vn},
    {"vt", read_uv},  {"usemtl", tia_obj_usemtl}, {"mtllib", tia_obj_mtllib},
    {"o", tia_obj_o}, {"g", tia_obj_g},
};

static const char *const skipped[] = {"s",        "l",          "p",         "mg",     "lod",    "bevel", "c_interp",
                                      "d_interp", "shadow_obj", "trace_obj", "usemap", "maplib", "vp"};

/* Skips the rest of a line with a mistake, and warns. */
static int skip_mistake(struct obj *o)
{
    tia_obj_skip(&o->text);
    return tia_obj_forgive(o, TIA_WARN_STATEMENT);
}

int tia_obj_statement(struct obj *o, const struct tia_word *word)
{
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (tia_word_is(word, statements[i].name)) {
            int status = statements[i].read(o);
            return status || !tia_text_end(&o->text) ? status : skip_mistake(o);
        }
    for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
        if (tia_word_is(word, skipped[i])) {
            tia_obj_skip(&o->text);
            return TIA_OK;
        }
    (void)tia_text_error(&o->text, word, "is not a statement", "v, vt, vn, f, g, o, s, usemtl or mtllib");
    return skip_mistake(o);
}
