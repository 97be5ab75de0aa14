/* face_planes.c - the flat faces of a scene's objects. */
#include "face_planes.h"

#include "flat/source.h"
#include "math/align.h"
#include "scene/bvh/tree.h"
#include "scene/cancel.h"

#define FACES_MOST (UINT32_C(1) << 28)
#define ITEM_COST 2 /* cost of testing a face, in visits to a node's children */

static uint32_t object_count(const struct tia_scene *scene)
{
    return scene->sphere_count + scene->shape_count;
}

static const struct tia_shape *shape_of(const struct tia_scene *scene, uint32_t object)
{
    return object < scene->sphere_count ? NULL : &scene->shapes[object - scene->sphere_count];
}

static bool is_whole_disc(const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *shape = shape_of(scene, object);

    return shape && shape->kind == TIA_DISC && shape->transform == 0;
}

bool tia_radio_takes(const struct tia_scene *scene, uint32_t object)
{
    return is_whole_disc(scene, object) || tia_flat_takes(scene, object);
}

static void count_object(const struct tia_scene *scene, uint32_t object, uint64_t *corners, uint64_t *faces)
{
    const struct tia_shape *shape = shape_of(scene, object);

    *corners = *faces = 0;
    if (is_whole_disc(scene, object) || (shape && shape->kind == TIA_PLANE))
        *corners = *faces = 1;
    else if (tia_flat_takes(scene, object))
        tia_flat_count(scene, object, corners, faces);
    if (shape && shape->kind == TIA_BOX)
        *faces = 6;
}

static void count_all(const struct tia_scene *scene, uint64_t *corners, uint64_t *faces)
{
    *corners = *faces = 0;
    for (uint32_t i = 0; i < object_count(scene); i++) {
        uint64_t c, f;
        count_object(scene, i, &c, &f);
        *corners += c;
        *faces += f;
    }
}

