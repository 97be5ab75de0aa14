/* src/read/obj/parts.c: several threads read the same scene, and find the same mistakes, as one. */
#include "obj_files.h"
#include "workers_in_turn.h"

#include <limits.h>

#define HEAD 16384    /* where the text behind the head begins, at the next line */
#define LENGTH 300000 /* a text that is read by parts */
#define PARTS 32

static unsigned runs; /* rounds of jobs */

/* Runs the jobs from the last to the first. */
static void run(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    (void)ctx;
    runs++;
    while (count-- > 0)
        job(arg, count);
}

static const struct tia_workers workers = {.run = run, .enter = enter_in_turn, .leave = leave_in_turn, .count = PARTS};

/* ---- equal scenes ---- */

static bool are_same(const void *a, const void *b, size_t count, size_t size)
{
    return (!a == !b || !count) && (!count || !a || !memcmp(a, b, count * size));
}

static bool are_same_meshes(const struct tia_mesh *a, const struct tia_mesh *b)
{
    return a->face_count == b->face_count && a->vertex_count == b->vertex_count && a->uv_count == b->uv_count &&
           a->normal_count == b->normal_count && are_same(a->faces, b->faces, a->face_count, sizeof *a->faces) &&
           are_same(a->vertices, b->vertices, a->vertex_count, sizeof *a->vertices) &&
           are_same(a->uvs, b->uvs, a->uv_count, sizeof *a->uvs) &&
           are_same(a->normals, b->normals, a->normal_count, sizeof *a->normals) &&
           are_same(a->groups, b->groups, a->face_count, sizeof *a->groups);
}

static bool are_same_scenes(const struct tia_scene *a, const struct tia_scene *b)
{
    bool same = a->mesh_count == b->mesh_count && a->shape_count == b->shape_count &&
                a->material_count == b->material_count && !memcmp(&a->camera, &b->camera, sizeof a->camera);

    for (uint32_t i = 0; same && i < a->mesh_count; i++)
        same = are_same_meshes(&a->meshes[i], &b->meshes[i]) && a->shapes[i].material == b->shapes[i].material &&
               a->shapes[i].mesh == b->shapes[i].mesh;
    for (uint32_t i = 0; same && i < a->material_count; i++)
        same = !memcmp(&a->materials[i].colour, &b->materials[i].colour, sizeof a->materials[i].colour);
    return same;
}

static bool are_same_errors(const struct tia_read_error *a, const struct tia_read_error *b)
{
    return a->line == b->line && a->column == b->column && !strcmp(a->file, b->file) && !strcmp(a->text, b->text);
}

static bool are_same_warnings(const struct files *a, const struct files *b)
{
    bool same = true;

    for (int i = 0; i < TIA_WARNINGS; i++)
        same = same && a->warnings[i].count == b->warnings[i].count &&
               (!a->warnings[i].count || are_same_errors(&a->warnings[i].at, &b->warnings[i].at));
    return same;
}

/* ---- texts ---- */

static const char colours[] = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";

static void read_text(struct reading *r, struct files *files, const char *text, bool together, bool strict)
{
    *files = (struct files){.names = {"colours.mtl"}, .texts = {colours}};
    *r = (struct reading){.reader = {.format = TIA_FORMAT_OBJ,
                                     .text = text,
                                     .length = strlen(text),
                                     .library = fetch_library,
                                     .ctx = files,
                                     .workers = together ? &workers : NULL,
                                     .strict = strict,
                                     .warnings = files->warnings}};
    read_begin(r);
}

/* Reads a text by one thread and by several. Returns true if several have read it to its end. */
static bool compare(const char *text, bool strict, const char *what)
{
    struct reading one, several;
    struct files files, others;

    read_text(&one, &files, text, false, strict);
    runs = 0;
    read_text(&several, &others, text, true, strict);
    CHECK_MSG(one.status == several.status && are_same_errors(&one.reader.error, &several.reader.error),
              "%s: %d %.100s, %d %.100s", what, one.status, one.reader.error.text, several.status,
              several.reader.error.text);
    CHECK_MSG(are_same_warnings(&files, &others), "%s", what);
    CHECK_MSG(one.status || are_same_scenes(&one.scene, &several.scene), "%s", what);
    read_end(&one);
    read_end(&several);
    return runs >= 6; /* with too little memory the scan and a pass; then those again and two passes at least */
}

/* Appends a comment of `length` bytes, with its line ends. */
static char *add_comments(char *to, size_t length)
{
    memset(to, '#', length);
    for (size_t i = 63; i < length; i += 64)
        to[i] = '\n';
    if (length)
        to[length - 1] = '\n';
    return to + length;
}

#define START "mtllib colours.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 0 1\nvt 0 1\n"
#define START_LENGTH (sizeof START - 1)

