/* face.c - faces, gathered into one mesh per material. */
#include "obj.h"

enum part { PART_VERTEX, PART_UV, PART_NORMAL, PARTS };

/* Reads the integer at *p, which may be negative, and advances *p. Returns 0 if there is none. Once the value is 2^32 -
 * 1 or more, further digits are ignored. */
static int64_t take_index(const char **p, const char *end)
{
    const char *at = *p;
    int64_t index = 0;
    bool negative = at < end && *at == '-';

    for (at += negative; at < end && *at >= '0' && *at <= '9'; at++)
        index = index < UINT32_MAX ? index * 10 + (*at - '0') : index;
    *p = at;
    return negative ? -index : index;
}

/* Splits a corner V, V/VT, V//VN or V/VT/VN. VN may be empty (V//, V/VT/), as some programs write it. Missing parts get
 * the index 0. Returns false for any other form. */
static bool split(const struct tia_word *word, int64_t index[PARTS])
{
    const char *p = word->at, *end = word->at + word->length;

    index[PART_UV] = index[PART_NORMAL] = 0;
    index[PART_VERTEX] = take_index(&p, end);
    for (int part = PART_UV; part < PARTS && p < end && *p == '/'; part++) {
        const char *start = ++p;
        index[part] = take_index(&p, end);
        if (p > start ? !index[part] : part == PART_UV && (p == end || *p != '/'))
            return false;
    }
    return p == end && index[PART_VERTEX];
}

static int unknown(struct obj *o, const struct tia_word *word, enum part part, uint32_t count)
{
    static const char *const names[] = {"vertex", "texture coordinate", "normal"};

    (void)tia_text_error_at(&o->text, word);
    tia_say_word(o->text.error, word);
    tia_say(o->text.error, " refers to a ");
    tia_say(o->text.error, names[part]);
    tia_say(o->text.error, " that does not exist, expected ");
    if (count) {
        tia_say(o->text.error, "1 to ");
        tia_say_number(o->text.error, count);
        tia_say(o->text.error, ", those before this line");
    } else {
        tia_say(o->text.error, "one before this line");
    }
    if (!o->vertices.count)
        return TIA_ERR_RANGE; /* a face before any vertex: the file is not a model */
    return tia_obj_forgive(o, part == PART_VERTEX ? TIA_WARN_FACE : TIA_WARN_CORNER);
}

/* A face whose corners are being read. */
struct obj_face {
    uint32_t count;
    bool has[PARTS]; /* parts that all corners so far have; without PART_VERTEX the face is skipped */
};

/* Reads one corner; the indices in *corner count from 0. */
static int read_corner(struct obj *o, struct obj_face *face, struct tia_corner *corner, const struct tia_word *word)
{
    const uint32_t counts[PARTS] = {o->vertices.count, o->uvs.count, o->normals.count};
    uint32_t found[PARTS];
    int64_t index[PARTS];

    if (!split(word, index)) {
        face->has[PART_VERTEX] = false;
        (void)tia_text_error(&o->text, word, "is not a corner", "V, V/VT, V//VN or V/VT/VN");
        return tia_obj_forgive(o, TIA_WARN_FACE);
    }
    for (unsigned part = PART_VERTEX; part < PARTS; part++) {
        int64_t i = index[part] < 0 ? counts[part] + index[part] : index[part] - 1;
        bool is_there = i >= 0 && i < counts[part];
        int status = index[part] && !is_there ? unknown(o, word, (enum part)part, counts[part]) : TIA_OK;
        if (status)
            return status;
        found[part] = is_there ? (uint32_t)i : TIA_NO_INDEX;
    }
    *corner = (struct tia_corner){.vertex = found[PART_VERTEX], .normal = found[PART_NORMAL], .uv = found[PART_UV]};
    return TIA_OK;
}

/* Adds a corner to the face; the face has only the parts that all its corners have. */
static int add_corner(struct obj *o, struct obj_face *face, const struct tia_corner *corner,
                      const struct tia_word *word)
{
    bool has[PARTS] = {corner->vertex != TIA_NO_INDEX, corner->uv != TIA_NO_INDEX, corner->normal != TIA_NO_INDEX};
    bool is_mixed = face->count && (has[PART_UV] != face->has[PART_UV] || has[PART_NORMAL] != face->has[PART_NORMAL]);

    for (unsigned part = PART_VERTEX; part < PARTS; part++)
        face->has[part] = has[part] && (face->has[part] || (!face->count && part != PART_VERTEX));
    if (o->pass == OBJ_FILL && face->count < o->most_corners)
        o->corners[face->count] = *corner;
    face->count++;
    if (!is_mixed)
        return TIA_OK;
    (void)tia_text_error(&o->text, word, "is of another form", "all corners of a face alike");
    return tia_obj_forgive(o, TIA_WARN_CORNER);
}

/* ---- triangles ---- */

static void use(struct obj_group *g, enum part part, uint32_t index)
{
    if (index == TIA_NO_INDEX)
        return;
    g->low[part] = index < g->low[part] ? index : g->low[part];
    g->high[part] = index > g->high[part] ? index : g->high[part];
}

static void use_corners(struct obj *o, uint32_t count)
{
    struct obj_group *g = &o->groups[o->group];

    for (uint32_t i = 0; i < count; i++) {
        use(g, PART_VERTEX, o->corners[i].vertex);
        use(g, PART_UV, o->corners[i].uv);
        use(g, PART_NORMAL, o->corners[i].normal);
    }
}

