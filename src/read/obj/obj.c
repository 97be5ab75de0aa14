/* obj.c - Wavefront's .obj: polygons with materials, normals and texture coordinates.
 *
 *     v x y z          a weight or a colour after z is skipped
 *     vt u [v [w]]     v points up, as the scene's does
 *     vn x y z         of any length
 *     f                3 to POLYGON_MAX corners V, V/VT, V//VN or V/VT/VN; indices from 1, or backwards from -1
 *     usemtl mtllib    see material.c and mtl.c; before the first usemtl faces are grey
 *
 *     o g              see group.c
 *
 * The faces of one material, wherever they are, make one mesh. Smoothing groups, points and lines are skipped.
 * The format has no camera, light or unit: see frame.c.
 *
 * Many programs write files full of small mistakes, and other programs draw them nevertheless. So most mistakes cause
 * warnings, one for each kind of mistake; with reader->strict they are errors. Mistakes in vertices are always errors:
 * without them the model's shape is unknown.
 */
#include "obj.h"

/* ---- texture coordinates and normals ---- */

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

/* ---- the whole file ---- */

static const struct {
    const char *name;
    int (*read)(struct obj *);
} statements[] = {
    {"v", tia_obj_v},           {"f", tia_obj_f},           {"vn", read_vn},  {"vt", read_uv},
    {"usemtl", tia_obj_usemtl}, {"mtllib", tia_obj_mtllib}, {"o", tia_obj_o}, {"g", tia_obj_g},
};

static const char *const skipped[] = {"s",        "l",          "p",         "mg",     "lod",    "bevel", "c_interp",
                                      "d_interp", "shadow_obj", "trace_obj", "usemap", "maplib", "vp"};

/* Skips the rest of a line with a mistake, and warns. */
static int skip_mistake(struct obj *o)
{
    tia_obj_skip(&o->text);
    return tia_obj_forgive(o, TIA_WARN_STATEMENT);
}

static int read_statement(struct obj *o, const struct tia_word *word)
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

/* Reads the text once. */
static int read_text(struct obj *o)
{
    struct tia_word word;

    tia_array_restart(&o->vertices);
    tia_array_restart(&o->normals);
    tia_array_restart(&o->uvs);
    tia_array_restart(&o->group_lines);
    o->group = o->face_group = 0;
    o->text = tia_text_begin(o->reader->text, o->reader->length, "", &o->reader->error);
    while (tia_text_line(&o->text)) {
        (void)tia_text_word(&o->text, &word);
        int status = read_statement(o, &word);
        if (status)
            return status;
    }
    return TIA_OK;
}

/* Reads all libraries once. */
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

/* Memory besides the struct tia_arrays. */
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
    (void)tia_array_place(arena, &o->group_lines);
    o->face_groups = tia_arena_take(arena, o->group_lines.capacity ? o->face_count : 0, sizeof *o->face_groups);
    o->groups = tia_arena_take(arena, materials, sizeof *o->groups);
    o->polygon = tia_arena_take(arena, o->most_corners, sizeof *o->polygon);
    o->corners = tia_arena_take(arena, o->most_corners, sizeof *o->corners);
    return p;
}

/* Sorts the names. A pass without errors has filled the array to its capacity. */
static void sort(struct tia_array *names)
{
    if (names->capacity)
        tia_names_sort((struct tia_name *)(void *)names->items, names->capacity);
}

static int measure(struct obj *o)
{
    o->pass = OBJ_MEASURE;
    int status = read_libraries(o);
    if (status)
        return status;
    sort(&o->names);
    for (uint32_t i = 0; i < o->scene->material_count; i++)
        o->groups[i] = (struct obj_group){.low = {UINT32_MAX, UINT32_MAX, UINT32_MAX}};
    status = read_text(o);
    if (status)
        return status;
    tia_obj_place_groups(o);
    sort(&o->group_lines);
    return TIA_OK;
}

static int fill(struct obj *o, const struct places *p)
{
    int status = measure(o);

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
                    .uvs = {.item = sizeof(struct tia_uv)},
                    .group_lines = {.item = sizeof(struct tia_name)}};

    tia_mtl_add_default(&o);
    int status = read_text(&o);
    status = status ? status : tia_obj_fit(&o);
    if (status)
        return status;
    struct places p = place(&o, arena);
    return tia_arena_fits(arena) ? fill(&o, &p) : TIA_OK;
}
