/* frame.c - a unit of length, a camera and lights for a model: an .obj file has none.
 *
 * A model keeps its coordinates if they are within 4096 and its largest extent is at least 1. Its points are then
 * nearer than 32768 to the camera, which is at most 3.93 radii from each of them, and the last bit of a coordinate is
 * at most 2^-16 of the model's size. Any other model is moved, so that the middle of its bounds is the origin, and
 * scaled by a power of two, so that it extends 8 to 16 from there. The picture stays the same, since nothing else in an
 * .obj file has a size. Only models smaller than 2^-15 are refused: 28 fractional bits are too few for their shape.
 */
#include <tia/fit.h>

#include "math/integer.h"
#include "obj.h"
#include "read/surface.h"

#define COORDINATE_BITS 28
#define FAR_AWAY (INT64_C(4096) << COORDINATE_BITS)
#define SMALL (INT64_C(1) << (COORDINATE_BITS - 1))
#define TINY (INT64_C(1) << (COORDINATE_BITS - 16))

/* Reads the next number with 28 fractional bits, rounded down. */
static int read_coordinate(struct tia_text *t, int64_t *out)
{
    int64_t wide;
    int status = tia_text_q32(t, &wide);

    *out = status ? 0 : wide >> (32 - COORDINATE_BITS);
    return status;
}

static void count_vertex(struct obj *o, const int64_t v[3])
{
    for (int i = 0; i < 3; i++) {
        o->min[i] = v[i] < o->min[i] ? v[i] : o->min[i];
        o->max[i] = v[i] > o->max[i] ? v[i] : o->max[i];
    }
}

/* Converts a vertex's coordinate to the scene's. |v - origin| is below 2^61; shifted, it is below 2^21. */
static tia_q16 move(const struct obj *o, int64_t v, int axis)
{
    int64_t from = v - o->origin[axis];
    return (tia_q16)(o->shift >= 0 ? tia_round_shift(from, (unsigned)o->shift)
                                   : (int64_t)((uint64_t)from << (unsigned)-o->shift));
}

int tia_obj_v(struct obj *o)
{
    struct tia_vec3 vertex = {0, 0, 0};
    int64_t v[3] = {0, 0, 0};
    int status = TIA_OK;

    if (o->pass != OBJ_COUNT && !o->moved) {
        status = tia_text_vec3(&o->text, &vertex);
    } else {
        for (int i = 0; !status && i < 3; i++)
            status = read_coordinate(&o->text, &v[i]);
        if (o->pass == OBJ_COUNT)
            count_vertex(o, v);
        else
            vertex = (struct tia_vec3){move(o, v[0], 0), move(o, v[1], 1), move(o, v[2], 2)};
    }
    for (int i = 0; !status && i < 4 && tia_text_has_number(&o->text); i++)
        status = read_coordinate(&o->text, &v[0]);
    tia_array_add(&o->vertices, &vertex);
    return status;
}

/* Refuses the whole file; the error has no line. */
static int refuse(struct obj *o, const char *why)
{
    tia_say(&o->reader->error, why);
    return TIA_ERR_RANGE;
}

int tia_obj_fit(struct obj *o)
{
    int64_t half = 0, farthest = 0;

    if (!o->face_count) {
        int status = refuse(o, "the model has no faces, expected some f");
        return o->vertices.count ? tia_obj_forgive(o, TIA_WARN_EMPTY) : status;
    }
    if (o->face_count > TIA_OBJECTS_MAX)
        return refuse(o, "the model has too many faces, expected at most 16777216");
    for (int i = 0; i < 3; i++) {
        int64_t size = (o->max[i] - o->min[i] + 1) / 2;
        half = size > half ? size : half;
        farthest = o->max[i] > farthest ? o->max[i] : farthest;
        farthest = -o->min[i] > farthest ? -o->min[i] : farthest;
        o->origin[i] = o->min[i] + size;
    }
    if (half < TINY)
        return refuse(o, "the model is too small, expected an extent of more than 1/32768");
    o->moved = half < SMALL || farthest > FAR_AWAY;
    /* `half` has 64 - clz bits, of which 20 are kept: 8..16 in Q16.16. */
    o->shift = 44 - (int)tia_clz64((uint64_t)half);
    return TIA_OK;
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

static void set_placement(const struct obj *o)
{
    struct tia_placement *placement = &o->reader->placement;

    for (int i = 0; i < 3 && o->moved; i++)
        placement->origin[i] = o->origin[i] * (INT64_C(1) << (32 - COORDINATE_BITS));
    placement->bits = o->moved ? COORDINATE_BITS - 16 - o->shift : 0;
}

int tia_obj_frame(struct obj *o, struct tia_light *lights)
{
    struct tia_scene *scene = o->scene;
    struct bounds b = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};

    for (uint32_t m = 0; m < scene->mesh_count; m++)
        for (uint32_t i = 0; i < 3 * scene->meshes[m].face_count; i++)
            extend(&b, &scene->meshes[m].vertices[scene->meshes[m].faces[i / 3].corner[i % 3].vertex]);
    /* without faces no object is visible, and any position will do */
    struct tia_vec3 c = scene->mesh_count ? middle(&b) : (struct tia_vec3){0, 0, 0};
    uint64_t radius = scene->mesh_count ? tia_sqrt64(farthest(scene, c)) + UINT64_C(1) : TIA_Q16_ONE;
    if (radius < TIA_RADIUS_MIN)
        return refuse(o, "all faces lie in one point, expected a model");
    scene->camera = tia_model_view(c, radius, lights);
    set_placement(o);
    tia_camera_alter(&scene->camera, o->reader->camera, &o->reader->placement);
    scene->background = tia_grey(TIA_Q30(0.8));
    scene->lights = lights;
    scene->light_count = TIA_MODEL_LIGHTS;
    return TIA_OK;
}
