#include "plain.h"

#include "read/surface.h"

struct tia_plain tia_plain_begin(struct tia_reader *reader, struct tia_scene *scene, struct tia_model_use *use,
                                 const char *faces_expected)
{
    return (struct tia_plain){.model = tia_model_begin(reader, scene, use),
                              .faces_expected = faces_expected,
                              .vertices = {.item = sizeof(struct tia_vec3)},
                              .normals = {.item = sizeof(struct tia_dir3)},
                              .uvs = {.item = sizeof(struct tia_uv)}};
}

void tia_plain_corner(struct tia_plain *p, uint32_t corner, uint32_t vertex)
{
    if (!p->model.counting && corner < p->most_corners)
        p->corners[corner] = (struct tia_corner){.vertex = vertex,
                                                 .normal = p->normals.capacity ? vertex : TIA_NO_INDEX,
                                                 .uv = p->uvs.capacity ? vertex : TIA_NO_INDEX};
}

void tia_plain_polygon(struct tia_plain *p, uint32_t count)
{
    if (p->model.counting) {
        p->most_corners = count > p->most_corners ? count : p->most_corners;
    } else {
        bool normals = tia_model_has_normals(&p->normals, p->corners, count);
        for (uint32_t i = 0; !normals && i < count; i++)
            p->corners[i].normal = TIA_NO_INDEX;
        tia_model_polygon(&p->faces[p->face_count], (const struct tia_vec3 *)(void *)p->vertices.items, p->corners,
                          count, p->polygon);
    }
    p->face_count += count - 2;
}

int tia_plain_error(const struct tia_plain *p, const char *thing, uint32_t number)
{
    p->model.reader->error.text[0] = 0;
    (void)tia_model_refuse(&p->model, thing);
    tia_say(&p->model.reader->error, " ");
    tia_say_number(&p->model.reader->error, (int64_t)number);
    tia_say(&p->model.reader->error, ": ");
    return TIA_ERR_RANGE;
}

int tia_plain_forgive(struct tia_plain *p, enum tia_read_warning_kind kind, const char *remedy)
{
    return tia_model_forgive(p->model.reader, kind, remedy, p->model.counting);
}

/* Memory besides the struct tia_arrays. */
struct places {
    struct tia_material *material;
    struct tia_mesh *mesh;
    struct tia_shape *shape;
    struct tia_light *lights;
};

static struct places place(struct tia_plain *p, struct tia_arena *arena)
{
    struct places at;

    if (p->model.use)
        p->model.use->mesh_most = 1;
    p->model.scene->material_count = 1;
    at.material = tia_arena_take(arena, 1, sizeof *at.material);
    at.mesh = tia_arena_take(arena, 1, sizeof *at.mesh);
    at.shape = tia_arena_take(arena, 1, sizeof *at.shape);
    at.lights = tia_arena_take(arena, TIA_MODEL_LIGHTS, sizeof *at.lights);
    p->corners = tia_arena_take(arena, p->most_corners, sizeof *p->corners);
    p->polygon = tia_arena_take(arena, p->most_corners > 3 ? p->most_corners : 0, sizeof *p->polygon);
    p->faces = tia_arena_take(arena, p->face_count, sizeof *p->faces);
    p->table = tia_arena_take(arena, p->distinct ? 0 : tia_model_slots(p->face_count), sizeof *p->table);
    (void)tia_array_place(arena, &p->normals);
    (void)tia_array_place(arena, &p->uvs);
    (void)tia_array_place(arena, &p->vertices);
    return at;
}

/* Returns the mean of the vertices' colours; grey if they have none. */
static struct tia_rgb colour_of(const struct tia_plain *p)
{
    tia_q30 mean[3];

    for (int i = 0; i < 3 && p->colours; i++)
        mean[i] = (tia_q30)(((p->colour[i] * UINT64_C(65536) / 255 / p->colours) << 14));
    return p->colours ? (struct tia_rgb){mean[0], mean[1], mean[2]} : tia_grey(TIA_Q30(0.8));
}

static void finish(struct tia_plain *p, const struct places *at)
{
    struct tia_scene *scene = p->model.scene;

    tia_model_fix_normals(&p->normals);
    if (!p->distinct)
        p->face_count = tia_model_unique(p->faces, NULL, p->face_count,
                                         (const struct tia_vec3 *)(void *)p->vertices.items, p->table);
    *at->material = (struct tia_material){.colour = colour_of(p), .index = TIA_Q16_ONE};
    *at->mesh = (struct tia_mesh){.vertices = (const struct tia_vec3 *)(void *)p->vertices.items,
                                  .normals = (const struct tia_dir3 *)(void *)p->normals.items,
                                  .uvs = (const struct tia_uv *)(void *)p->uvs.items,
                                  .faces = p->faces,
                                  .vertex_count = p->vertices.count,
                                  .normal_count = p->normals.count,
                                  .uv_count = p->uvs.count,
                                  .face_count = p->face_count};
    *at->shape = (struct tia_shape){.kind = TIA_MESH};
    scene->materials = at->material;
    scene->meshes = at->mesh;
    scene->shapes = at->shape;
    scene->mesh_count = scene->shape_count = p->face_count > 0;
}

static int read_once(struct tia_plain *p, int (*read)(struct tia_plain *, void *ctx), void *ctx)
{
    tia_array_restart(&p->vertices);
    tia_array_restart(&p->normals);
    tia_array_restart(&p->uvs);
    p->face_count = p->colours = 0;
    p->colour[0] = p->colour[1] = p->colour[2] = 0;
    return read(p, ctx);
}

int tia_plain_read(struct tia_plain *p, struct tia_arena *arena, int (*read)(struct tia_plain *, void *ctx), void *ctx)
{
    int status = read_once(p, read, ctx);

    status = status ? status : tia_model_fit(&p->model, p->face_count, p->vertices.count > 0, p->faces_expected);
    if (status)
        return status;
    struct places at = place(p, arena);
    if (!tia_arena_fits(arena))
        return TIA_OK;
    status = read_once(p, read, ctx);
    if (status)
        return status;
    finish(p, &at);
    return p->model.use ? TIA_OK : tia_model_frame(&p->model, at.lights);
}
