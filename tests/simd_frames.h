/* simd_frames.h - frames drawn by SIMD kernels and by plain C, compared byte by byte. */
#ifndef TESTS_SIMD_FRAMES_H
#define TESTS_SIMD_FRAMES_H

#include <stdlib.h>
#include <tia/tia.h>

#include "check.h"
#include "float_modes.h"

#define GUARD 64 /* bytes before and behind the pixels, and between their rows */
#define GUARDED 0xa5

struct simd_frames {
    const struct tia_scene *scene;
    struct tia_tile area;
    struct tia_view *plain, *simd;
    struct tia_hits *hits[2];
    uint8_t *want, *got; /* pixels with guards */
    size_t bytes;
    ptrdiff_t pitch;
    void *memory[5];
};

static inline void *simd_frames_memory(struct simd_frames *f, int i, size_t size)
{
    f->memory[i] = malloc(size ? size : 1);
    if (!f->memory[i])
        abort();
    memset(f->memory[i], 1, size); /* neither 0 by chance nor, in a shadow map, far away */
    return f->memory[i];
}

static inline void simd_frames_close(struct simd_frames *f)
{
    for (int i = 0; i < 5; i++)
        free(f->memory[i]);
    free(f->want);
    free(f->got);
}

/* Opens the frames. Returns false if the scene is refused. */
static inline bool simd_frames_open(struct simd_frames *f, const struct tia_simd *simd, const struct tia_scene *scene,
                                    unsigned width, unsigned height)
{
    size_t view = tia_view_size(scene, scene->light_count);
    size_t more = tia_simd_size(simd, scene, scene->light_count, 4);

    memset(f, 0, sizeof *f);
    f->scene = scene;
    f->area = (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height};
    f->pitch = (ptrdiff_t)(width * sizeof(tia_rgb565) + GUARD);
    f->bytes = GUARD + (size_t)f->pitch * height;
    f->want = malloc(f->bytes);
    f->got = malloc(f->bytes);
    size_t hits = tia_hits_size(scene, f->area);
    bool fine = f->want && f->got &&
                tia_view_init(&f->plain, simd_frames_memory(f, 0, view), view, scene, scene->light_count, width, height,
                              NULL) == TIA_OK &&
                tia_view_init(&f->simd, simd_frames_memory(f, 1, view), view, scene, scene->light_count, width, height,
                              NULL) == TIA_OK &&
                tia_view_set_simd(f->simd, simd, simd_frames_memory(f, 2, more), more) == TIA_OK &&
                tia_hits_init(&f->hits[0], simd_frames_memory(f, 3, hits), hits, f->plain, f->area) == TIA_OK &&
                tia_hits_init(&f->hits[1], simd_frames_memory(f, 4, hits), hits, f->simd, f->area) == TIA_OK;
    if (!fine)
        simd_frames_close(f);
    return fine;
}

static inline struct tia_surface simd_frames_surface(uint8_t *bytes, ptrdiff_t pitch)
{
    return (struct tia_surface){
        .pixels = (tia_rgb565 *)(void *)(bytes + GUARD), .step = sizeof(tia_rgb565), .pitch = pitch};
}

/* Draws both frames; traces them again if `trace`. Returns the number of bytes that differ, including those of
 * guards. */
static inline size_t simd_frames_differ(struct simd_frames *f, bool trace, bool dither)
{
    const struct tia_options options = {dither, NULL};
    const struct tia_surface want = simd_frames_surface(f->want, f->pitch), got = simd_frames_surface(f->got, f->pitch);
    size_t differ = 0;

    memset(f->want, GUARDED, f->bytes);
    memset(f->got, GUARDED, f->bytes);
    if (trace && (tia_view_trace(f->plain, f->hits[0], f->area) || tia_view_trace(f->simd, f->hits[1], f->area)))
        return SIZE_MAX;
    if (tia_view_light(f->plain, f->hits[0], f->area, &want, &options) ||
        tia_view_light(f->simd, f->hits[1], f->area, &got, &options))
        return SIZE_MAX;
    for (size_t i = 0; i < f->bytes; i++)
        differ += f->want[i] != f->got[i];
    return differ;
}

/* Returns the position of the first difference as text. */
static inline const char *simd_frames_where(const struct simd_frames *f)
{
    static char text[80];
    size_t i = 0;

    while (i < f->bytes && f->want[i] == f->got[i])
        i++;
    size_t at = i < GUARD ? 0 : i - GUARD;
    (void)snprintf(text, sizeof text, "pixel (%zu, %zu)", at % (size_t)f->pitch / 2, at / (size_t)f->pitch);
    return text;
}

#endif
