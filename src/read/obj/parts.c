/* parts.c - a long text is read by several threads, in parts.
 *
 * The head, the first lines, is read as any text: libraries are named there, and the caller's functions are called on
 * the caller's thread only. The rest is divided at line ends. A scan counts the vertices, normals, texture coordinates
 * and groups of each part, and finds its last material and group, so that each part begins in the state in which one
 * thread would reach it. Only the numbers of its lines are wrong; nothing depends on them, as parts report no mistakes.
 * Then each pass reads the parts by the same functions as a whole text. The last pass does so twice: first the
 * vertices, then the faces that refer to them.
 *
 * Parts are strict: at the first mistake, at a library below the head and at a joined line the work is given up, and
 * one thread reads the whole text. So a mistake has the same message and the same place, however many threads there
 * are.
 */
#include "obj.h"

#define PARTS (SIZE_MAX > UINT16_MAX ? 32 : 1) /* enough that threads seldom wait for the last one */
#define HEAD 16384                             /* least number of bytes in the head */
#define MATERIALS_MOST 4096                    /* the groups of all parts then take 4 MB at most */

/* A shorter text, read in 2 ms, does not repay waking the threads. In units of 2^8 bytes, as size_t may have 16 bits.
 */
#define LEAST_LENGTH (1 << 10)

/* The numbers of some lines, by their statements, and the last lines that set the material and the group, or NULL. */
struct lines {
    uint32_t vertices, uvs, normals, groups;
    const char *material, *group;
};

struct part {
    struct obj o;
    struct tia_reader reader; /* the reader of `o` */
    const char *start, *end;
    struct lines lines;
    uint32_t face_count;
    int status;
};

/* The lines that a pass reads. */
enum line_kind { ALL_LINES, POINTS, FACES };

struct obj_parts {
    struct obj *whole;
    enum line_kind kind;
    struct part part[PARTS];
};

/* True if the text is read by parts, unless it turns out not to suit them. */
static bool divides(const struct tia_reader *reader)
{
    return reader->workers && reader->length >> 8 >= LEAST_LENGTH;
}

struct obj_parts *tia_obj_take_parts(const struct tia_reader *reader, struct tia_arena *arena)
{
    if (!divides(reader))
        return NULL;
    return tia_arena_take(arena, 1, sizeof(struct obj_parts));
}

uint32_t tia_obj_copies(const struct tia_reader *reader, uint32_t materials)
{
    return divides(reader) && materials <= MATERIALS_MOST ? PARTS + 1 : 1;
}

/* Runs the job for all parts. Returns false if one of them failed. */
static bool run(struct obj_parts *parts, void (*job)(void *arg, unsigned index))
{
    const struct tia_workers *workers = parts->whole->reader->workers;
    bool fine = true;

    workers->run(workers->ctx, job, parts, PARTS);
    for (unsigned i = 0; i < PARTS; i++)
        fine = fine && !parts->part[i].status;
    return fine;
}

/* ---- the scan ---- */

static const char *find_line_end(const char *at, const char *end)
{
    while (at < end && *at != '\n')
        at++;
    return at;
}

/* True if a backslash before the line end at `at` joins the next line. Also true in a comment, where it joins none. */
static bool is_joined(const char *start, const char *at)
{
    at -= at > start && at[-1] == '\r';
    return at > start && at[-1] == '\\';
}

static bool is_blank(const char *at, const char *end)
{
    return at == end || (unsigned char)*at <= ' ';
}

/* True if the line at `at` begins with `word`. */
static bool begins(const char *at, const char *end, const char *word)
{
    while (*word && at < end && *at == *word)
        at++, word++;
    return !*word && is_blank(at, end);
}

/* Counts the line whose first word is at `at`. */
static void count_line(struct lines *lines, const char *at, const char *end)
{
    if (*at == 'v') {
        lines->vertices += begins(at, end, "v");
        lines->normals += begins(at, end, "vn");
        lines->uvs += begins(at, end, "vt");
    } else if (begins(at, end, "o") || begins(at, end, "g")) {
        lines->groups++;
        lines->group = at;
    } else if (begins(at, end, "usemtl")) {
        lines->material = at;
    }
}

