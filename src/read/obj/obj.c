/* obj.c - Wavefront's .obj: polygons with materials, normals and texture coordinates.
 *
 *     v x y z          what follows, a weight or a colour, is not used
 *     vt u [v [w]]     v upwards from below: tia's is 1 - v
 *     vn x y z         of any length but 0
 *     f                V, V/VT, V//VN or V/VT/VN, from 1 or, backwards, from -1; 3 to POLYGON_MAX corners
 *     usemtl mtllib    see mtl.c; before the first usemtl things are grey
 *
 * The faces of one material, wherever they are, make one mesh. Groups, objects, smoothing groups, points
 * and lines are skipped; curves and surfaces of free form are errors. The format has no camera, light and
 * unit: see obj_frame.c.
 */
#include "obj.h"

static int read_uv(struct obj *o)
{
    struct tia_uv uv = {0, 0};
    struct tia_word word;
    tia_q16 more;
    int status = tia_text_q16(&o->text, &uv.u);

    if (!status && tia_text_peek(&o->text, &word))
        status = tia_text_q16(&o->text, &uv.v);
    if (!status && tia_text_has_number(&o->text))
        status = tia_text_q16(&o->text, &more);
    if (status)
        return status;
    if (uv.v <= TIA_Q16_ONE - INT32_MAX)
        return tia_text_error(&o->text, &word, "is out of range", "a number from -32766 to below 32768");
    uv.v = TIA_Q16_ONE - uv.v;
    tia_array_add(&o->uvs, &uv);
    return TIA_OK;
}

static int read_vn(struct obj *o)
{
    struct tia_dir3 normal = {0, 0, 0};
    int status = tia_text_dir3(&o->text, &normal);

    tia_array_add(&o->normals, &normal);
    return status;
}

/* ---- materials ---- */

static int read_usemtl(struct obj *o)
{
    struct tia_word word;
    int status = tia_obj_name(&o->text, &word, "a material's name");

    o->material_uses++;
    if (status || o->pass == OBJ_COUNT)
        return status;
    const struct tia_name *name =
        tia_names_find((struct tia_name *)(void *)o->names.items, o->names.capacity, OBJ_MATERIAL, &word);
    if (!name)
        return tia_text_error(&o->text, &word, "is no material", "one that a mtllib has");
    o->group = name->index;
    return TIA_OK;
}

static bool is_same(const struct tia_word *a, const struct tia_word *b)
{
    uint32_t i = 0;

    while (i < a->length && i < b->length && a->at[i] == b->at[i])
        i++;
    return i == a->length && i == b->length;
}

static bool is_known(const struct obj *o, const struct tia_word *word)
{
    for (uint32_t i = 0; i < o->library_count; i++)
        if (is_same(word, &o->libraries[i].name))
            return true;
    return false;
}

static int fetch_library(struct obj *o, const struct tia_word *word)
{
    struct obj_library *library = &o->libraries[o->library_count];
    const char *why = "there is nothing that could";
    char name[TIA_NAME_MAX + 1];

    if (o->library_count == OBJ_LIBRARIES)
        return tia_text_error(&o->text, word, "is one too many", "at most 16 material libraries");
    *library = (struct obj_library){.name = *word};
    tia_word_copy(name, word);
    if (!o->reader->library || o->reader->library(o->reader->ctx, name, &library->text, &library->length, &why) < 0) {
        (void)tia_text_error_at(&o->text, word);
        tia_say_word(o->text.error, word);
        tia_say(o->text.error, " cannot be read: ");
        tia_say(o->text.error, why);
        tia_say(o->text.error, ", expected a material library");
        return TIA_ERR_RANGE;
    }
    if ((uint64_t)library->length >= UINT32_MAX)
        return tia_text_error(&o->text, word, "is too long", "less than 4 GiB");
    o->library_count++;
    return tia_mtl_read(o, library);
}

/* Each library is fetched and counted where it is first named. */
static int read_mtllib(struct obj *o)
{
    struct tia_word word;

    do {
        int status = tia_text_file(&o->text, &word, "a file's name");
        if (!status && o->pass == OBJ_COUNT && !is_known(o, &word))
            status = fetch_library(o, &word);
        if (status)
            return status;
    } while (tia_text_peek(&o->text, &word));
    return TIA_OK;
}

/* ---- all of it ---- */

static const struct {
    const char *name;
    int (*read)(struct obj *);
} statements[] = {
    {"v", tia_obj_v}, {"f", tia_obj_f},        {"vn", read_vn},
    {"vt", read_uv},  {"usemtl", read_usemtl}, {"mtllib", read_mtllib},
};

