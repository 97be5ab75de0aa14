/* faces.h - a scene as flat faces in front of the camera, for the rasteriser. */
#ifndef TIA_FLAT_FACES_H
#define TIA_FLAT_FACES_H

#include "reach.h"
#include "source.h"

/* An object. Its faces first_face .. first_face + face_count - 1 are in the order of its parts, see path_hash in
 * debug.h; each part of a box has two faces. */
struct tia_flat_object {
    enum tia_shape_kind kind;
    uint32_t object;
    uint32_t first_face, face_count;
    uint32_t parts[2];       /* number of faces of parts 0 and 1; not for boxes and meshes */
    bool divided;            /* the faces approximate a curved surface */
    bool closed;             /* each edge has a face on either side, so a silhouette may suffice for the shadow */
    int64_t low[3], high[3]; /* box around the points of a closed object, in the coordinates of tia_flat_affine */
};

/* Rows of pixels: those from `first` to `end` - 1. */
struct tia_flat_rows {
    uint16_t first, end;
};

struct tia_flat_scene {
    struct tia_eye eye;
    struct tia_raster_grid grid;
    unsigned reach;   /* reach of the faces, see reach.h */
    uint32_t samples; /* number of samples of a pixel */
    int bits;         /* coordinates of points are below 2^bits */
    struct tia_flat_object *objects;
    struct tia_flat_face *faces;
    uint32_t *across; /* see tia_edges_join */
    struct tia_raster_vertex *points;
    /* planes of all faces for the grid of the first sample, followed by those for each further sample */
    struct tia_raster_plane *planes;
    struct tia_flat_rows *rows; /* of each face: no other rows are covered, for any sample */
    uint32_t object_count, face_count, point_count;
};

/* True if a vertex is at infinity, as a direction. */
static inline bool tia_flat_is_direction(const struct tia_flat_scene *flat, const struct tia_raster_vertex *v)
{
    return flat->eye.projection == TIA_ORTHOGRAPHIC ? v->w == 0 : v->h == 0;
}

/* Gives a vertex's three affine coordinates: x, y and w, in orthographic views x, y and h. */
static inline void tia_flat_affine(const struct tia_flat_scene *flat, const struct tia_raster_vertex *v, int64_t out[3])
{
    out[0] = v->x;
    out[1] = v->y;
    out[2] = flat->eye.projection == TIA_ORTHOGRAPHIC ? v->h : v->w;
}

/* Returns the number of flat faces of a scene whose shadows tia_scene_check accepts. */
uint64_t tia_flat_face_count(const struct tia_scene *scene);

/* Returns the number of samples of a pixel, 1..TIA_SAMPLES_MAX. */
unsigned tia_flat_samples(const struct tia_scene *scene);

/* Returns the number of bytes for a scene whose shadows tia_scene_check accepts; SIZE_MAX when that number does not
 * fit, and when the scene has more than 2^28 faces. */
size_t tia_flat_size(const struct tia_scene *scene);

/* Stores the scene's faces, projected to an image of width x height pixels, in `memory`, which is aligned for uint64_t;
 * the vertices' range is that of tia_reach_with_lights for the scene's lights. Returns TIA_OK; TIA_ERR_RANGE when a
 * corner or a light is too far away for the rasteriser, see reach.h; or TIA_STOPPED when cancelled. */
int tia_flat_init(struct tia_flat_scene *flat, void *memory, size_t size, const struct tia_scene *scene, unsigned width,
                  unsigned height, struct cancel *cancel);

/* Returns the properties of the scene that limit its lights. */
struct tia_reach tia_flat_reach(const struct tia_flat_scene *flat);

/* Returns the range of the scene's vertices, see tia_reach_with_lights. */
unsigned tia_flat_range(const struct tia_flat_scene *flat);
/* Computes the vertices again, with the fraction bits of another range. Returns TIA_OK, or TIA_STOPPED when cancelled:
 * the vertices are then undefined. */
int tia_flat_place(struct tia_flat_scene *flat, const struct tia_scene *scene, unsigned range, struct cancel *cancel);

/* Gives the scene for sample number `sample` of the pixels: its grid and planes are the sample's, the rest is shared
 * with *flat. */
void tia_flat_sample(struct tia_flat_scene *out, const struct tia_flat_scene *flat, const struct tia_scene *scene,
                     unsigned sample);

/* Gives a face's corners; returns the number of corners. */
unsigned tia_flat_corners(const struct tia_flat_scene *flat, uint32_t face,
                          struct tia_raster_vertex corners[TIA_SIDES]);

/* True if a face may cover pixels of the area. */
static inline bool tia_flat_may_cover(const struct tia_flat_scene *flat, uint32_t face, const struct tia_tile *area)
{
    const struct tia_flat_rows *rows = &flat->rows[face];

    return rows->first < (unsigned)area->y + area->height && area->y < rows->end;
}

/* Returns the number of the object's part to which a face belongs, see path_hash in debug.h. */
uint32_t tia_flat_element_of(const struct tia_flat_scene *flat, uint32_t face);

/* Returns the object to which a face belongs. */
const struct tia_flat_object *tia_flat_object_of(const struct tia_flat_scene *flat, uint32_t face);

#endif