static void scan(void *arg, unsigned index)
{
    struct part *p = &((struct obj_parts *)arg)->part[index];

    for (const char *at = p->start; at < p->end && !p->status; at++) {
        const char *line = at;
        at = find_line_end(line, p->end);
        while (line < at && is_blank(line, at))
            line++;
        if (line < at)
            count_line(&p->lines, line, at);
        p->status = at < p->end && is_joined(line, at) ? TIA_ERR_RANGE : TIA_OK;
    }
}

/* Divides the text behind the head at line ends. */
static void divide(struct obj_parts *parts, const char *head, const char *end)
{
    size_t rest = (size_t)(end - head);

    for (unsigned i = 0; i < PARTS; i++) {
        struct part *p = &parts->part[i];
        const char *most = head + rest / PARTS * (i + 1);
        *p = (struct part){.start = i ? p[-1].end : head, .end = end};
        most = most > p->start ? find_line_end(most - 1, end) : p->start;
        if (i + 1 < PARTS && most < end)
            p->end = most > p->start ? most + 1 : most;
    }
}

bool tia_obj_divide(struct obj *o)
{
    const char *text = o->reader->text, *end = text + o->reader->length, *head = find_line_end(text + HEAD, end);

    if (head == end || is_joined(text, head))
        return false;
    o->parts->whole = o;
    divide(o->parts, head + 1, end);
    o->head_end = head + 1;
    return run(o->parts, scan);
}

/* ---- the state in which each part begins ---- */

/* Reads a line again that set the material or the group. */
static void repeat(struct obj *o, const char *line, const char *end)
{
    struct tia_word word;

    if (!line)
        return;
    o->text.next = line;
    o->text.end = end;
    (void)tia_text_word(&o->text, &word);
    (void)tia_obj_statement(o, &word);
}

/* Gives a part its share of the working storage; the head has the first. */
static void share(struct obj *part, const struct obj *o, unsigned index)
{
    if (o->pass == OBJ_COUNT) {
        part->face_count = part->material_uses = part->most_corners = 0;
        return;
    }
    part->groups += (index + 1) * (size_t)o->scene->material_count;
    part->polygon += (index + 1) * (size_t)o->most_corners;
    part->corners += (index + 1) * (size_t)o->most_corners;
}

/* Begins a part behind the head and the lines `before`. */
static void begin(struct part *p, const struct obj *o, unsigned index, const struct lines *before)
{
    p->reader = *o->reader;
    p->reader.strict = true;
    p->o = *o;
    p->o.reader = &p->reader;
    p->o.text.error = &p->reader.error;
    share(&p->o, o, index);
    if (o->pass == OBJ_FILL)
        repeat(&p->o, before->group, p->end);
    if (o->pass != OBJ_COUNT)
        repeat(&p->o, before->material, p->end);
    p->o.vertices.count += before->vertices;
    p->o.uvs.count += before->uvs;
    p->o.normals.count += before->normals;
    p->o.group_lines.count += before->groups;
    p->o.text.next = p->o.text.line_start = p->start;
    p->o.text.end = p->end;
}

static void begin_all(struct obj_parts *parts)
{
    struct lines before = {.vertices = 0};

    for (unsigned i = 0; i < PARTS; i++) {
        const struct lines *own = &parts->part[i].lines;
        begin(&parts->part[i], parts->whole, i, &before);
        before.vertices += own->vertices;
        before.uvs += own->uvs;
        before.normals += own->normals;
        before.groups += own->groups;
        before.material = own->material ? own->material : before.material;
        before.group = own->group ? own->group : before.group;
    }
}

/* ---- the passes ---- */

