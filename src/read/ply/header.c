/* header.c - the header of a .ply file: its elements and their properties. */
#include "ply.h"

static const struct {
    const char *names[2];
    uint8_t type;
} types[] = {
    {{"char", "int8"}, PLY_I8},      {{"uchar", "uint8"}, PLY_U8},     {{"short", "int16"}, PLY_I16},
    {{"ushort", "uint16"}, PLY_U16}, {{"int", "int32"}, PLY_I32},      {{"uint", "uint32"}, PLY_U32},
    {{"float", "float32"}, PLY_F32}, {{"double", "float64"}, PLY_F64},
};

static const struct {
    const char *name;
    uint8_t role;
} roles[] = {
    {"x", PLY_X},
    {"y", PLY_Y},
    {"z", PLY_Z},
    {"nx", PLY_NX},
    {"ny", PLY_NY},
    {"nz", PLY_NZ},
    {"u", PLY_U},
    {"v", PLY_V},
    {"s", PLY_U},
    {"t", PLY_V},
    {"texture_u", PLY_U},
    {"texture_v", PLY_V},
    {"red", PLY_RED},
    {"green", PLY_GREEN},
    {"blue", PLY_BLUE},
    {"r", PLY_RED},
    {"g", PLY_GREEN},
    {"b", PLY_BLUE},
    {"diffuse_red", PLY_RED},
    {"diffuse_green", PLY_GREEN},
    {"diffuse_blue", PLY_BLUE},
};

static int read_type(struct ply *ply, const struct tia_word *word, uint8_t *type)
{
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (tia_word_is(word, types[i].names[0]) || tia_word_is(word, types[i].names[1])) {
            *type = types[i].type;
            return TIA_OK;
        }
    return tia_text_error(&ply->text, word, "is not a type",
                          "char, uchar, short, ushort, int, uint, float, double or list");
}

static int read_next_type(struct ply *ply, uint8_t *type)
{
    struct tia_word word;

    (void)tia_text_word(&ply->text, &word);
    return read_type(ply, &word, type);
}

static int read_format(struct ply *ply)
{
    struct tia_word word;

    (void)tia_text_word(&ply->text, &word);
    ply->big_endian = tia_word_is(&word, "binary_big_endian");
    ply->binary = ply->big_endian || tia_word_is(&word, "binary_little_endian");
    if (ply->binary || tia_word_is(&word, "ascii"))
        return TIA_OK;
    return tia_text_error(&ply->text, &word, "is not a format", "ascii, binary_little_endian or binary_big_endian");
}

static int read_element(struct ply *ply)
{
    struct ply_element *e = &ply->elements[ply->element_count];
    struct tia_word word;
    int64_t count = 0;

    (void)tia_text_word(&ply->text, &word);
    if (ply->element_count == PLY_ELEMENTS)
        return tia_text_error(&ply->text, &word, "is one too many", "at most 16 elements");
    int status = tia_text_integer(&ply->text, &count, 0, UINT32_MAX - 1);
    *e = (struct ply_element){.kind = tia_word_is(&word, "vertex") ? PLY_VERTEX
                                      : tia_word_is(&word, "face") ? PLY_FACE
                                                                   : PLY_UNKNOWN,
                              .count = (uint32_t)count,
                              .first = ply->property_count,
                              .end = ply->property_count};
    ply->element_count++;
    return status;
}

/* Returns what a property means for its element. */
static uint8_t role_of(const struct ply_element *e, const struct ply_property *property, const struct tia_word *name)
{
    if (e->kind == PLY_FACE && property->count_type &&
        (tia_word_is(name, "vertex_indices") || tia_word_is(name, "vertex_index")))
        return PLY_CORNERS;
    for (size_t i = 0; e->kind == PLY_VERTEX && !property->count_type && i < sizeof roles / sizeof *roles; i++)
        if (tia_word_is(name, roles[i].name))
            return roles[i].role;
    return PLY_OTHER;
}