size_t tia_radio_size(const struct tia_scene *scene)
{
    uint64_t corners, faces;

    if (!scene)
        return SIZE_MAX;
    count_all(scene, &corners, &faces);
    if (faces > FACES_MOST || corners > UINT32_MAX)
        return SIZE_MAX;
    uint64_t size = ALIGN(sizeof(struct tia_radio)) + 8 + ALIGN(faces * sizeof(struct radio_plane)) +
                    ALIGN(faces * sizeof(struct radio_face)) + 2 * ALIGN(faces * sizeof(struct tia_bounds)) +
                    ALIGN(TREE_NODES(faces) * sizeof(struct tia_bvh_node)) + ALIGN(faces * 6 * sizeof(uint32_t)) +
                    ALIGN(corners * sizeof(struct tia_vec3));
    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

/* ---- one object ---- */

struct filling {
    struct tia_radio *radio;
    struct tia_fault *fault;
    uint32_t object, material;
};

static int refuse(const struct filling *f, const char *rule)
{
    *f->fault = (struct tia_fault){"object", f->object, "corner", rule};
    return TIA_ERR_RANGE;
}

static int add_corner(struct filling *f, const int64_t world[3])
{
    int32_t at[3];

    for (int k = 0; k < 3; k++) {
        int64_t rounded = (world[k] + 32768) >> 16;
        if (rounded < -INT32_MAX || rounded > INT32_MAX)
            return refuse(f, "must be within 32768 of the origin");
        at[k] = (int32_t)rounded;
    }
    f->radio->corners[f->radio->corner_count++] = (struct tia_vec3){at[0], at[1], at[2]};
    return TIA_OK;
}

static void set_box(const struct tia_radio *radio, uint32_t number)
{
    const struct radio_face *face = &radio->faces[number];
    struct tia_bounds *box = &radio->boxes[number];
    int64_t low[3], high[3];

    for (int k = 0; k < 3; k++) {
        low[k] = high[k] = radio_axis(&radio->corners[face->corner[0]], k);
        for (unsigned i = 1; i < face->count; i++) {
            int64_t at = radio_axis(&radio->corners[face->corner[i]], k);
            low[k] = at < low[k] ? at : low[k];
            high[k] = at > high[k] ? at : high[k];
        }
        low[k] -= low[k] - face->radius > INT32_MIN ? face->radius : 0;
        high[k] += high[k] + face->radius < INT32_MAX ? face->radius : 0;
    }
    *box = (struct tia_bounds){{(tia_q16)low[0], (tia_q16)low[1], (tia_q16)low[2]},
                               {(tia_q16)high[0], (tia_q16)high[1], (tia_q16)high[2]}};
}

/* Adds a face. Its plane must be stored already, at the same index. */
static void add_face(struct filling *f, const struct radio_face *face)
{
    struct tia_radio *radio = f->radio;

    radio->faces[radio->face_count] = *face;
    radio->faces[radio->face_count].object = f->object;
    radio->faces[radio->face_count].material = f->material;
    set_box(radio, radio->face_count);
    radio->face_count++;
}

static int add_polygon(struct filling *f, uint32_t base, const uint32_t *corner, unsigned count, bool solid)
{
    struct tia_radio *radio = f->radio;
    struct radio_face face = {.kind = RADIO_POLYGON, .count = (uint8_t)count, .solid = solid};
    struct tia_vec3 at[3];
    bool too_wide;

    for (unsigned i = 0; i < count; i++)
        face.corner[i] = base + corner[i];
    for (unsigned i = 0; i < 3; i++)
        at[i] = radio->corners[face.corner[i]];
    if (tia_radio_plane_by_corners(&radio->planes[radio->face_count], at, &face.turned, &too_wide))
        add_face(f, &face);
    else if (too_wide)
        return refuse(f, "must be less than 32768 from the next one, on faces that are not perpendicular to an axis");
    return TIA_OK;
}

/* Adds a box. The four rounded corners of a side need not lie in one plane: the first three define the plane. A side's
 * thickness is the length of the edges perpendicular to it: their length in the box's own axes, times the scale. */
static int add_box(struct filling *f, uint32_t base)
{
    static const uint32_t sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const struct tia_scene *scene = f->radio->scene;
    const struct tia_shape *shape = shape_of(scene, f->object);
    const struct tia_box *box = &shape->box;
    int status = TIA_OK;

    for (int i = 0; i < 6 && !status; i++) {
        uint32_t before = f->radio->face_count;
        int64_t edge = radio_axis(&box->max, i / 2) - radio_axis(&box->min, i / 2);
        if (shape->transform)
            edge = (edge * radio_axis(&scene->transforms[shape->transform - 1].scale, i / 2) + 32768) >> 16;
        status = add_polygon(f, base, sides[i], 4, true);
        if (f->radio->face_count > before)
            f->radio->faces[before].thickness = (tia_q16)(edge < INT32_MAX ? edge : INT32_MAX);
    }
    return status;
}

static void add_round(struct filling *f, enum radio_kind kind, struct tia_vec3 point, struct tia_dir3 normal,
                      tia_q16 radius)
{
    struct tia_radio *radio = f->radio;
    struct radio_face face = {.kind = kind, .corner = {radio->corner_count}, .count = 1, .radius = radius};

    radio->corners[radio->corner_count++] = point;
    tia_radio_plane_by_normal(&radio->planes[radio->face_count], point, normal, &face.turned);
    add_face(f, &face);
}

static int add_source(struct filling *f)
{
    struct tia_flat_source source;
    uint32_t base = f->radio->corner_count;
    int status = TIA_OK;

    tia_flat_source_init(&source, f->radio->scene, f->object);
    for (uint32_t i = 0; i < source.points && !status; i++) {
        int64_t world[3];
        tia_flat_source_point(&source, i, world);
        status = add_corner(f, world);
    }
    if (!status && source.kind == TIA_BOX)
        return add_box(f, base);
    for (uint32_t i = 0; i < source.faces && !status; i++) {
        struct tia_flat_face face = tia_flat_source_face(&source, i);
        status = add_polygon(f, base, face.corner, face.corner[3] == TIA_NO_CORNER ? 3 : 4, false);
    }
    return status;
}

static int add_object(struct filling *f)
{
    const struct tia_scene *scene = f->radio->scene;
    const struct tia_shape *shape = shape_of(scene, f->object);

    f->material = shape ? shape->material : scene->spheres[f->object].material;
    if (!tia_radio_takes(scene, f->object))
        f->radio->left_out++;
    else if (is_whole_disc(scene, f->object))
        add_round(f, RADIO_DISC, shape->disc.centre, shape->disc.normal, shape->disc.radius);
    else if (shape && shape->kind == TIA_PLANE)
        add_round(f, RADIO_WHOLE, shape->plane.point, shape->plane.normal, 0);
    else
        return add_source(f);
    return TIA_OK;
}

/* ---- all objects ---- */

/* Builds the tree. `boxes` is working storage for the boxes of the items, which are reordered together with the
 * items. */
static void build_tree(struct tia_radio *radio, struct tia_bvh_node *nodes, uint32_t *items, struct tia_bounds *boxes)
{
    struct cancel cancel = {.stop = NULL};
    uint32_t count = 0;

    for (uint32_t f = 0; f < radio->face_count; f++)
        if (radio->faces[f].kind == RADIO_WHOLE)
            radio->endless[radio->endless_count++] = f;
        else {
            boxes[count] = radio->boxes[f];
            items[count++] = f;
        }
    const struct bvh_items all = {items, boxes, ITEM_COST, 1};
    uint32_t used = tia_bvh_build_range(nodes, &all, (struct bvh_range){0, count, 0}, &cancel);
    radio->tree = (struct tia_bvh_tree){nodes, items, used, count};
}

static void *take(unsigned char **at, uint64_t size)
{
    void *place = *at;

    *at += ALIGN(size);
    return place;
}

int tia_radio_init(struct tia_radio **out, void *memory, size_t size, const struct tia_scene *scene,
                   struct tia_fault *fault)
{
    struct tia_radio *radio = memory;
    unsigned char *at = memory;
    uint64_t corners, faces;
    struct tia_fault unused;
    int status = TIA_OK;

    if (!out || !scene || !memory_is_usable(memory))
        return TIA_ERR_ARGUMENT;
    if (size < tia_radio_size(scene))
        return TIA_ERR_MEMORY;
    count_all(scene, &corners, &faces);
    (void)take(&at, sizeof *radio);
    *radio = (struct tia_radio){.scene = scene};
    radio->planes = take(&at, faces * sizeof *radio->planes);
    radio->faces = take(&at, faces * sizeof *radio->faces);
    radio->boxes = take(&at, faces * sizeof *radio->boxes);
    struct tia_bounds *boxes = take(&at, faces * sizeof *boxes);
    struct tia_bvh_node *nodes = take(&at, TREE_NODES(faces) * sizeof *nodes);
    radio->corners = take(&at, corners * sizeof *radio->corners);
    radio->members = take(&at, faces * 6 * sizeof *radio->members);
    radio->endless = radio->members + faces;
    for (uint32_t i = 0; i < object_count(scene) && !status; i++)
        status = add_object(&(struct filling){.radio = radio, .fault = fault ? fault : &unused, .object = i});
    if (status)
        return status;
    uint32_t *room = radio->endless + faces;
    tia_radio_join_planes(radio, room);
    build_tree(radio, nodes, room, boxes);
    *out = radio;
    return TIA_OK;
}

struct tia_radio_counts tia_radio_count(const struct tia_radio *radio)
{
    if (!radio)
        return (struct tia_radio_counts){0, 0, 0};
    return (struct tia_radio_counts){radio->face_count, radio->plane_count, radio->left_out};
}

struct tia_radio_face tia_radio_face(const struct tia_radio *radio, uint32_t face)
{
    if (!radio || face >= radio->face_count)
        return (struct tia_radio_face){.object = TIA_RADIO_NO_OBJECT};
    const struct radio_face *f = &radio->faces[face];
    struct tia_radio_face out = {f->object, f->material, f->plane, f->solid, {0, 0, 0}, f->thickness};

    (void)wide_normalise(radio->planes[f->plane].n, out.normal);
    for (int k = 0; k < 3; k++)
        out.normal[k] = f->turned ? -out.normal[k] : out.normal[k];
    return out;
}
