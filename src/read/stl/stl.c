/* stl.c - stereolithography, .stl: triangles, as text or binary.
 *
 *     solid NAME                        80 bytes, not used
 *     facet normal x y z                the number of facets, 32 bits, little endian
 *     outer loop                        for each of them 50 bytes: its normal and its
 *     vertex x y z                      three corners as floats, and 2 bytes, not used
 *     vertex x y z
 *     vertex x y z
 *     endloop
 *     endfacet
 *     endsolid NAME
 *
 * A binary file may begin with "solid", too; its length and zeros tell. Normals are not used: faces are flat, and have
 * two sides.
 *
 * The format repeats a vertex for each facet. Equal ones are stored once, by a hash table in the members of the faces
 * that are not needed: `uv` of corner number h is the last vertex with the hash h, `normal` of corner number i the
 * vertex with the same hash before vertex i. A search ends after some steps, so that its time does not depend on the
 * file; a vertex that is stored twice does not change the picture.
 */
#include "read/model/binary.h"
#include "read/model/plain.h"
#include "read/model/prefetch.h"

#define HEAD 84  /* bytes before the facets */
#define FACET 50 /* bytes of a facet */
#define SEARCH 24
#define AHEAD 48 /* vertices whose places in the table are fetched before they are needed: those of some facets */

/* ---- vertices ---- */

struct stl {
    struct tia_plain *p;
    /* The last vertices, which are not stored yet, and their hashes. */
    struct tia_vec3 vertices[AHEAD];
    uint32_t hashes[AHEAD], waiting;
};

static struct tia_corner *slot(struct tia_plain *p, uint32_t index)
{
    return &p->faces[index / 3].corner[index % 3];
}

/* Returns the number of a corner. */
static uint32_t hash(const struct tia_plain *p, const struct tia_vec3 *v)
{
    uint64_t h = (uint32_t)v->x;

    h = (h ^ (h >> 15)) * UINT64_C(0x9e3779b97f4a7c15) + (uint32_t)v->y;
    h = (h ^ (h >> 29)) * UINT64_C(0xbf58476d1ce4e5b9) + (uint32_t)v->z;
    h = (h ^ (h >> 32)) * UINT64_C(0x94d049bb133111eb);
    return (uint32_t)((uint64_t)(uint32_t)(h >> 32) * p->vertices.capacity >> 32);
}

/* Returns the index of a vertex, which is new or was stored before. */
static uint32_t find_vertex(struct tia_plain *p, const struct tia_vec3 *v, uint32_t hash)
{
    const struct tia_vec3 *all = (const struct tia_vec3 *)(void *)p->vertices.items;
    uint32_t *head = &slot(p, hash)->uv, at = *head;

    for (int i = 0; i < SEARCH && at != TIA_NO_INDEX; i++, at = slot(p, at)->normal)
        if (all[at].x == v->x && all[at].y == v->y && all[at].z == v->z)
            return at;
    slot(p, p->vertices.count)->normal = *head;
    *head = p->vertices.count;
    tia_array_add(&p->vertices, v);
    return *head;
}

/* Stores the facets whose vertices wait. */
static void store_facets(struct stl *stl)
{
    struct tia_plain *p = stl->p;

    for (uint32_t i = 0; i < stl->waiting; i += 3, p->face_count++)
        for (uint32_t k = 0; k < 3; k++)
            p->faces[p->face_count].corner[k].vertex = find_vertex(p, &stl->vertices[i + k], stl->hashes[i + k]);
    stl->waiting = 0;
}

/* Adds a facet of three vertices with tia_model_bits fractional bits; the first pass measures and counts it. */
static inline void add_facet(struct stl *stl, const int64_t v[3][3])
{
    struct tia_plain *p = stl->p;

    for (int i = 0; i < 3 && p->model.counting; i++) {
        struct tia_vec3 vertex = tia_model_vertex(&p->model, v[i]);
        tia_array_add(&p->vertices, &vertex);
    }
    for (int i = 0; i < 3 && !p->model.counting; i++, stl->waiting++) {
        struct tia_vec3 vertex = tia_model_place(&p->model, v[i]);
        stl->vertices[stl->waiting] = vertex;
        stl->hashes[stl->waiting] = hash(p, &vertex);
        PREFETCH(slot(p, stl->hashes[stl->waiting]));
    }
    p->face_count += p->model.counting;
    if (stl->waiting == AHEAD)
        store_facets(stl);
}