static void add_faces(struct obj *o, uint32_t count)
{
    struct obj_group *g = &o->groups[o->group];

    use_corners(o, count);
    for (uint32_t i = 0; o->face_groups && i < count - 2; i++)
        o->face_groups[g->next_face + i] = o->face_group;
    tia_model_polygon(&o->faces[g->next_face], (const struct tia_vec3 *)(void *)o->vertices.items, o->corners, count,
                      o->polygon);
    g->next_face += count - 2;
}

/* Reads the corners of this line; only the last pass stores them. */
static int read_corners(struct obj *o, struct obj_face *face)
{
    struct tia_corner corner = {TIA_NO_INDEX, TIA_NO_INDEX, TIA_NO_INDEX};
    struct tia_word word;

    while (tia_text_word(&o->text, &word)) {
        if (face->count == POLYGON_MAX)
            return tia_text_error(&o->text, &word, "is one too many", "at most 4096 corners");
        int status = read_corner(o, face, &corner, &word);
        status = status ? status : add_corner(o, face, &corner, &word);
        if (status)
            return status;
    }
    if (face->count >= 3)
        return TIA_OK;
    face->has[PART_VERTEX] = false;
    (void)tia_text_error(&o->text, &word, "", "V, V/VT, V//VN or V/VT/VN");
    return tia_obj_forgive(o, TIA_WARN_FACE);
}

/* Removes from the corners the parts that not all of them have. */
static void strip_corners(struct obj *o, const struct obj_face *face)
{
    bool normals = face->has[PART_NORMAL] && tia_model_has_normals(&o->normals, o->corners, face->count);

    for (uint32_t i = 0; i < face->count; i++) {
        if (!face->has[PART_UV])
            o->corners[i].uv = TIA_NO_INDEX;
        if (!normals)
            o->corners[i].normal = TIA_NO_INDEX;
    }
}

int tia_obj_f(struct obj *o)
{
    struct obj_face face = {.has = {[PART_VERTEX] = true}};
    int status = read_corners(o, &face);

    if (status || !face.has[PART_VERTEX])
        return status;
    if (o->pass == OBJ_COUNT) {
        o->most_corners = face.count > o->most_corners ? face.count : o->most_corners;
        o->face_count += face.count - 2;
    } else if (o->pass == OBJ_MEASURE) {
        o->groups[o->group].face_count += face.count - 2;
    } else {
        strip_corners(o, &face);
        add_faces(o, face.count);
    }
    return TIA_OK;
}

/* ---- meshes ---- */

static const void *item(const struct tia_array *array, uint32_t index)
{
    return array->items + index * array->item;
}

static void remove_copies(const struct obj *o, struct obj_group *g)
{
    uint32_t first = g->next_face - g->face_count;

    g->face_count = tia_model_unique(&o->faces[first], o->face_groups ? &o->face_groups[first] : NULL, g->face_count,
                                     (const struct tia_vec3 *)(void *)o->vertices.items, o->table);
    g->next_face = first + g->face_count;
}

/* Makes the mesh of a group. Each of its arrays is the range from the first to the last element that the group uses. */
static struct tia_mesh make_mesh(const struct obj *o, const struct obj_group *g)
{
    uint32_t first = g->next_face - g->face_count;
    struct tia_face *faces = &o->faces[first];
    struct tia_mesh mesh = {.faces = faces, .face_count = g->face_count};

    mesh.groups = o->face_groups ? &o->face_groups[first] : NULL;
    mesh.vertices = item(&o->vertices, g->low[PART_VERTEX]);
    mesh.vertex_count = g->high[PART_VERTEX] - g->low[PART_VERTEX] + 1;
    if (g->low[PART_UV] <= g->high[PART_UV]) {
        mesh.uvs = item(&o->uvs, g->low[PART_UV]);
        mesh.uv_count = g->high[PART_UV] - g->low[PART_UV] + 1;
    }
    if (g->low[PART_NORMAL] <= g->high[PART_NORMAL]) {
        mesh.normals = item(&o->normals, g->low[PART_NORMAL]);
        mesh.normal_count = g->high[PART_NORMAL] - g->low[PART_NORMAL] + 1;
    }
    for (uint32_t i = 0; i < 3 * g->face_count; i++) {
        struct tia_corner *c = &faces[i / 3].corner[i % 3];
        c->vertex -= g->low[PART_VERTEX];
        c->uv -= c->uv == TIA_NO_INDEX ? 0 : g->low[PART_UV];
        c->normal -= c->normal == TIA_NO_INDEX ? 0 : g->low[PART_NORMAL];
    }
    return mesh;
}

/* Limit of the total number of normals of all meshes. If many materials are used all over the file, every mesh spans
 * nearly all normals, and a loop over all meshes takes time quadratic in the size of the file. */
#define SEEN_MAX (UINT64_C(1) << 30)

int tia_obj_make_meshes(struct obj *o, struct tia_mesh *meshes, struct tia_shape *shapes)
{
    uint32_t count = 0;
    uint64_t seen = 0; /* total number of normals of all meshes */

    tia_model_fix_normals(&o->normals);
    for (uint32_t i = 0; i < o->scene->material_count; i++) {
        if (!o->groups[i].face_count)
            continue;
        remove_copies(o, &o->groups[i]);
        meshes[count] = make_mesh(o, &o->groups[i]);
        shapes[count] = (struct tia_shape){.kind = TIA_MESH, .material = i, .mesh = count};
        seen += meshes[count].normal_count;
        count++;
    }
    o->scene->meshes = meshes;
    o->scene->shapes = shapes;
    o->scene->mesh_count = o->scene->shape_count = count;
    if (seen <= SEEN_MAX || count == 1)
        return TIA_OK;
    tia_say(&o->reader->error,
            "the materials are scattered over the vertices, expected those of each to be near each other");
    return TIA_ERR_RANGE;
}
