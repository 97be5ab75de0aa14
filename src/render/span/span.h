/* span.h - spheres seen from one eye, a row at a time: for scenes that ask for no more. */
#ifndef TIA_SPAN_H
#define TIA_SPAN_H

#include "render/hits.h"
#include "render/view.h"

/* Bytes for the spheres; they are prepared in `memory`. */
size_t span_size(const struct tia_scene *scene, uint32_t light_capacity);
void span_prepare(struct tia_view *view, void *memory);

/* The view's lights have changed. */
void span_set_lights(struct tia_view *view);

/* Keeps those of `count` distances to sphere `n` that are nearer than the best so far; a tie stays. */
void span_keep_nearer(const struct tia_view *view, uint32_t n, const num_u *t, int count, num_u *best,
                      uint32_t *object);

void span_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
void span_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                const struct tia_surface *surface, const struct tia_options *options);

#endif