/* Empties or, after the last facet, removes the hash table. */
static void clear_table(struct tia_plain *p)
{
    for (uint32_t i = 0; !p->model.counting && i < p->vertices.capacity; i++)
        slot(p, i)->uv = slot(p, i)->normal = TIA_NO_INDEX;
}

/* ---- binary ---- */

static int refuse_coordinate(struct tia_plain *p, enum tia_decimal result, uint32_t facet)
{
    static const char *const whats[] = {"", "a coordinate is not a number", "a coordinate is out of range"};

    (void)tia_plain_error(p, "facet", facet);
    tia_say(&p->model.reader->error, whats[result]);
    tia_say(&p->model.reader->error, ", expected a number below 2147483648");
    return TIA_ERR_RANGE;
}

/* Reads the facets number 1 to `facets`. */
static int read_facets(struct stl *stl, uint32_t facets)
{
    const char *at = stl->p->model.reader->text + HEAD + 12;
    const unsigned bits = tia_model_bits(&stl->p->model);
    int64_t v[3][3];

    for (uint32_t i = 1; i <= facets; i++, at += FACET) {
        for (int k = 0; k < 9; k++) {
            enum tia_decimal result = tia_binary_float(&v[k / 3][k % 3], tia_binary_little(at + 4 * k), bits);
            if (result != TIA_DECIMAL_FINE)
                return refuse_coordinate(stl->p, result, i);
        }
        add_facet(stl, (const int64_t(*)[3])v);
    }
    return TIA_OK;
}

static int check_length(struct tia_plain *p, uint32_t facets)
{
    size_t length = p->model.reader->length;
    struct tia_read_error *error = &p->model.reader->error;

    if (length < HEAD)
        return tia_model_refuse(&p->model, "the file is too short, expected an STL file");
    if ((length - HEAD) / FACET >= facets && length - HEAD == (size_t)facets * FACET)
        return TIA_OK;
    error->text[0] = 0;
    (void)tia_model_refuse(&p->model, "the file has ");
    tia_say_number(error, (int64_t)length);
    tia_say(error, " bytes, expected ");
    tia_say_number(error, HEAD + (int64_t)facets * FACET);
    tia_say(error, " for its ");
    tia_say_number(error, facets);
    tia_say(error, " facets");
    return (length - HEAD) / FACET < facets ? TIA_ERR_RANGE
                                            : tia_plain_forgive(p, TIA_WARN_STATEMENT, "the rest is skipped");
}

static uint32_t facets_of(const struct tia_reader *reader)
{
    return reader->length < HEAD ? 0 : tia_binary_little(reader->text + 80);
}

/* Returns an integer that compares as the float of these bits does. Only NaN are beyond the infinities. */
static int32_t order_of(uint32_t ieee)
{
    return (int32_t)(ieee >> 31 ? ~(ieee & INT32_MAX) : ieee);
}

static uint32_t float_of(int32_t order)
{
    return order < 0 ? ~(uint32_t)order | UINT32_C(1) << 31 : (uint32_t)order;
}

/* Measures the facets as reading each of them would, by the least and the largest coordinates, since a conversion keeps
 * their order. Returns false if one of these is out of range. */
static bool measure_binary(struct stl *stl, uint32_t facets)
{
    const char *at = stl->p->model.reader->text + HEAD + 12;
    int32_t range[2][3] = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    int64_t v[2][3];

    for (uint32_t i = 0; i < facets; i++, at += FACET)
        for (int k = 0; k < 9; k++) {
            int32_t order = order_of(tia_binary_little(at + 4 * k));
            range[0][k % 3] = order < range[0][k % 3] ? order : range[0][k % 3];
            range[1][k % 3] = order > range[1][k % 3] ? order : range[1][k % 3];
        }
    for (int k = 0; k < 6; k++)
        if (tia_binary_float(&v[k / 3][k % 3], float_of(range[k / 3][k % 3]), tia_model_bits(&stl->p->model)))
            return false;
    (void)tia_model_vertex(&stl->p->model, v[0]);
    (void)tia_model_vertex(&stl->p->model, v[1]);
    stl->p->vertices.count = 3 * facets;
    stl->p->face_count = facets;
    return true;
}

