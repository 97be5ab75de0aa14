#include "faces.h"

#include "math/align.h"
#include "math/wide.h"
#include "raster/polygon.h"
#include "raster/target.h"

/* ---- counting ---- */

struct counts {
    uint64_t points, faces, most; /* most: largest number of points of one object */
    uint32_t objects;
};

static uint32_t objects_of(const struct tia_scene *scene)
{
    return scene->sphere_count + scene->shape_count;
}

static struct counts count(const struct tia_scene *scene)
{
    struct counts all = {0, 0, 0, 0};

    for (uint32_t i = 0; i < objects_of(scene); i++) {
        uint64_t points, faces;
        if (!tia_flat_takes(scene, i))
            continue;
        tia_flat_count(scene, i, &points, &faces);
        all.points += points;
        all.faces += faces;
        all.objects++;
        all.most = points > all.most ? points : all.most;
    }
    return all;
}

/* Returns the number of bytes of working memory, needed only until the edges across are found: the larger of the memory
 * of tia_edges_join, and that of tia_weld with its result. */
static uint64_t room_size(struct counts n)
{
    uint64_t weld = n.most * sizeof(uint32_t) + tia_weld_room((uint32_t)n.most),
             edges = tia_edges_room((uint32_t)n.faces);

    return weld > edges ? weld : edges;
}

uint64_t tia_flat_face_count(const struct tia_scene *scene)
{
    return count(scene).faces;
}

unsigned tia_flat_samples(const struct tia_scene *scene)
{
    uint32_t samples = scene->camera.samples; /* the scene may not be checked yet */

    return samples > TIA_SAMPLES_MAX ? TIA_SAMPLES_MAX : samples ? (unsigned)samples : 1;
}

