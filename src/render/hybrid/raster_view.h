/* raster_view.h - a rasterised view, and the data of each sample of each pixel. */
#ifndef TIA_RENDER_HYBRID_RASTER_VIEW_H
#define TIA_RENDER_HYBRID_RASTER_VIEW_H

#include "flat/curved_places.h"
#include "math/align.h"
#include "render/trace/trace.h"
#include "shadow/technique.h"

/* A view's data, stored behind the struct ray_view that the ray renderer prepares. */
struct raster_view {
    uint8_t *first_bit; /* for each light, the number of its first sample */
    struct tia_curved_place *places;
    uint32_t place_count;
    unsigned sample_count;           /* samples of a pixel */
    unsigned shares, more_bytes;     /* shares of lights, and `more` bytes, for each sample of a pixel */
    unsigned range;                  /* range of the vertices, see flat/reach.h; RASTER_NO_RANGE: not ready */
    bool whole;                      /* the technique's is_whole */
    struct tia_shadow_view shadow[]; /* one for each sample; they share all but grid and planes */
};

static inline struct raster_view *raster_of(const struct tia_view *view)
{
    char *own = (char *)view->prepared + ALIGN(ray_prepared_size(view->scene, view->light_capacity));

    return (struct raster_view *)(void *)own;
}

#define RASTER_NO_RANGE 31

/* The buffers of one sample, for all pixels of the hits. */
struct raster_buffers {
    uint64_t *nearness, *lit;
    uint32_t *object; /* visible object, see raster_object */
    uint32_t *face;   /* visible face; TIA_NO_FACE if the object is not flat */
    uint32_t *count;
    char *more; /* more_bytes for each pixel */
};

/* Returns the size in bytes of a sample's buffers for `pixels` pixels. */
uint64_t raster_sample_size(unsigned more_bytes, uint64_t pixels);

struct raster_buffers raster_buffers(const struct raster_view *raster, const struct tia_hits *hits, unsigned sample);

/* The number of bits of an object's index, which is at most TIA_OBJECTS_MAX; for TIA_NO_OBJECT all bits are 1. In the
 * first sample's buffer, the bits above store the range of the vertices at the time when the pixel was traced. If the
 * view has another range now, the data of all samples of the pixel are outdated. */
#define RASTER_OBJECT_BITS 25
#define RASTER_OBJECT ((UINT32_C(1) << RASTER_OBJECT_BITS) - 1)

/* Returns the object of an entry in a sample's buffer, or TIA_NO_OBJECT. */
static inline uint32_t raster_object(uint32_t kept)
{
    return (kept & RASTER_OBJECT) == RASTER_OBJECT ? TIA_NO_OBJECT : kept & RASTER_OBJECT;
}

/* Implements tia_view_trace. Defined in raster_trace.c. */
void raster_trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);

/* Sets `open` to the part of a sample's buffers that a tile covers, as the rasteriser's target. */
void raster_open_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, unsigned sample,
                      const struct raster_buffers *b, struct tia_shadow_tile *open);

/* True if a face of an object has interpolated normals. */
static inline bool raster_is_smooth(const struct tia_scene *scene, const struct tia_flat_object *object,
                                    uint32_t element)
{
    const struct tia_shape *shape = &scene->shapes[object->object - scene->sphere_count];

    return object->kind == TIA_MESH && scene->meshes[shape->mesh].faces[element].corner[0].normal != TIA_NO_INDEX;
}

/* Computes the hit of a pixel's ray on a face; TIA_NO_FACE means no hit. */
void raster_find_face(const struct ray_view *rays, const struct tia_flat_scene *flat, uint32_t face, int x, int y,
                      const struct ray *ray, struct hit *hit);

/* Implements tia_view_light. Defined in raster_light.c. */
void raster_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options);

/* Colours a tile ray by ray, after raster_light_tile has found its lights. */
void raster_shade_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options);

#endif