static int read_binary(struct stl *stl)
{
    const struct tia_model *model = &stl->p->model;
    uint32_t facets = facets_of(model->reader);
    int status = check_length(stl->p, facets);

    /* a part of a scene needs to know whether a coordinate was rounded */
    if (!status && model->counting && !model->use && facets && measure_binary(stl, facets))
        return TIA_OK;
    return status ? status : read_facets(stl, facets);
}

/* ---- text ---- */

/* The facet that is being read. */
struct facet {
    struct tia_text *text;
    uint32_t corners;
    int64_t v[3][3];
};

/* True if the word is `string`, which has small letters, in letters of any size. */
static bool is(const struct tia_word *word, const char *string)
{
    uint32_t i = 0;

    while (i < word->length && string[i] && (word->at[i] == string[i] || word->at[i] == string[i] - ('a' - 'A')))
        i++;
    return i == word->length && !string[i];
}

static int read_vertex(struct tia_plain *p, struct facet *f, const struct tia_word *word)
{
    unsigned bits = tia_model_bits(&p->model);
    int status = TIA_OK;

    if (f->corners == 3)
        return tia_text_error(f->text, word, "is one too many", "three in a facet");
    for (int i = 0; !status && i < 3; i++)
        status = tia_text_long(f->text, &f->v[f->corners][i], bits);
    f->corners++;
    return status ? status : tia_text_end(f->text);
}

/* Ends a facet. One without three corners is left out. */
static int end_facet(struct stl *stl, struct facet *f, const struct tia_word *word)
{
    uint32_t corners = f->corners;

    f->corners = 0;
    if (corners == 3) {
        add_facet(stl, (const int64_t(*)[3])f->v);
        return TIA_OK;
    }
    (void)tia_text_error(f->text, word, "comes too early", "three vertex lines in a facet");
    return tia_plain_forgive(stl->p, TIA_WARN_FACE, "the facet is left out");
}

static int read_line(struct stl *stl, struct facet *f, const struct tia_word *word)
{
    static const char *const skipped[] = {"facet", "outer", "endfacet", "solid", "endsolid", "color"};

    if (is(word, "vertex"))
        return read_vertex(stl->p, f, word);
    if (is(word, "endloop"))
        return end_facet(stl, f, word);
    for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
        if (is(word, skipped[i]))
            return TIA_OK;
    (void)tia_text_error(f->text, word, "is not a statement", "facet, outer, vertex, endloop, endfacet or endsolid");
    return tia_plain_forgive(stl->p, TIA_WARN_STATEMENT, "skipped");
}

static int read_text(struct stl *stl)
{
    struct tia_text text = tia_model_text(&stl->p->model);
    struct facet f = {.text = &text};
    struct tia_word word;
    int status = TIA_OK;

    while (!status && tia_text_line(&text)) {
        (void)tia_text_word(&text, &word);
        status = read_line(stl, &f, &word);
        tia_text_skip(&text);
    }
    return status;
}

/* ---- both ---- */

#define LOOKED 512 /* first bytes that tell text from binary */

/* True if one of the first bytes is 0, as those of the number of facets. */
static bool has_zero(const struct tia_reader *reader)
{
    size_t i = 0;

    while (i < LOOKED && i < reader->length && reader->text[i])
        i++;
    return i < LOOKED && i < reader->length;
}

/* True if the file begins with "solid", has no zeros, and its length is not that of a binary file. */
static bool is_text(const struct tia_reader *reader)
{
    struct tia_read_error error;
    struct tia_text text = tia_text_begin(reader->text, reader->length, "", &error);
    struct tia_word word;

    if (reader->length >= HEAD && reader->length - HEAD == (uint64_t)facets_of(reader) * FACET)
        return false;
    if (has_zero(reader))
        return false;
    return tia_text_line(&text) && tia_text_word(&text, &word) && is(&word, "solid");
}

static int read_once(struct tia_plain *p, void *ctx)
{
    struct stl stl = {.p = p};

    (void)ctx;
    clear_table(p);
    int status = is_text(p->model.reader) ? read_text(&stl) : read_binary(&stl);
    store_facets(&stl);
    clear_table(p);
    return status;
}

int tia_read_stl(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena, struct tia_model_use *use)
{
    struct tia_plain p = tia_plain_begin(reader, scene, use, "some facets");

    return tia_plain_read(&p, arena, read_once, NULL);
}