static const char *const skipped[] = {"g",          "s",         "o",      "l",        "p",
                                      "mg",         "lod",       "bevel",  "c_interp", "d_interp",
                                      "shadow_obj", "trace_obj", "usemap", "maplib",   "vp"};

static int read_statement(struct obj *o, const struct tia_word *word)
{
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (tia_word_is(word, statements[i].name)) {
            int status = statements[i].read(o);
            return status ? status : tia_text_end(&o->text);
        }
    for (size_t i = 0; i < sizeof skipped / sizeof *skipped; i++)
        if (tia_word_is(word, skipped[i])) {
            tia_text_skip(&o->text);
            return TIA_OK;
        }
    return tia_text_error(&o->text, word, "is no statement", "v, vt, vn, f, g, o, s, usemtl or mtllib");
}

/* One pass over the text. */
static int read_text(struct obj *o)
{
    struct tia_word word;

    tia_array_restart(&o->vertices);
    tia_array_restart(&o->normals);
    tia_array_restart(&o->uvs);
    o->group = 0;
    o->text = tia_text_begin(o->reader->text, o->reader->length, "", &o->reader->error);
    while (tia_text_line(&o->text)) {
        (void)tia_text_word(&o->text, &word);
        int status = read_statement(o, &word);
        if (status)
            return status;
    }
    return TIA_OK;
}

/* One pass over the libraries. */
static int read_libraries(struct obj *o)
{
    int status = TIA_OK;

    tia_array_restart(&o->materials);
    tia_array_restart(&o->textures);
    tia_mtl_add_default(o);
    for (uint32_t i = 0; !status && i < o->library_count; i++)
        status = tia_mtl_read(o, &o->libraries[i]);
    return status;
}

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* What is placed besides the arrays. */
struct places {
    struct tia_mesh *meshes;
    struct tia_shape *shapes;
    struct tia_light *lights;
};

static struct places place(struct obj *o, struct tia_arena *arena)
{
    uint32_t materials = o->materials.count, meshes = least(materials, least(o->material_uses + 1, o->face_count));
    struct places p;

    o->scene->material_count = materials;
    o->scene->texture_count = o->textures.count;
    o->scene->materials = tia_array_place(arena, &o->materials);
    o->scene->textures = tia_array_place(arena, &o->textures);
    (void)tia_array_place(arena, &o->vertices);
    (void)tia_array_place(arena, &o->normals);
    (void)tia_array_place(arena, &o->uvs);
    o->faces = tia_arena_take(arena, o->face_count, sizeof *o->faces);
    p.meshes = tia_arena_take(arena, meshes, sizeof *p.meshes);
    p.shapes = tia_arena_take(arena, meshes, sizeof *p.shapes);
    p.lights = tia_arena_take(arena, OBJ_LIGHTS, sizeof *p.lights);
    (void)tia_array_place(arena, &o->names);
    o->groups = tia_arena_take(arena, materials, sizeof *o->groups);
    o->polygon = tia_arena_take(arena, o->most_corners, sizeof *o->polygon);
    o->corners = tia_arena_take(arena, o->most_corners, sizeof *o->corners);
    return p;
}

static int fill(struct obj *o, const struct places *p)
{
    struct tia_name *names = (struct tia_name *)(void *)o->names.items;

    o->pass = OBJ_MEASURE;
    int status = read_libraries(o);
    if (o->names.capacity)
        tia_names_sort(names, o->names.capacity);
    for (uint32_t i = 0; i < o->scene->material_count; i++)
        o->groups[i] = (struct obj_group){.low = {UINT32_MAX, UINT32_MAX, UINT32_MAX}};
    status = status ? status : read_text(o);
    tia_obj_place_groups(o);
    o->pass = OBJ_FILL;
    status = status ? status : read_libraries(o);
    status = status ? status : read_text(o);
    status = status ? status : tia_obj_make_meshes(o, p->meshes, p->shapes);
    return status ? status : tia_obj_frame(o, p->lights);
}

int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    struct obj o = {.reader = reader,
                    .scene = scene,
                    .materials = {.item = sizeof(struct tia_material)},
                    .textures = {.item = sizeof(struct tia_texture)},
                    .names = {.item = sizeof(struct tia_name)},
                    .vertices = {.item = sizeof(struct tia_vec3)},
                    .normals = {.item = sizeof(struct tia_dir3)},
                    .uvs = {.item = sizeof(struct tia_uv)}};

    tia_mtl_add_default(&o);
    int status = read_text(&o);
    status = status ? status : tia_obj_fit(&o);
    if (status)
        return status;
    struct places p = place(&o, arena);
    return tia_arena_fits(arena) ? fill(&o, &p) : TIA_OK;
}
