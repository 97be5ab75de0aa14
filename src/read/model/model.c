#include "model.h"

#include <tia/fit.h>

#include "read/surface.h"

#define FAR_AWAY (INT64_C(4096) << TIA_MODEL_BITS)
#define SMALL (INT64_C(1) << (TIA_MODEL_BITS - 1))
#define TINY (INT64_C(1) << (TIA_MODEL_BITS - 16))

struct tia_model tia_model_begin(struct tia_reader *reader, struct tia_scene *scene, struct tia_model_use *use)
{
    return (struct tia_model){.reader = reader,
                              .scene = scene,
                              .use = use,
                              .counting = true,
                              .min = {INT64_MAX, INT64_MAX, INT64_MAX},
                              .max = {INT64_MIN, INT64_MIN, INT64_MIN}};
}

struct tia_text tia_model_text(const struct tia_model *model)
{
    const struct tia_reader *reader = model->reader;

    return tia_text_begin(reader->text, reader->length, model->use ? model->use->file : "", &model->reader->error);
}

unsigned tia_model_bits(const struct tia_model *model)
{
    return model->counting || model->moved ? TIA_MODEL_FINE_BITS
                                           : (unsigned)(16 + (model->use ? model->use->scale_bits : 0));
}

static void measure(struct tia_model *m, const int64_t v[3])
{
    for (int i = 0; i < 3; i++) {
        int64_t at = v[i] >> (TIA_MODEL_FINE_BITS - TIA_MODEL_BITS);
        m->min[i] = at < m->min[i] ? at : m->min[i];
        m->max[i] = at > m->max[i] ? at : m->max[i];
        m->rounded = m->rounded || v[i] & 0xffff;
    }
}

struct tia_vec3 tia_model_vertex(struct tia_model *m, const int64_t v[3])
{
    if (!m->counting)
        return tia_model_place(m, v);
    measure(m, v);
    return (struct tia_vec3){0, 0, 0};
}

int tia_model_refuse(const struct tia_model *model, const char *why)
{
    struct tia_read_error *error = &model->reader->error;
    const char *file = model->use ? model->use->file : "";
    unsigned i = 0;

    for (; i < TIA_NAME_MAX && file[i]; i++)
        error->file[i] = file[i];
    error->file[i] = 0;
    tia_say(error, why);
    return TIA_ERR_RANGE;
}

int tia_model_forgive(struct tia_reader *reader, enum tia_read_warning_kind kind, const char *remedy, bool counts)
{
    struct tia_read_error *error = &reader->error;
    struct tia_read_warning *warning = reader->warnings;

    if (reader->strict)
        return TIA_ERR_RANGE;
    if (warning && counts && !warning[kind].count++) {
        warning[kind].at = *error;
        tia_say(&warning[kind].at, "; ");
        tia_say(&warning[kind].at, remedy);
    }
    error->file[0] = error->text[0] = 0;
    error->line = error->column = error->length = error->source_length = 0;
    error->source = NULL;
    return TIA_OK;
}

/* Passes the bounds on to the scene that the model is a part of. */
static void note_use(const struct tia_model *m)
{
    for (int i = 0; i < 3; i++) {
        m->use->min[i] = m->min[i];
        m->use->max[i] = m->max[i];
    }
    m->use->rounded = m->rounded;
}

static int choose_unit(struct tia_model *m)
{
    int64_t half = 0, farthest = 0;

    for (int i = 0; i < 3; i++) {
        int64_t size = (m->max[i] - m->min[i] + 1) / 2;
        half = size > half ? size : half;
        farthest = m->max[i] > farthest ? m->max[i] : farthest;
        farthest = -m->min[i] > farthest ? -m->min[i] : farthest;
        m->origin[i] = m->min[i] + size;
    }
    if (half < TINY)
        return tia_model_refuse(m, "the model is too small, expected an extent of more than 1/32768");
    m->moved = half < SMALL || farthest > FAR_AWAY;
    /* `half` has 64 - clz bits, of which 20 are kept: 8..16 in Q16.16. */
    m->shift = 44 - (int)tia_clz64((uint64_t)half);
    return TIA_OK;
}

int tia_model_fit(struct tia_model *m, uint32_t face_count, bool has_vertices, const char *expected)
{
    m->counting = false;
    if (m->use)
        note_use(m);
    if (!face_count) {
        int status = tia_model_refuse(m, "the model has no faces, expected ");
        tia_say(&m->reader->error, expected);
        return has_vertices ? tia_model_forgive(m->reader, TIA_WARN_EMPTY, "only the background is drawn", true)
                            : status;
    }
    if (face_count > TIA_OBJECTS_MAX)
        return tia_model_refuse(m, "the model has too many faces, expected at most 16777216");
    return m->use ? TIA_OK : choose_unit(m);
}

/* ---- the camera and the lights ---- */

struct bounds {
    int64_t min[3], max[3];
};

