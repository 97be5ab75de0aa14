/* pgm.c - a grey picture, .pgm, as a height field: P2, text, or P5, binary, of 8 or 16 bits.
 *
 *     P5 WIDTH HEIGHT MAXIMUM     then the levels, row by row from the top
 *
 * Pixel (column, row) is the vertex (column/(width - 1), level/maximum, row/(height - 1)): a square of side 1 in x and
 * z, the picture's bottom towards +z, with heights from 0 to 1. Four neighbours are two triangles. Normals are smooth,
 * from the differences of neighbouring levels, one-sided at the edges. Texture coordinates put an image on the square,
 * seen from above with +z at its bottom.
 */
#include "read/model/binary.h"
#include "read/model/plain.h"

#define SIDE_MAX 32767 /* largest width and height */
#define LEVEL_MAX 65535

struct pgm {
    struct tia_plain *p;
    struct tia_text text;
    bool binary;
    int64_t width, height, maximum;
    const char *at; /* the levels of a binary file */
};

static int refuse(struct pgm *pgm, const char *why)
{
    return tia_model_refuse(&pgm->p->model, why);
}

/* Reads the next number, on this line or a later one. */
static int read_whole(struct pgm *pgm, int64_t *out, int64_t min, int64_t max)
{
    if (!tia_text_line(&pgm->text))
        return refuse(pgm, "the file ends early, expected more numbers");
    return tia_text_integer(&pgm->text, out, min, max);
}

static int read_head(struct pgm *pgm)
{
    const struct tia_reader *reader = pgm->p->model.reader;
    struct tia_word word;

    if (!tia_text_line(&pgm->text) || !tia_text_word(&pgm->text, &word) ||
        (!tia_word_is(&word, "P2") && !tia_word_is(&word, "P5")))
        return refuse(pgm, "the file does not begin with P2 or P5, expected a PGM file");
    pgm->binary = word.at[1] == '5';
    int status = read_whole(pgm, &pgm->width, 2, SIDE_MAX);
    status = status ? status : read_whole(pgm, &pgm->height, 2, SIDE_MAX);
    status = status ? status : read_whole(pgm, &pgm->maximum, 1, LEVEL_MAX);
    if (status)
        return status;
    if ((pgm->width - 1) * (pgm->height - 1) > TIA_OBJECTS_MAX / 2)
        return refuse(pgm, "the picture is too large, expected at most 8388608 squares");
    uint64_t left = (uint64_t)(reader->text + reader->length - pgm->text.next);
    if (pgm->binary && left < 1 + (uint64_t)(pgm->width * pgm->height) * (pgm->maximum > 255 ? 2 : 1))
        return refuse(pgm, "the file ends early, expected more levels");
    pgm->at = pgm->binary ? pgm->text.next + 1 : NULL;
    return TIA_OK;
}

static int read_level(struct pgm *pgm, int64_t *level)
{
    unsigned size = pgm->maximum > 255 ? 2 : 1;

    if (!pgm->binary)
        return read_whole(pgm, level, 0, pgm->maximum);
    *level = (int64_t)tia_binary_unsigned(pgm->at, size, true);
    pgm->at += size;
    return *level <= pgm->maximum ? TIA_OK : refuse(pgm, "a level is above the maximum, expected at most that");
}

/* Returns a/b with `bits` fractional bits, rounded to nearest; 0 <= a <= b < 2^16. */
static int64_t quotient(int64_t a, int64_t b, unsigned bits)
{
    return (a * (INT64_C(2) << bits) + b) / (2 * b);
}

