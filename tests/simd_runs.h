/* simd_runs.h - runs of pixels in the rows of spheres, as src/simd draws them, in edge scenes and in scenes of the
 * corpus. */
#ifndef TESTS_SIMD_RUNS_H
#define TESTS_SIMD_RUNS_H

#include <stdlib.h>

#include "common/corpus/corpus.h"
#include "edge_scene.h"
#include "simd/span/bound_cache.h"
#include "simd/span/crowd.h"

/* Called with the forms of each run that the kernels draw, and of each light of a run that is drawn light by light. */
typedef void simd_runs_try(const struct simd_fine *fine);

static inline void simd_runs_crowd(const struct tia_view *view, const struct simd_row *row, uint32_t sphere,
                                   struct span span, simd_runs_try *try)
{
    static struct simd_fine fine;
    static struct simd_crowd crowd;

    span.end = span.end - span.first > SIMD_BLOCK ? span.first + SIMD_BLOCK : span.end;
    tia_simd_crowd(view, sphere, row->y, span.first, span.end, &crowd);
    if (!tia_simd_fine_place(view, row, sphere, span.first, span.end, &fine))
        return;
    for (uint32_t l = 0; l < view->light_count; l++) {
        const struct simd_lamp *lamp = tia_simd_crowd_lamp(view, &crowd, l);
        fine.lights = fine.casts = 0;
        if (lamp)
            tia_simd_fine_light(&fine, lamp);
        if (fine.lights)
            try(&fine);
    }
}

static inline void simd_runs_row(const struct tia_view *view, const struct simd_row *row, uint32_t sphere,
                                 simd_runs_try *try)
{
    static struct simd_fine fine;
    struct span span = span_sphere_row(view, sphere, row->y, (struct span){0, 0});

    if (span.end - span.first > SIMD_RUN)
        span.end = span.first + SIMD_RUN;
    if (span.first < span.end && tia_simd_is_crowded(view, sphere))
        simd_runs_crowd(view, row, sphere, span, try);
    else if (span.first < span.end &&
             tia_simd_fine(view, row, sphere, simd_lamp_of(view, sphere, 0), span.first, span.end, &fine))
        try(&fine);
}

static inline void simd_runs_scene(const struct tia_scene *scene, unsigned width, unsigned height, simd_runs_try *try)
{
    size_t size = tia_view_size(scene, scene->light_count), more = tia_simd_pairs_size(scene, scene->light_count);
    void *memory = malloc(size), *pairs = malloc(more + 1);
    struct tia_view *view;

    if (scene->light_count && !tia_view_init(&view, memory, size, scene, scene->light_count, width, height, NULL)) {
        const struct span_view *spans = span_view_of(view);
        view->simd_memory = pairs;
        tia_simd_prepare(view);
        for (uint32_t n = 0; n < scene->sphere_count; n++)
            for (int y = 0; y < (int)height; y += 3) {
                struct simd_row row;
                tia_simd_row(spans, y, &row);
                if (spans->spheres[n].c > 0 && y >= spans->spheres[n].rows.first && y < spans->spheres[n].rows.end)
                    simd_runs_row(view, &row, n, try);
            }
    }
    free(memory);
    free(pairs);
}

/* Calls `try` for the runs of `edges` edge scenes, and of `corpus` scenes of the corpus in 320x240. */
static inline void simd_runs(unsigned edges, unsigned corpus, simd_runs_try *try)
{
    static struct edge_scene e;
    static struct corpus_scene c;

    for (unsigned i = 1; i <= edges; i++) {
        edge_make(&e, i);
        simd_runs_scene(&e.scene, e.width, e.height, try);
    }
    for (unsigned i = 0; i < corpus; i++) {
        corpus_random(&c, 7, i);
        simd_runs_scene(&c.scene, 320, 240, try);
    }
}

#endif