static void extend(struct bounds *b, const struct tia_vec3 *v)
{
    const int64_t at[3] = {v->x, v->y, v->z};

    for (int i = 0; i < 3; i++) {
        b->min[i] = at[i] < b->min[i] ? at[i] : b->min[i];
        b->max[i] = at[i] > b->max[i] ? at[i] : b->max[i];
    }
}

static uint64_t square(int64_t x)
{
    return (uint64_t)(x * x);
}

static struct tia_vec3 middle(const struct bounds *b)
{
    return (struct tia_vec3){(tia_q16)((b->min[0] + b->max[0]) >> 1), (tia_q16)((b->min[1] + b->max[1]) >> 1),
                             (tia_q16)((b->min[2] + b->max[2]) >> 1)};
}

/* Returns the square of the distance from c to the farthest vertex of a face. Coordinates are within 4096, so the sum
 * of squares is below 2^61. */
static uint64_t farthest(const struct tia_scene *scene, struct tia_vec3 c)
{
    uint64_t most = 0;

    for (uint32_t m = 0; m < scene->mesh_count; m++)
        for (uint32_t i = 0; i < 3 * scene->meshes[m].face_count; i++) {
            const struct tia_mesh *mesh = &scene->meshes[m];
            const struct tia_vec3 *v = &mesh->vertices[mesh->faces[i / 3].corner[i % 3].vertex];
            uint64_t distance = square((int64_t)v->x - c.x) + square((int64_t)v->y - c.y) + square((int64_t)v->z - c.z);
            most = distance > most ? distance : most;
        }
    return most;
}

static void set_placement(const struct tia_model *m)
{
    struct tia_placement *placement = &m->reader->placement;

    for (int i = 0; i < 3 && m->moved; i++)
        placement->origin[i] = m->origin[i] * (INT64_C(1) << (32 - TIA_MODEL_BITS));
    placement->bits = m->moved ? TIA_MODEL_BITS - 16 - m->shift : 0;
}

int tia_model_frame(struct tia_model *m, struct tia_light *lights)
{
    struct tia_scene *scene = m->scene;
    struct bounds b = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};

    for (uint32_t k = 0; k < scene->mesh_count; k++)
        for (uint32_t i = 0; i < 3 * scene->meshes[k].face_count; i++)
            extend(&b, &scene->meshes[k].vertices[scene->meshes[k].faces[i / 3].corner[i % 3].vertex]);
    /* without faces no object is visible, and any position will do */
    struct tia_vec3 c = scene->mesh_count ? middle(&b) : (struct tia_vec3){0, 0, 0};
    uint64_t radius = scene->mesh_count ? tia_sqrt64(farthest(scene, c)) + UINT64_C(1) : TIA_Q16_ONE;
    if (radius < TIA_RADIUS_MIN)
        return tia_model_refuse(m, "all faces lie in one point, expected a model");
    scene->camera = tia_model_view(c, radius, lights);
    set_placement(m);
    tia_camera_alter(&scene->camera, m->reader->camera, &m->reader->placement);
    scene->background = tia_grey(TIA_Q30(0.8));
    scene->lights = lights;
    scene->light_count = TIA_MODEL_LIGHTS;
    return TIA_OK;
}

/* ---- faces ---- */

static void set_face(struct tia_face *face, const struct tia_corner *corners, const uint32_t triangle[3])
{
    for (int i = 0; i < 3; i++)
        face->corner[i] = corners[triangle[i]];
}

void tia_model_polygon(struct tia_face *faces, const struct tia_vec3 *vertices, const struct tia_corner *corners,
                       uint32_t count, struct polygon_corner *work)
{
    struct polygon polygon;
    uint32_t triangle[3] = {0, 1, 2};

    if (count == 3) { /* what the triangulation gives */
        set_face(faces, corners, triangle);
        return;
    }
    for (uint32_t i = 0; i < count; i++)
        work[i].point = vertices[corners[i].vertex];
    tia_polygon_begin(&polygon, work, count);
    while (tia_polygon_next(&polygon, triangle))
        set_face(faces++, corners, triangle);
}

static bool is_zero(const struct tia_dir3 *normal)
{
    return !normal->x && !normal->y && !normal->z;
}

bool tia_model_has_normals(const struct tia_array *normals, const struct tia_corner *corners, uint32_t count)
{
    const struct tia_dir3 *all = (const struct tia_dir3 *)(const void *)normals->items;

    for (uint32_t i = 0; i < count; i++)
        if (corners[i].normal == TIA_NO_INDEX || is_zero(&all[corners[i].normal]))
            return false;
    return true;
}

void tia_model_fix_normals(struct tia_array *normals)
{
    struct tia_dir3 *all = (struct tia_dir3 *)(void *)normals->items;

    for (uint32_t i = 0; i < normals->count; i++)
        if (is_zero(&all[i]))
            all[i].z = TIA_Q30_ONE;
}
