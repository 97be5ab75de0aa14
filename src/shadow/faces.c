#include "faces.h"

#include "math/align.h"
#include "math/wide.h"
#include "scene/hull.h"

/* ---- a shape's points and faces, in its own axes ---- */

static const struct tia_mesh *mesh_of(const struct tia_scene *scene, const struct tia_shape *shape)
{
    return &scene->meshes[shape->mesh];
}

static uint32_t count_points(const struct tia_scene *scene, const struct tia_shape *shape)
{
    switch (shape->kind) {
    case TIA_PLANE:
        return TIA_PLANE_POINTS;
    case TIA_BOX:
        return 8;
    case TIA_TRIANGLE:
        return 3;
    default:
        return mesh_of(scene, shape)->vertex_count;
    }
}

static uint32_t count_faces(const struct tia_scene *scene, const struct tia_shape *shape)
{
    switch (shape->kind) {
    case TIA_PLANE:
        return TIA_PLANE_FACES;
    case TIA_BOX:
        return 12;
    case TIA_TRIANGLE:
        return 1;
    default:
        return mesh_of(scene, shape)->face_count;
    }
}

/* Of a plane only point 0 is one, the others are directions. */
static struct tia_vec3 point_of(const struct tia_scene *scene, const struct tia_shape *shape, uint32_t i)
{
    const struct tia_box *box = &shape->box;

    switch (shape->kind) {
    case TIA_PLANE:
        return shape->plane.point;
    case TIA_BOX:
        return (struct tia_vec3){i & 1 ? box->max.x : box->min.x, i & 2 ? box->max.y : box->min.y,
                                 i & 4 ? box->max.z : box->min.z};
    case TIA_TRIANGLE:
        return shape->triangle.corner[i];
    default:
        return mesh_of(scene, shape)->vertices[i];
    }
}

/* Its corners, as numbers of the shape's points. Rounded, four corners need not lie in one plane, so a box has
 * triangles; those of a plane are exact opposites. */
static struct tia_flat_face face_of(const struct tia_scene *scene, const struct tia_shape *shape, uint32_t i)
{
    static const struct tia_flat_face plane[TIA_PLANE_FACES] = {{{0, 1, 2, 3}}, {{0, 3, 4, 1}}};
    static const uint8_t box[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const uint8_t *q = box[i / 2 % 6];

    if (shape->kind == TIA_PLANE)
        return plane[i];
    if (shape->kind == TIA_BOX)
        return (struct tia_flat_face){{q[0], q[i % 2 ? 2 : 1], q[i % 2 ? 3 : 2], TIA_NO_CORNER}};
    if (shape->kind == TIA_TRIANGLE)
        return (struct tia_flat_face){{0, 1, 2, TIA_NO_CORNER}};
    const struct tia_corner *c = mesh_of(scene, shape)->faces[i].corner;
    return (struct tia_flat_face){{c[0].vertex, c[1].vertex, c[2].vertex, TIA_NO_CORNER}};
}

/* ---- how many there are ---- */

struct counts {
    uint64_t points, faces;
    uint32_t most; /* points of one object */
};

static struct counts count(const struct tia_scene *scene)
{
    struct counts all = {0, 0, 0};

