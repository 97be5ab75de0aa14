/* view.h - a view that is rasterised, and what is kept of each sample of each pixel. */
#ifndef TIA_RENDER_HYBRID_VIEW_H
#define TIA_RENDER_HYBRID_VIEW_H

#include "flat/curved.h"
#include "math/align.h"
#include "render/trace/trace.h"
#include "shadow/technique.h"

/* Behind the struct ray_view that the ray renderer prepares. */
struct raster_view {
    uint8_t *first_bit; /* for each light, which of the samples its first one is */
    struct tia_curved_place *places;
    uint32_t place_count;
    unsigned sample_count;           /* of a pixel */
    unsigned shares, more_bytes;     /* of a sample of a pixel, for the technique */
    unsigned range;                  /* of the vertices, see flat/reach.h, or RASTER_NO_RANGE: they are not ready */
    bool whole;                      /* the technique's is_whole */
    struct tia_shadow_view shadow[]; /* one for each; they share all but lattice and planes */
};

static inline struct raster_view *raster_of(const struct tia_view *view)
{
    char *own = (char *)view->prepared + ALIGN(ray_prepared_size(view->scene, view->light_capacity));

    return (struct raster_view *)(void *)own;
}

#define RASTER_NO_RANGE 31

/* Of a sample of all pixels of the hits. */
struct raster_buffers {
    uint64_t *nearness, *lit;
    uint32_t *object; /* what is seen, see raster_object */
    uint32_t *face;   /* of what is seen, TIA_NO_FACE if that is not flat */
    uint32_t *count;
    char *more; /* more_bytes of each pixel */
};

/* Bytes of a sample's, for so many pixels. */
uint64_t raster_sample_size(unsigned more_bytes, uint64_t pixels);

struct raster_buffers raster_buffers(const struct raster_view *raster, const struct tia_hits *hits, unsigned sample);

/* The number of an object, of which there are at most TIA_OBJECTS_MAX, or TIA_NO_OBJECT. In the buffers of the first
 * sample it has the range of the vertices with which the pixel was traced, in the bits above: with another, what all
 * samples of the pixel have is outdated. */
#define RASTER_OBJECT_BITS 25
#define RASTER_OBJECT ((UINT32_C(1) << RASTER_OBJECT_BITS) - 1)

static inline uint32_t raster_object(uint32_t kept)
{
    return (kept & RASTER_OBJECT) == RASTER_OBJECT ? TIA_NO_OBJECT : kept & RASTER_OBJECT;
}

/* tia_trace, with trace.c. */
void raster_trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);

/* The part of the buffers that is a tile's. */
void raster_open_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, unsigned sample,
                      const struct raster_buffers *b, struct tia_shadow_tile *open);

/* Where the ray of a pixel meets a face. */
void raster_find_face(const struct ray_view *rays, const struct tia_flat_scene *flat, uint32_t face, int x, int y,
                      const struct ray *ray, struct hit *hit);

/* tia_light_tile, with light.c. */
void raster_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options);

#endif
