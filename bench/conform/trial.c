#include "trial.h"

#include <stdlib.h>
#include <string.h>

/* Marsaglia's xorshift, "Xorshift RNGs", 2003. */
static uint32_t below(uint64_t *seed, uint32_t n)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (uint32_t)((*seed >> 16) % n);
}

static struct tia_stencil any_stencil(uint64_t *seed)
{
    return (struct tia_stencil){.test = (enum tia_compare)below(seed, 8),
                                .reference = (uint8_t)below(seed, 4),
                                .mask = (uint8_t)(below(seed, 2) ? 255 : below(seed, 256)),
                                .write = (uint8_t)(below(seed, 2) ? 255 : below(seed, 256)),
                                .fail = (enum tia_stencil_op)below(seed, 8),
                                .zfail = (enum tia_stencil_op)below(seed, 8),
                                .zpass = (enum tia_stencil_op)below(seed, 8)};
}

static struct tia_raster_state any_state(uint64_t *seed)
{
    static const struct tia_stencil none = {.test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255};
    bool stencil = below(seed, 2), writes = below(seed, 4) > 0;
    struct tia_raster_state state = {.depth = (enum tia_compare)below(seed, 8),
                                     .depth_write = writes,
                                     .skip_front = below(seed, 8) == 0,
                                     .skip_back = below(seed, 8) == 0,
                                     .front = none,
                                     .back = none,
                                     .colour_write = {writes, writes, writes}}; /* a colour only with its depth */

    if (stencil) {
        state.front = any_stencil(seed);
        state.back = any_stencil(seed);
    }
    return state;
}

void trial_random(struct trial *trial, uint64_t *seed, unsigned step)
{
    trial->count = TRIANGLES;
    trial->clear = (uint8_t)below(seed, 4);
    for (unsigned t = 0; t < TRIANGLES; t++) {
        struct triangle *triangle = &trial->triangles[t];
        triangle->level = (int32_t)(1 + below(seed, LEVELS));
        triangle->state = any_state(seed);
        for (int i = 0; i < 3; i++) {
            triangle->x[i] = (int32_t)(below(seed, SIDE * 256 / step + 1) * step);
            triangle->y[i] = (int32_t)(below(seed, SIDE * 256 / step + 1) * step);
        }
    }
}

struct tia_raster_vertex trial_vertex(const struct triangle *triangle, int corner, int64_t one)
{
    int64_t unit = one / (SIDE * 128) * triangle->level;

    return (struct tia_raster_vertex){(triangle->x[corner] - SIDE * 128) * unit,
                                      (SIDE * 128 - triangle->y[corner]) * unit, one * triangle->level, 1};
}

static int draw_all(struct tia_raster_target *target, const struct trial *trial)
{
    int status = tia_raster_clear_stencil(target, trial->clear, 255);

    for (uint32_t face = 0; face < trial->count && !status; face++) {
        const struct triangle *triangle = &trial->triangles[face];
        struct tia_raster_vertex v[3];
        for (int i = 0; i < 3; i++)
            v[i] = trial_vertex(triangle, i, INT64_C(1) << target->grid->fraction);
        status = tia_raster_draw(target, &triangle->state, v, 3, face);
    }
    return status;
}

bool trial_exact(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    struct tia_tile area = {0, 0, SIDE, SIDE};
    unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL;
    size_t size = tia_raster_size(area, buffers, TRIANGLES);
    struct tia_raster_grid grid;
    struct tia_raster_target target;
    void *memory = malloc(size);

    (void)ctx;
    bool drawn = memory && !tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIDE, SIDE, 1, 0, 5) &&
                 !tia_raster_init(&target, memory, size, &grid, area, buffers, TRIANGLES) && !draw_all(&target, trial);
    for (unsigned i = 0; drawn && i < PIXELS; i++) {
        pixels->face[i] = target.face[i];
        pixels->stencil[i] = target.stencil[i];
    }
    free(memory);
    return drawn;
}

static int32_t *put_side(int32_t *to, const struct tia_stencil *s)
{
    const int32_t side[] = {(int32_t)s->test, s->reference,      s->mask,          s->write,
                            (int32_t)s->fail, (int32_t)s->zfail, (int32_t)s->zpass};

    memcpy(to, side, sizeof side);
    return to + sizeof side / sizeof *side;
}

unsigned trial_numbers(const struct trial *trial, int32_t numbers[TRIAL_NUMBERS])
{
    int32_t *to = numbers;

    *to++ = (int32_t)trial->count;
    *to++ = trial->clear;
    for (unsigned i = 0; i < trial->count; i++) {
        const struct triangle *t = &trial->triangles[i];
        for (int k = 0; k < 3; k++) {
            *to++ = t->x[k];
            *to++ = t->y[k];
        }
        *to++ = t->level;
        *to++ = (int32_t)t->state.depth;
        *to++ = t->state.depth_write;
        *to++ = t->state.colour_write[0];
        *to++ = t->state.skip_front;
        *to++ = t->state.skip_back;
        to = put_side(put_side(to, &t->state.front), &t->state.back);
    }
    return (unsigned)(to - numbers);
}

void trial_take(struct pixels *pixels, const uint8_t bytes[2 * PIXELS])
{
    for (unsigned i = 0; i < PIXELS; i++) {
        pixels->face[i] = bytes[i] == 255 ? TIA_NO_FACE : bytes[i];
        pixels->stencil[i] = bytes[PIXELS + i];
    }
}

unsigned trial_differs(const struct pixels *exact, const struct pixels *found, unsigned *first)
{
    unsigned count = 0;

    for (unsigned i = 0; i < PIXELS; i++) {
        if (exact->face[i] == found->face[i] && exact->stencil[i] == found->stencil[i])
            continue;
        if (count++ == 0)
            *first = i;
    }
    return count;
}