    for (uint32_t i = 0; i < scene->shape_count; i++) {
        uint32_t points = count_points(scene, &scene->shapes[i]);
        all.points += points;
        all.faces += count_faces(scene, &scene->shapes[i]);
        all.most = points > all.most ? points : all.most;
    }
    return all;
}

/* What is needed only while the faces are found: the first point at each place and room for that, then room for the
 * edges. */
static uint64_t room_size(struct counts n)
{
    uint64_t weld = n.most * (uint64_t)sizeof(uint32_t) + tia_weld_room(n.most),
             edges = tia_edges_room((uint32_t)n.faces);

    return weld > edges ? weld : edges;
}

uint64_t tia_flat_face_count(const struct tia_scene *scene)
{
    return count(scene).faces;
}

size_t tia_flat_size(const struct tia_scene *scene)
{
    struct counts n = count(scene);

    if (n.faces > UINT32_C(1) << 28 || n.points > UINT32_MAX)
        return SIZE_MAX;
    uint64_t size = ALIGN((uint64_t)scene->shape_count * sizeof(struct tia_flat_object)) +
                    ALIGN(n.faces * sizeof(struct tia_flat_face)) + ALIGN(n.faces * TIA_SIDES * sizeof(uint32_t)) +
                    ALIGN(n.faces * sizeof(struct tia_raster_plane)) +
                    ALIGN(n.points * sizeof(struct tia_raster_vertex)) + ALIGN(room_size(n));
    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

/* ---- points ---- */

static const struct tia_transform *transform_of(const struct tia_scene *scene, const struct tia_shape *shape)
{
    return shape->transform ? &scene->transforms[shape->transform - 1] : NULL;
}

static void in_world(const struct frame *frame, struct tia_vec3 p, int64_t world[3])
{
    for (int k = 0; k < 3; k++)
        world[k] = tia_frame_place(frame, k, p);
}

static unsigned range_of(const struct tia_scene *scene, const struct tia_eye *eye, struct asker *asker)
{
    unsigned most = 0;

    for (uint32_t s = 0; s < scene->shape_count; s++) {
        const struct tia_shape *shape = &scene->shapes[s];
        uint32_t points = shape->kind == TIA_PLANE ? 1 : count_points(scene, shape);
        struct frame frame;

        tia_frame_prepare(&frame, transform_of(scene, shape));
        for (uint32_t i = 0; i < points && !asker_stops(asker, 1); i++) {
            int64_t world[3];
            in_world(&frame, point_of(scene, shape, i), world);
            unsigned range = tia_eye_range(eye, world);
            most = range > most ? range : most;
        }
    }
    return most;
}

/* The corners of a rectangle, or the same point four times. */
static unsigned range_of_light(const struct tia_eye *eye, const struct tia_light *light)
{
    bool extends = light->kind == TIA_RECTANGLE_LIGHT;
    unsigned most = 0;

    for (int i = 0; i < 4; i++) {
        struct tia_vec3 a = light->side[0], b = light->side[1];
        int64_t s = extends ? i % 2 * 2 - 1 : 0, t = extends ? i / 2 * 2 - 1 : 0;
        const int64_t at[3] = {(light->centre.x + s * a.x + t * b.x) * 65536,
                               (light->centre.y + s * a.y + t * b.y) * 65536,
                               (light->centre.z + s * a.z + t * b.z) * 65536};
        unsigned range = tia_eye_range(eye, at);
        most = range > most ? range : most;
    }
    return most;
}

/* In orthographic views there is no room for lights beyond what the faces need, so they are counted as well, and may
 * move by keys to four times that. Of those that are far away the nearest matter: the others become directions. */
static unsigned range_with_lights(const struct tia_scene *scene, const struct tia_eye *eye, unsigned faces)
{
    unsigned most = faces;

    for (uint32_t i = 0; i < scene->light_count + scene->binding_count; i++) {
        const struct tia_light *light =
            i < scene->light_count ? &scene->lights[i] : &scene->bindings[i - scene->light_count].state;
        if (light->kind == TIA_AMBIENT_LIGHT || light->kind == TIA_DIRECTIONAL_LIGHT)
            continue;
        unsigned range = range_of_light(eye, light) + 2;
        range = range > faces + TIA_FLAT_LIGHT_BITS ? faces + TIA_FLAT_LIGHT_BITS : range;
        most = range > most ? range : most;
    }
    return most < 20 ? most : 20;
}

static struct tia_raster_vertex opposite(struct tia_raster_vertex v)
{
    return (struct tia_raster_vertex){-v.x, -v.y, -v.w, -v.h};
}

/* Four directions of the plane, at right angles. */
static void add_directions(const struct tia_flat_scene *flat, const struct tia_dir3 *normal,
                           struct tia_raster_vertex *to)
{
    const int64_t given[3] = {normal->x, normal->y, normal->z};
    int64_t n[3], across[3], along[3];
    int least = 0;

    (void)wide_normalise(given, n);
    for (int k = 1; k < 3; k++)
        if ((n[k] < 0 ? -n[k] : n[k]) < (n[least] < 0 ? -n[least] : n[least]))
            least = k;
    const int64_t e[3] = {least == 0 ? INT64_C(1) << 61 : 0, least == 1 ? INT64_C(1) << 61 : 0,
                          least == 2 ? INT64_C(1) << 61 : 0};
    tia_eye_cross(e, n, along);
    (void)wide_normalise(along, across);
    tia_eye_cross(n, across, along);
    tia_eye_direction(&flat->eye, across, flat->bits, &to[0]);
    tia_eye_direction(&flat->eye, along, flat->bits, &to[1]);
    to[2] = opposite(to[0]);
    to[3] = opposite(to[1]);
}

static void add_points(struct tia_flat_scene *flat, const struct tia_scene *scene, const struct tia_shape *shape,
                       struct asker *asker)
{
    struct tia_raster_vertex *to = &flat->points[flat->point_count];
    uint32_t points = shape->kind == TIA_PLANE ? 1 : count_points(scene, shape);
    struct frame frame;

    tia_frame_prepare(&frame, transform_of(scene, shape));
    for (uint32_t i = 0; i < points && !asker_stops(asker, 1); i++) {
        int64_t world[3];
        in_world(&frame, point_of(scene, shape, i), world);
        tia_eye_point(&flat->eye, world, flat->lattice.fraction, &to[i]);
    }
    if (shape->kind == TIA_PLANE)
        add_directions(flat, &shape->plane.normal, to + 1);
}

/* ---- faces ---- */

static void add_faces(struct tia_flat_scene *flat, const struct tia_scene *scene, const struct tia_shape *shape,
                      uint32_t *room)
{
    uint32_t points = count_points(scene, shape), faces = count_faces(scene, shape);
    bool weld = shape->kind == TIA_MESH;

    if (weld)
        tia_weld(room, mesh_of(scene, shape)->vertices, points, room + points);
    for (uint32_t i = 0; i < faces; i++) {
        struct tia_flat_face face = face_of(scene, shape, i), *to = &flat->faces[flat->face_count + i];
        for (int k = 0; k < TIA_SIDES; k++)
            to->corner[k] = face.corner[k] == TIA_NO_CORNER
                                ? TIA_NO_CORNER
                                : flat->point_count + (weld ? room[face.corner[k]] : face.corner[k]);
    }
}

bool tia_flat_is_direction(const struct tia_flat_scene *flat, const struct tia_raster_vertex *v)
{
    return flat->eye.projection == TIA_ORTHOGRAPHIC ? v->w == 0 : v->h == 0;
}

void tia_flat_affine(const struct tia_flat_scene *flat, const struct tia_raster_vertex *v, int64_t out[3])
{
    out[0] = v->x;
    out[1] = v->y;
    out[2] = flat->eye.projection == TIA_ORTHOGRAPHIC ? v->h : v->w;
}

static void find_box(const struct tia_flat_scene *flat, struct tia_flat_object *object, uint32_t first, uint32_t end)
{
    for (int k = 0; k < 3; k++) {
        object->low[k] = INT64_MAX;
        object->high[k] = INT64_MIN;
    }
    for (uint32_t i = first; i < end; i++) {
        int64_t p[3];
        tia_flat_affine(flat, &flat->points[i], p);
        for (int k = 0; k < 3; k++) {
            object->low[k] = p[k] < object->low[k] ? p[k] : object->low[k];
            object->high[k] = p[k] > object->high[k] ? p[k] : object->high[k];
        }
    }
}

static void add_object(struct tia_flat_scene *flat, const struct tia_scene *scene, uint32_t i, uint32_t *room,
                       struct asker *asker)
{
    const struct tia_shape *shape = &scene->shapes[i];
    uint32_t faces = count_faces(scene, shape);

    uint32_t points = count_points(scene, shape);
    struct tia_flat_object *object = &flat->objects[flat->object_count++];

    *object =
        (struct tia_flat_object){.kind = shape->kind, .object = i, .first_face = flat->face_count, .face_count = faces};
    add_points(flat, scene, shape, asker);
    add_faces(flat, scene, shape, room);
    find_box(flat, object, flat->point_count, flat->point_count + points);
    flat->point_count += points;
    flat->face_count += faces;
}

static bool closes(const struct tia_flat_scene *flat, const struct tia_flat_object *object)
{
    for (uint32_t f = object->first_face; f < object->first_face + object->face_count; f++)
        for (unsigned k = 0; k < tia_face_sides(&flat->faces[f]); k++)
            if (flat->across[TIA_SIDES * f + k] == TIA_NO_EDGE)
                return false;
    return true;
}

unsigned tia_flat_corners(const struct tia_flat_scene *flat, uint32_t face, struct tia_raster_vertex corners[TIA_SIDES])
{
    const struct tia_flat_face *f = &flat->faces[face];
    unsigned sides = tia_face_sides(f);

    for (unsigned k = 0; k < sides; k++)
        corners[k] = flat->points[f->corner[k]];
    return sides;
}

static int make_plane(struct tia_flat_scene *flat, uint32_t face)
{
    struct tia_raster_vertex corners[TIA_SIDES];
    unsigned sides = tia_flat_corners(flat, face, corners);

    return tia_raster_plane_init(&flat->planes[face], &flat->lattice, corners, sides);
}

static char *take(char **memory, size_t size)
{
    char *at = *memory;

    *memory += ALIGN(size);
    return at;
}

int tia_flat_init(struct tia_flat_scene *flat, void *memory, size_t size, const struct tia_scene *scene, unsigned width,
                  unsigned height, struct asker *asker)
{
    struct counts n = count(scene);
    char *next = memory;
    void *room;

    if (size < tia_flat_size(scene))
        return TIA_ERR_MEMORY;
    *flat = (struct tia_flat_scene){.object_count = 0};
    flat->objects = (void *)take(&next, (size_t)scene->shape_count * sizeof *flat->objects);
    flat->faces = (void *)take(&next, (size_t)n.faces * sizeof *flat->faces);
    flat->across = (void *)take(&next, (size_t)n.faces * TIA_SIDES * sizeof *flat->across);
    flat->planes = (void *)take(&next, (size_t)n.faces * sizeof *flat->planes);
    flat->points = (void *)take(&next, (size_t)n.points * sizeof *flat->points);
    room = next;
    tia_eye_init(&flat->eye, scene, width, height);
    unsigned range = range_of(scene, &flat->eye, asker);
    if (range > 20)
        return TIA_ERR_RANGE;
    if (scene->camera.projection == TIA_ORTHOGRAPHIC)
        range = range_with_lights(scene, &flat->eye, range);
    int status = tia_lattice_init(&flat->lattice, scene->camera.projection, width, height, 1, 0, range);
    flat->bits = flat->lattice.fraction + (int)range;
    for (uint32_t i = 0; !status && i < scene->shape_count && !asker_stops(asker, 1); i++)
        add_object(flat, scene, i, room, asker);
    if (!asker_stops(asker, 0))
        (void)tia_edges_join(flat->across, flat->faces, flat->face_count, room, asker);
    for (uint32_t i = 0; i < flat->object_count && !asker_stops(asker, 1); i++)
        flat->objects[i].closed = closes(flat, &flat->objects[i]);
    for (uint32_t f = 0; !status && f < flat->face_count && !asker_stops(asker, 1); f++)
        status = make_plane(flat, f);
    return asker->stopped ? TIA_STOPPED : status;
}

const struct tia_flat_object *tia_flat_object_of(const struct tia_flat_scene *flat, uint32_t face)
{
    uint32_t low = 0, high = flat->object_count;

    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (flat->objects[middle].first_face <= face)
            low = middle;
        else
            high = middle;
    }
    return &flat->objects[low];
}

uint32_t tia_flat_element_of(const struct tia_flat_scene *flat, uint32_t face)
{
    const struct tia_flat_object *object = tia_flat_object_of(flat, face);
    uint32_t n = face - object->first_face;

    return object->kind == TIA_MESH ? n : object->kind == TIA_BOX ? n / 2 : 0;
}