/* Adds a vertex. Its normal and texture coordinates wait for all levels: until then its u is the level. */
static void add_vertex(struct pgm *pgm, int64_t column, int64_t row, int64_t level)
{
    unsigned bits = tia_model_bits(&pgm->p->model);
    const int64_t v[3] = {quotient(column, pgm->width - 1, bits), quotient(level, pgm->maximum, bits),
                          quotient(row, pgm->height - 1, bits)};
    struct tia_vec3 vertex = tia_model_vertex(&pgm->p->model, v);
    const struct tia_dir3 normal = {0, TIA_Q30_ONE, 0};
    const struct tia_uv uv = {(tia_q16)level, 0};

    tia_array_add(&pgm->p->vertices, &vertex);
    tia_array_add(&pgm->p->normals, &normal);
    tia_array_add(&pgm->p->uvs, &uv);
}

static int read_levels(struct pgm *pgm)
{
    int64_t level = 0;

    for (int64_t row = 0; row < pgm->height; row++)
        for (int64_t column = 0; column < pgm->width; column++) {
            int status = read_level(pgm, &level);
            if (status)
                return status;
            add_vertex(pgm, column, row, level);
        }
    return TIA_OK;
}

/* ---- normals ---- */

/* ---- normals and faces, when all levels are known ---- */

/* Returns twice the slope of the levels at one of `count` vertices that are `step` apart in memory: the difference of
 * its neighbours; the first and the last vertex have one neighbour. */
static int64_t slope(const struct tia_uv *level, int64_t at, int64_t count, int64_t step)
{
    int64_t before = at > 0 ? -step : 0, behind = at + 1 < count ? step : 0;

    return ((int64_t)level[behind].u - level[before].u) * (count - 1) * (before && behind ? 1 : 2);
}

static void set_normals(struct pgm *pgm)
{
    struct tia_dir3 *normal = (struct tia_dir3 *)(void *)pgm->p->normals.items;
    const struct tia_uv *level = (const struct tia_uv *)(const void *)pgm->p->uvs.items;

    for (int64_t row = 0; row < pgm->height; row++)
        for (int64_t column = 0; column < pgm->width; column++, level++) {
            const int64_t v[3] = {-slope(level, column, pgm->width, 1), 2 * pgm->maximum,
                                  -slope(level, row, pgm->height, pgm->width)};
            (void)tia_dir3_of(normal++, v);
        }
}

static void set_uvs(struct pgm *pgm)
{
    struct tia_uv *uv = (struct tia_uv *)(void *)pgm->p->uvs.items;

    for (int64_t row = 0; row < pgm->height; row++)
        for (int64_t column = 0; column < pgm->width; column++)
            *uv++ = (struct tia_uv){(tia_q16)quotient(column, pgm->width - 1, 16),
                                    (tia_q16)(TIA_Q16_ONE - quotient(row, pgm->height - 1, 16))};
}

static void add_triangle(struct tia_plain *p, uint32_t a, uint32_t b, uint32_t c)
{
    tia_plain_corner(p, 0, a);
    tia_plain_corner(p, 1, b);
    tia_plain_corner(p, 2, c);
    tia_plain_polygon(p, 3);
}

static void add_faces(struct pgm *pgm)
{
    uint32_t width = (uint32_t)pgm->width;

    for (uint32_t row = 0; row + 1 < (uint32_t)pgm->height; row++)
        for (uint32_t column = 0; column + 1 < width; column++) {
            uint32_t at = row * width + column;
            add_triangle(pgm->p, at, at + width, at + 1);
            add_triangle(pgm->p, at + 1, at + width, at + width + 1);
        }
}

static int read_once(struct tia_plain *p, void *ctx)
{
    struct pgm pgm = {.p = p, .text = tia_model_text(&p->model)};

    (void)ctx;
    int status = read_head(&pgm);
    status = status ? status : read_levels(&pgm);
    if (status)
        return status;
    if (!p->model.counting) {
        set_normals(&pgm);
        set_uvs(&pgm);
    }
    add_faces(&pgm);
    return TIA_OK;
}

int tia_read_pgm(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena, struct tia_model_use *use)
{
    struct tia_plain p = tia_plain_begin(reader, scene, use, "some squares");

    p.distinct = true;
    return tia_plain_read(&p, arena, read_once, NULL);
}
