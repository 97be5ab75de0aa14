/* off.c - Geomview's object file format, .off: polygons as text.
 *
 *     [ST][C][N]OFF               the letters tell what follows the coordinates of a vertex
 *     VERTICES FACES EDGES        the number of edges is not used, and may be missing
 *     x y z [nx ny nz] [colour] [s t]
 *     N i1 i2 ... iN [colour]     the vertices of a polygon, counted from 0
 *
 * Each vertex and each polygon begins a line, and colours are skipped. 4OFF, nOFF and binary files are refused.
 */
#include "read/model/plain.h"

struct off {
    struct tia_plain *p;
    struct tia_text text;
    bool normals, uvs;
    uint32_t vertices, faces; /* numbers that the file gives */
};

/* Removes `letters` from the front of a word; returns false if it does not begin with them. */
static bool take(struct tia_word *word, const char *letters)
{
    uint32_t i = 0;

    while (letters[i] && i < word->length && word->at[i] == letters[i])
        i++;
    if (letters[i])
        return false;
    word->at += i;
    word->length -= i;
    return true;
}

/* Reads the first line, a word. A file without it begins with the numbers. */
static int read_form(struct off *off)
{
    struct tia_word word, rest;

    if (!tia_text_line(&off->text))
        return tia_model_refuse(&off->p->model, "the file is empty, expected OFF");
    if (tia_text_has_number(&off->text))
        return TIA_OK;
    (void)tia_text_word(&off->text, &word);
    rest = word;
    off->uvs = take(&rest, "ST");
    (void)take(&rest, "C");
    off->normals = take(&rest, "N");
    if (!tia_word_is(&rest, "OFF"))
        return tia_text_error(&off->text, &word, "is not a form that can be read", "OFF, COFF, NOFF, CNOFF or STOFF");
    if (tia_text_peek(&off->text, &word) && tia_word_is(&word, "BINARY"))
        return tia_text_error(&off->text, &word, "is not a form that can be read", "text");
    return TIA_OK;
}

/* Goes to the next line that is not blank, if this one has no more words. */
static int next_line(struct off *off, const char *expected)
{
    struct tia_word end;

    if (tia_text_line(&off->text))
        return TIA_OK;
    (void)tia_text_word(&off->text, &end);
    (void)tia_text_error_at(&off->text, &end);
    tia_say(off->text.error, "the file ends here, expected ");
    tia_say(off->text.error, expected);
    return TIA_ERR_RANGE;
}

static int read_count(struct off *off, uint32_t *count)
{
    int64_t wide = 0;
    int status = next_line(off, "the number of vertices and of faces");

    status = status ? status : tia_text_integer(&off->text, &wide, 0, UINT32_MAX - 1);
    *count = (uint32_t)wide;
    return status;
}

static int read_numbers(struct off *off, int64_t *out, int count, unsigned bits)
{
    int status = TIA_OK;

    for (int i = 0; !status && i < count; i++)
        status = tia_text_long(&off->text, &out[i], bits);
    return status;
}

static int read_normal(struct off *off)
{
    struct tia_word first;
    struct tia_dir3 normal = {0, 0, 0};
    int64_t n[3] = {0, 0, 0};

    (void)tia_text_peek(&off->text, &first);
    int status = read_numbers(off, n, 3, 32);
    if (!status && !tia_dir3_of(&normal, n)) {
        (void)tia_text_error(&off->text, &first, "begins a normal of no length", "three numbers that are not all 0");
        status = tia_plain_forgive(off->p, TIA_WARN_NORMAL, "faces that use it are drawn flat");
    }
    tia_array_add(&off->p->normals, &normal);
    return status;
}

static uint32_t words_left(const struct off *off)
{
    struct tia_text copy = off->text;
    struct tia_word word;
    uint32_t count = 0;

    while (tia_text_word(&copy, &word))
        count++;
    return count;
}

/* Reads texture coordinates, the last two numbers of the line. */
static int read_uv(struct off *off)
{
    struct tia_uv uv = {0, 0};
    struct tia_word word;
    uint32_t words = words_left(off);
    int status = TIA_OK;

    for (; words > 2; words--)
        (void)tia_text_word(&off->text, &word);
    status = tia_text_q16(&off->text, &uv.u);
    status = status ? status : tia_text_q16(&off->text, &uv.v);
    tia_array_add(&off->p->uvs, &uv);
    return status;
}

static int read_vertex(struct off *off)
{
    int64_t v[3] = {0, 0, 0};
    int status = next_line(off, "a vertex");

    status = status ? status : read_numbers(off, v, 3, tia_model_bits(&off->p->model));
    struct tia_vec3 vertex = tia_model_vertex(&off->p->model, v);
    tia_array_add(&off->p->vertices, &vertex);
    if (!status && off->normals)
        status = read_normal(off);
    if (!status && off->uvs)
        status = read_uv(off);
    tia_text_skip(&off->text);
    return status;
}

/* Reads the corners of a polygon; *bad tells whether one does not exist. */
static int read_corners(struct off *off, uint32_t count, bool *bad)
{
    struct tia_word word;
    int64_t index;

    for (uint32_t i = 0; i < count; i++) {
        (void)tia_text_peek(&off->text, &word);
        int status = tia_text_long(&off->text, &index, 0);
        if (status)
            return status;
        if (index < 0 || index >= off->vertices) {
            (void)tia_text_error(&off->text, &word, "is not a vertex of the file", "0 to ");
            tia_say_number(off->text.error, (int64_t)off->vertices - 1);
            *bad = true;
            return tia_plain_forgive(off->p, TIA_WARN_FACE, "the face is left out");
        }
        tia_plain_corner(off->p, i, (uint32_t)index);
    }
    return TIA_OK;
}

static int read_face(struct off *off)
{
    struct tia_word word;
    int64_t count = 0;
    bool bad = false;
    int status = next_line(off, "a face");

    (void)tia_text_peek(&off->text, &word);
    status = status ? status : tia_text_integer(&off->text, &count, 0, POLYGON_MAX);
    status = status ? status : read_corners(off, (uint32_t)count, &bad);
    tia_text_skip(&off->text);
    if (status || bad)
        return status;
    if (count >= 3) {
        tia_plain_polygon(off->p, (uint32_t)count);
        return TIA_OK;
    }
    (void)tia_text_error(&off->text, &word, "is too few corners", "3 or more");
    return tia_plain_forgive(off->p, TIA_WARN_FACE, "the face is left out");
}

static int read_once(struct tia_plain *p, void *ctx)
{
    struct off off = {.p = p, .text = tia_model_text(&p->model)};
    int status = read_form(&off);

    (void)ctx;
    status = status ? status : read_count(&off, &off.vertices);
    status = status ? status : read_count(&off, &off.faces);
    tia_text_skip(&off.text);
    for (uint32_t i = 0; !status && i < off.vertices; i++)
        status = read_vertex(&off);
    for (uint32_t i = 0; !status && i < off.faces; i++)
        status = read_face(&off);
    return status;
}

int tia_read_off(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena, struct tia_model_use *use)
{
    struct tia_plain p = tia_plain_begin(reader, scene, use, "some polygons");

    return tia_plain_read(&p, arena, read_once, NULL);
}
