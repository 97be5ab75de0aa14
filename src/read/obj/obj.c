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
 * The format has no camera, light or unit: see read/model/model.h.
 *
 * Many programs write files full of small mistakes, and other programs draw them nevertheless. So most mistakes cause
 * warnings, one for each kind of mistake; with reader->strict they are errors. Mistakes in vertices are always errors:
 * without them the model's shape is unknown.
 */
#include "obj.h"

/* Status of a text whose parts cannot be read by several threads. */
#define UNSUITED 1

/* Reads the text once. */
static int read_text(struct obj *o)
{
    struct tia_word word;

    tia_array_restart(&o->vertices);
    tia_array_restart(&o->normals);
    tia_array_restart(&o->uvs);
    tia_array_restart(&o->group_lines);
    o->group = o->face_group = 0;
    o->text = tia_model_text(&o->model);
    o->text.end = o->parts ? o->head_end : o->text.end;
    while (tia_text_line(&o->text)) {
        (void)tia_text_word(&o->text, &word);
        int status = tia_obj_statement(o, &word);
        if (status)
            return o->parts ? UNSUITED : status;
    }
    return o->parts && !tia_obj_read_parts(o) ? UNSUITED : TIA_OK;
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
    uint32_t copies = tia_obj_copies(o->reader, materials);
    struct places p;

    if (o->model.use)
        o->model.use->mesh_most = meshes;
    o->scene->material_count = materials;
    o->scene->texture_count = o->textures.count;
    o->scene->materials = tia_array_place(arena, &o->materials);
    o->scene->textures = tia_array_place(arena, &o->textures);
    (void)tia_array_place(arena, &o->vertices);
    (void)tia_array_place(arena, &o->normals);
    (void)tia_array_place(arena, &o->uvs);
    o->faces = tia_arena_take(arena, o->face_count, sizeof *o->faces);
    o->table = tia_arena_take(arena, tia_model_slots(o->face_count), sizeof *o->table);
    p.meshes = tia_arena_take(arena, meshes, sizeof *p.meshes);
    p.shapes = tia_arena_take(arena, meshes, sizeof *p.shapes);
    p.lights = tia_arena_take(arena, TIA_MODEL_LIGHTS, sizeof *p.lights);
    (void)tia_array_place(arena, &o->names);
    (void)tia_array_place(arena, &o->group_lines);
    o->face_groups = tia_arena_take(arena, o->group_lines.capacity ? o->face_count : 0, sizeof *o->face_groups);
    o->groups = tia_arena_take(arena, materials * copies, sizeof *o->groups);
    o->polygon = tia_arena_take(arena, o->most_corners * copies, sizeof *o->polygon);
    o->corners = tia_arena_take(arena, o->most_corners * copies, sizeof *o->corners);
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
    for (uint32_t i = 0; i < o->scene->material_count * tia_obj_copies(o->reader, o->scene->material_count); i++)
        o->groups[i] = (struct obj_group){.low = {UINT32_MAX, UINT32_MAX, UINT32_MAX}};
    if (o->material_uses || o->group_lines.capacity)
        status = read_text(o);
    else
        tia_obj_count_faces(o, o->face_count);
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
    if (!status)
        tia_obj_join_groups(o);
    status = status ? status : tia_obj_make_meshes(o, p->meshes, p->shapes);
    return status || o->model.use ? status : tia_model_frame(&o->model, p->lights);
}

/* Reads the whole file; `parts`: by several threads, or NULL. */
static int read_file(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                     struct tia_model_use *use, struct obj_parts *parts)
{
    struct obj o = {.model = tia_model_begin(reader, scene, use),
                    .reader = reader,
                    .scene = scene,
                    .materials = {.item = sizeof(struct tia_material)},
                    .textures = {.item = sizeof(struct tia_texture)},
                    .names = {.item = sizeof(struct tia_name)},
                    .vertices = {.item = sizeof(struct tia_vec3)},
                    .normals = {.item = sizeof(struct tia_dir3)},
                    .uvs = {.item = sizeof(struct tia_uv)},
                    .group_lines = {.item = sizeof(struct tia_name)},
                    .parts = parts};

    if (parts && !tia_obj_divide(&o))
        return UNSUITED;
    tia_mtl_add_default(&o);
    int status = read_text(&o);
    status = status ? status : tia_model_fit(&o.model, o.face_count, o.vertices.count > 0, "some f");
    if (status)
        return status;
    struct places p = place(&o, arena);
    if (parts && tia_obj_copies(reader, o.scene->material_count) == 1)
        return UNSUITED;
    return tia_arena_fits(arena) ? fill(&o, &p) : TIA_OK;
}

int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena, struct tia_model_use *use)
{
    struct obj_parts *parts = tia_obj_take_parts(reader, arena);
    const struct tia_arena before = *arena;
    int status = parts ? read_file(reader, scene, arena, use, parts) : UNSUITED;

    if (status != UNSUITED)
        return status;
    *arena = before;
    *scene = (struct tia_scene){.bvh = NULL};
    reader->error = (struct tia_read_error){.line = 0};
    for (unsigned i = 0; reader->warnings && i < TIA_WARNINGS; i++)
        reader->warnings[i].count = 0;
    return read_file(reader, scene, arena, use, NULL);
}