/* Writes a text with `model`, whose byte `at` is the first of a part, 0 being the first part behind the head. */
static char *place_model(const char *model, size_t at, unsigned part)
{
    size_t length = strlen(model), head = HEAD + 1;
    char *text = malloc(LENGTH + 1), *to = text + START_LENGTH;

    while (part && (head - START_LENGTH) % 64) /* the head ends with a comment */
        head++;
    memcpy(text, START, START_LENGTH);
    to = add_comments(to, head + (LENGTH - head) / PARTS * part - at - START_LENGTH);
    memcpy(to, model, length);
    to = add_comments(to + length, (size_t)(text + LENGTH - to) - length);
    *to = '\0';
    return text;
}

/* Divides a model behind each of its lines. Returns the number of texts that several threads have read to the end. */
static unsigned divide(const char *model, bool strict, const char *what)
{
    unsigned together = 0, count = 0;

    for (const char *at = model; *at; at++)
        for (unsigned part = 0; part < 8 && (at == model || at[-1] == '\n'); part += 7) {
            char *text = place_model(model, (size_t)(at - model), part);
            together += compare(text, strict, what);
            count++;
            free(text);
        }
    return together == count ? UINT_MAX : together;
}

#define FACES                                                                                                          \
    "o one\nusemtl red\nf 1 2 3\nv 0 0 1\nv 1.5 0 1 0.5\nv 0 1 1e0\nf -1 -2 -3\n# comment\ng two\n\n"                  \
    "vn 1 0 0\nvn 0 2 0\nvt 0.5 0.25\nf 4/1/1 5/-1/-1 6/2/2\nusemtl blue\nv 1 1 1\nv 2 1 1\nf 4//1 5//2 7//3 6//1\n"   \
    "g one\ns off\nf 1 2 8\n  f 2 3 7 6 4\nusemtl red\nf 3 2 1\nv 3 3 3\n"

TEST(divided)
{
    static const struct {
        const char *name, *model;
    } models[] = {
        {"all statements", FACES},
        {"no names", "f 1 2 3\nv 1 1 1\nf -1 1 2\nv 1 2 3\nf 5 4 1\n"},
        {"CRLF", "v 1 1 1\r\nusemtl red\r\n\r\nf 1 2 4\r\ng  \r\nf 4 2 1\r\n"},
        {"large", "v 9000 1 1\nf 1 2 4\nv -1 -9000 3\nf 5 4 1\n"},
        {"small", "v 0.1 0.2 0.3\nf 1 2 4\nv 2 2 0.00001\nf 5 4 1\n"},
    };

    for (unsigned i = 0; i < sizeof models / sizeof *models; i++)
        CHECK_MSG(divide(models[i].model, false, models[i].name) == UINT_MAX, "%s", models[i].name);
}

TEST(last_line_without_end)
{
    static const char model[] = "\nv 1 1 1\nusemtl blue\nf 1 2 4";
    char *text = place_model("", 0, 0);

    memcpy(text + LENGTH + 1 - sizeof model, model, sizeof model);
    CHECK(compare(text, false, "no last line end"));
    free(text);
}

/* Mistakes, and what parts do not read: joined lines, libraries behind the head. */
TEST(given_up)
{
    static const char *const lines[] = {
        "v 1 2",     "f 1 2 99",           "f 1 2",   "f 1 2 -99",       "vn 0 0 0",   "vt x",        "vt 99999 1",
        "f 1/1 2 3", "usemtl foo",         "foo 1 2", "\x01v 1 2 3",     "f 1/ 2/ 3/", "v 1 2 3 x",   "f 1 \\\n 2 3",
        "usemtl",    "mtllib colours.mtl", "f",       "mtllib none.mtl", "v 1 2 3 \\", "# comment \\"};
    char model[sizeof FACES + 40];

    for (unsigned i = 0; i < sizeof lines / sizeof *lines; i++) {
        (void)snprintf(model, sizeof model, "f 1 2 3\n%s\nf 3 2 1\nv 4 4 4\nf -1 1 2\n", lines[i]);
        (void)divide(model, i % 2, lines[i]);
        (void)divide(model, !(i % 2), lines[i]);
    }
}

TEST(lines_of_any_length)
{
    char *text = malloc(2 * LENGTH + 1);

    memcpy(text, "v 0 0 0\nv 1 0 0\nv 0 1 0\n", 24);
    memset(text + 24, ' ', 2 * LENGTH - 24);
    memcpy(text + 2 * LENGTH - 9, "\nf 1 2 3\n", 9);
    text[2 * LENGTH] = '\0';
    (void)compare(text, false, "one long line");
    text[HEAD + 5] = '\n';
    (void)compare(text, false, "parts without a line");
    free(text);
}

int main(void)
{
    RUN(divided);
    RUN(last_line_without_end);
    RUN(given_up);
    RUN(lines_of_any_length);
    return check_status();
}