size_t tia_flat_size(const struct tia_scene *scene)
{
    struct counts n = count(scene);

    if (n.faces > UINT32_C(1) << 28 || n.points > UINT32_MAX)
        return SIZE_MAX;
    uint64_t size = ALIGN((uint64_t)n.objects * sizeof(struct tia_flat_object)) +
                    ALIGN(n.faces * sizeof(struct tia_flat_face)) + ALIGN(n.faces * TIA_SIDES * sizeof(uint32_t)) +
                    ALIGN(n.faces * tia_flat_samples(scene) * sizeof(struct tia_raster_plane)) +
                    ALIGN(n.points * sizeof(struct tia_raster_vertex)) + ALIGN(n.faces * sizeof(struct tia_flat_rows)) +
                    ALIGN(room_size(n));
    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

/* ---- points ---- */

static struct tia_raster_vertex opposite(struct tia_raster_vertex v)
{
    return (struct tia_raster_vertex){-v.x, -v.y, -v.w, -v.h};
}

/* Adds four directions in a plane: two at right angles to each other, and their opposites. */
static void add_directions(const struct tia_flat_scene *flat, const struct tia_dir3 *normal,
                           struct tia_raster_vertex *to)
{
    const int64_t given[3] = {normal->x, normal->y, normal->z};
    int64_t n[3], across[2][3];

    (void)wide_normalise(given, n);
    tia_eye_across(n, across);
    for (int i = 0; i < 2; i++) {
        tia_eye_direction(&flat->eye, across[i], flat->bits, &to[i]);
        to[2 + i] = opposite(to[i]);
    }
}

static void add_points(struct tia_flat_scene *flat, const struct tia_flat_source *source, struct cancel *cancel)
{
    struct tia_raster_vertex *to = &flat->points[flat->point_count];

    for (uint32_t i = 0; i < tia_flat_places(source) && !cancelled(cancel, 1); i++) {
        int64_t world[3];
        tia_flat_source_point(source, i, world);
        tia_eye_point(&flat->eye, world, flat->grid.fraction, &to[i]);
    }
    if (source->kind == TIA_PLANE)
        add_directions(flat, &source->shape->plane.normal, to + 1);
}

/* ---- faces ---- */

static void add_faces(struct tia_flat_scene *flat, const struct tia_flat_source *source, uint32_t *room)
{
    bool weld = source->kind == TIA_MESH;

    if (weld)
        tia_weld(room, source->scene->meshes[source->shape->mesh].vertices, source->points, room + source->points);
    for (uint32_t i = 0; i < source->faces; i++) {
        struct tia_flat_face face = tia_flat_source_face(source, i), *to = &flat->faces[flat->face_count + i];
        for (int k = 0; k < TIA_SIDES; k++)
            to->corner[k] = face.corner[k] == TIA_NO_CORNER
                                ? TIA_NO_CORNER
                                : flat->point_count + (weld ? room[face.corner[k]] : face.corner[k]);
    }
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

static void add_object(struct tia_flat_scene *flat, const struct tia_scene *scene, uint32_t i, uint32_t *room)
{
    struct tia_flat_object *object = &flat->objects[flat->object_count++];
    struct tia_flat_source source;

    tia_flat_source_init(&source, scene, i);
    *object = (struct tia_flat_object){.kind = source.kind,
                                       .object = i,
                                       .first_face = flat->face_count,
                                       .face_count = source.faces,
                                       .parts = {source.parts[0], source.parts[1]},
                                       .divided = source.divided};
    add_faces(flat, &source, room);
    flat->point_count += source.points;
    flat->face_count += source.faces;
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

/* Adds the rows that a face may cover. */
static void add_rows(struct tia_flat_rows *rows, const struct tia_raster_grid *grid,
                     const struct tia_raster_vertex *corners, unsigned sides)
{
    const struct tia_tile all = {0, 0, grid->width, grid->height};
    struct polygon p;

    if (!tia_polygon_box(&p, grid, all, corners, sides, 0))
        return;
    uint16_t first = (uint16_t)p.y0, end = (uint16_t)p.y1;
    rows->first = first < rows->first ? first : rows->first;
    rows->end = end > rows->end ? end : rows->end;
}

static int make_plane(struct tia_flat_scene *flat, uint32_t face)
{
    struct tia_raster_vertex corners[TIA_SIDES];
    unsigned sides = tia_flat_corners(flat, face, corners);

    add_rows(&flat->rows[face], &flat->grid, corners, sides);
    return tia_raster_plane_init(&flat->planes[face], &flat->grid, corners, sides);
}

static int make_planes(struct tia_flat_scene *flat, const struct tia_scene *scene, struct cancel *cancel)
{
    struct tia_flat_scene sampled;
    int status = TIA_OK;

    for (uint32_t f = 0; f < flat->face_count; f++)
        flat->rows[f] = (struct tia_flat_rows){UINT16_MAX, 0};
    for (unsigned i = 0; i < tia_flat_samples(scene); i++) {
        tia_flat_sample(&sampled, flat, scene, i);
        for (uint32_t f = 0; !status && f < flat->face_count && !cancelled(cancel, 1); f++)
            status = make_plane(&sampled, f);
    }
    return status;
}

void tia_flat_sample(struct tia_flat_scene *out, const struct tia_flat_scene *flat, const struct tia_scene *scene,
                     unsigned sample)
{
    const struct tia_raster_grid *l = &flat->grid;
    unsigned range = tia_flat_range(flat);

    *out = *flat;
    (void)tia_raster_grid_init(&out->grid, l->projection, l->width, l->height, tia_flat_samples(scene), sample, range);
    out->planes = flat->planes + (size_t)flat->face_count * sample;
}

static char *take(char **memory, size_t size)
{
    char *at = *memory;

    *memory += ALIGN(size);
    return at;
}

/* ---- vertices ---- */

struct tia_reach tia_flat_reach(const struct tia_flat_scene *flat)
{
    return (struct tia_reach){&flat->eye, flat->grid.width, flat->grid.height, flat->samples, flat->reach};
}

unsigned tia_flat_range(const struct tia_flat_scene *flat)
{
    return (unsigned)(flat->bits - flat->grid.fraction);
}

/* Sets the points of all objects, and the boxes around them. */
static void place_points(struct tia_flat_scene *flat, const struct tia_scene *scene, struct cancel *cancel)
{
    flat->point_count = 0;
    for (uint32_t i = 0; i < flat->object_count && !cancelled(cancel, 1); i++) {
        struct tia_flat_source source;
        tia_flat_source_init(&source, scene, flat->objects[i].object);
        add_points(flat, &source, cancel);
        find_box(flat, &flat->objects[i], flat->point_count, flat->point_count + source.points);
        flat->point_count += source.points;
    }
}

int tia_flat_place(struct tia_flat_scene *flat, const struct tia_scene *scene, unsigned range, struct cancel *cancel)
{
    const struct tia_raster_grid now = flat->grid;
    int status =
        tia_raster_grid_init(&flat->grid, scene->camera.projection, now.width, now.height, flat->samples, 0, range);

    flat->bits = flat->grid.fraction + (int)range;
    if (!status)
        place_points(flat, scene, cancel);
    status = status ? status : make_planes(flat, scene, cancel);
    return cancel->stopped ? TIA_STOPPED : status;
}

int tia_flat_init(struct tia_flat_scene *flat, void *memory, size_t size, const struct tia_scene *scene, unsigned width,
                  unsigned height, struct cancel *cancel)
{
    struct counts n = count(scene);
    char *next = memory;
    void *room;

    if (size < tia_flat_size(scene))
        return TIA_ERR_MEMORY;
    *flat = (struct tia_flat_scene){.object_count = 0};
    flat->objects = (void *)take(&next, (size_t)n.objects * sizeof *flat->objects);
    flat->faces = (void *)take(&next, (size_t)n.faces * sizeof *flat->faces);
    flat->across = (void *)take(&next, (size_t)n.faces * TIA_SIDES * sizeof *flat->across);
    flat->planes = (void *)take(&next, (size_t)n.faces * tia_flat_samples(scene) * sizeof *flat->planes);
    flat->points = (void *)take(&next, (size_t)n.points * sizeof *flat->points);
    flat->rows = (void *)take(&next, (size_t)n.faces * sizeof *flat->rows);
    room = next;
    tia_eye_init(&flat->eye, scene, width, height);
    flat->reach = tia_reach_of_faces(scene, &flat->eye, cancel);
    if (cancel->stopped)
        return TIA_STOPPED;
    flat->samples = tia_flat_samples(scene);
    flat->grid.width = (uint16_t)width;
    flat->grid.height = (uint16_t)height;
    struct tia_reach reach = tia_flat_reach(flat);
    if (flat->reach > tia_reach_most(flat->eye.projection) ||
        tia_reach_too_far(&reach, scene->lights, scene->light_count) < scene->light_count)
        return TIA_ERR_RANGE;
    for (uint32_t i = 0; i < objects_of(scene) && !cancelled(cancel, 1); i++)
        if (tia_flat_takes(scene, i))
            add_object(flat, scene, i, room);
    if (!cancelled(cancel, 0))
        (void)tia_edges_join(flat->across, flat->faces, flat->face_count, room, cancel);
    for (uint32_t i = 0; i < flat->object_count && !cancelled(cancel, 1); i++)
        flat->objects[i].closed = closes(flat, &flat->objects[i]);
    return tia_flat_place(flat, scene, tia_reach_with_lights(&reach, scene, scene->lights, scene->light_count), cancel);
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

    if (object->kind == TIA_MESH || object->kind == TIA_BOX)
        return object->kind == TIA_MESH ? n : n / 2;
    return n < object->parts[0] ? 0 : n - object->parts[0] < object->parts[1] ? 1 : 2;
}