/* Skips a line; counts what it would add. */
static void pass_over(struct obj *o, const struct tia_word *word)
{
    o->vertices.count += tia_word_is(word, "v");
    o->uvs.count += tia_word_is(word, "vt");
    o->normals.count += tia_word_is(word, "vn");
    tia_text_skip(&o->text);
}

static void read_part(void *arg, unsigned index)
{
    struct obj_parts *parts = arg;
    struct part *p = &parts->part[index];
    struct tia_word word;

    while (!p->status && tia_text_line(&p->o.text)) {
        (void)tia_text_word(&p->o.text, &word);
        if (parts->kind != ALL_LINES && (*word.at == 'v') != (parts->kind == POINTS))
            pass_over(&p->o, &word);
        else if (p->o.pass == OBJ_COUNT && tia_word_is(&word, "mtllib"))
            p->status = TIA_ERR_RANGE;
        else
            p->status = tia_obj_statement(&p->o, &word);
    }
}

static bool read_kind(struct obj_parts *parts, enum line_kind kind)
{
    parts->kind = kind;
    begin_all(parts);
    return run(parts, read_part);
}

/* Adds what a part counted. */
static void add_count(struct obj *o, struct part *p)
{
    p->face_count = p->o.face_count;
    o->face_count += p->face_count;
    o->material_uses += p->o.material_uses;
    o->most_corners = p->o.most_corners > o->most_corners ? p->o.most_corners : o->most_corners;
    for (int i = 0; i < 3; i++) {
        o->model.min[i] = p->o.model.min[i] < o->model.min[i] ? p->o.model.min[i] : o->model.min[i];
        o->model.max[i] = p->o.model.max[i] > o->model.max[i] ? p->o.model.max[i] : o->model.max[i];
    }
}

bool tia_obj_read_parts(struct obj *o)
{
    struct obj_parts *parts = o->parts;
    const struct obj *last = &parts->part[PARTS - 1].o;
    bool fine = o->pass != OBJ_FILL || read_kind(parts, POINTS);

    fine = fine && read_kind(parts, o->pass == OBJ_COUNT ? ALL_LINES : FACES);
    for (unsigned i = 0; i < PARTS && fine && o->pass == OBJ_COUNT; i++)
        add_count(o, &parts->part[i]);
    o->vertices.count = last->vertices.count;
    o->uvs.count = last->uvs.count;
    o->normals.count = last->normals.count;
    o->group_lines.count = last->group_lines.count;
    return fine;
}

/* ---- the places of the faces ---- */

void tia_obj_count_faces(struct obj *o, uint32_t face_count)
{
    uint32_t materials = o->scene->material_count;

    o->groups[0].face_count = face_count;
    for (unsigned i = 0; i < PARTS && o->parts; i++) {
        o->groups[(i + 1) * (size_t)materials].face_count = o->parts->part[i].face_count;
        o->groups[0].face_count -= o->parts->part[i].face_count;
    }
}

void tia_obj_place_groups(struct obj *o)
{
    uint32_t next = 0, materials = o->scene->material_count, copies = o->parts ? PARTS + 1 : 1;

    for (uint32_t i = 0; i < materials; i++)
        for (uint32_t copy = 0; copy < copies; copy++) {
            struct obj_group *g = &o->groups[copy * (size_t)materials + i];
            g->next_face = next;
            next += g->face_count;
        }
}

void tia_obj_join_groups(struct obj *o)
{
    uint32_t materials = o->scene->material_count;

    for (size_t k = (size_t)materials; o->parts && k < (PARTS + 1) * (size_t)materials; k++) {
        struct obj_group *to = &o->groups[k % materials];
        const struct obj_group *more = &o->groups[k];
        to->face_count += more->face_count;
        to->next_face += more->face_count;
        for (int i = 0; i < 3; i++) {
            to->low[i] = more->low[i] < to->low[i] ? more->low[i] : to->low[i];
            to->high[i] = more->high[i] > to->high[i] ? more->high[i] : to->high[i];
        }
    }
}