static int read_property(struct ply *ply)
{
    struct ply_element *e = &ply->elements[ply->element_count ? ply->element_count - 1 : 0];
    struct ply_property property = {.type = PLY_NONE};
    struct tia_word word;

    (void)tia_text_word(&ply->text, &word);
    if (!ply->element_count)
        return tia_text_error(&ply->text, &word, "belongs to no element", "an element line before it");
    if (ply->property_count == PLY_PROPERTIES)
        return tia_text_error(&ply->text, &word, "is one too many", "at most 256 properties");
    bool list = tia_word_is(&word, "list");
    int status = list ? read_next_type(ply, &property.count_type) : TIA_OK;
    status = status ? status : list ? read_next_type(ply, &property.type) : read_type(ply, &word, &property.type);
    status = status ? status : tia_text_name(&ply->text, &word, "a property's name");
    if (status)
        return status;
    property.role = role_of(e, &property, &word);
    if (property.role != PLY_OTHER && e->roles >> property.role & 1)
        property.role = PLY_OTHER; /* the first one counts */
    e->roles |= UINT32_C(1) << property.role;
    ply->properties[ply->property_count++] = property;
    e->end = ply->property_count;
    return TIA_OK;
}

/* Reads a line of the header; *done after the last one. */
static int read_line(struct ply *ply, bool *done)
{
    struct tia_word word;

    (void)tia_text_word(&ply->text, &word);
    if (tia_word_is(&word, "element"))
        return read_element(ply);
    if (tia_word_is(&word, "property"))
        return read_property(ply);
    if (tia_word_is(&word, "format"))
        return read_format(ply);
    *done = tia_word_is(&word, "end_header");
    if (*done || tia_word_is(&word, "comment") || tia_word_is(&word, "obj_info"))
        return TIA_OK;
    return tia_text_error(&ply->text, &word, "is not a line of a header",
                          "format, element, property, comment, obj_info or end_header");
}

static int refuse(struct ply *ply, const char *why)
{
    return tia_model_refuse(&ply->p->model, why);
}

/* Checks what the readers of vertices and faces rely on. */
static int check(struct ply *ply)
{
    const uint32_t place = UINT32_C(1) << PLY_X | UINT32_C(1) << PLY_Y | UINT32_C(1) << PLY_Z;
    unsigned vertices = 0, faces = 0;

    for (unsigned i = 0; i < ply->element_count; i++) {
        const struct ply_element *e = &ply->elements[i];
        if (e->kind == PLY_VERTEX && (e->roles & place) != place)
            return refuse(ply, "the vertices have no x, y and z, expected these properties");
        if (e->kind == PLY_FACE && e->count && !vertices)
            return refuse(ply, "the faces come before the vertices, expected them behind");
        if (e->kind == PLY_FACE && !(e->roles >> PLY_CORNERS & 1))
            return refuse(ply, "the faces have no vertex_indices, expected a list of that name");
        vertices += e->kind == PLY_VERTEX;
        faces += e->kind == PLY_FACE;
    }
    if (vertices > 1 || faces > 1)
        return refuse(ply, "vertex or face elements come twice, expected one of each");
    return TIA_OK;
}

int tia_ply_header(struct ply *ply)
{
    struct tia_word word;
    bool done = false;
    int status = TIA_OK;

    if (!tia_text_line(&ply->text) || !tia_text_word(&ply->text, &word) || !tia_word_is(&word, "ply"))
        return refuse(ply, "the file does not begin with ply, expected a PLY file");
    tia_text_skip(&ply->text);
    while (!status && !done) {
        if (!tia_text_line(&ply->text))
            return refuse(ply, "the header does not end, expected end_header");
        status = read_line(ply, &done);
        tia_text_skip(&ply->text);
    }
    if (ply->text.next < ply->text.end)
        ply->text.next++, ply->text.line++;
    ply->text.line_start = ply->at = ply->text.next;
    return status ? status : check(ply);
}
