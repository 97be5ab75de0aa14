#include "technique_frame.h"

#include <stdlib.h>
#include <tia/debug.h>
#include <time.h>

#include "clock.h"

#define ROWS 16u /* rows of a job */

static struct tia_tile rows_of(const struct technique_job *job, unsigned index)
{
    unsigned y = index * ROWS, left = job->height - y;

    return (struct tia_tile){0, (uint16_t)y, (uint16_t)job->width, (uint16_t)(left < ROWS ? left : ROWS)};
}

static void draw_rows(void *arg, unsigned index)
{
    struct technique_frame *frame = arg;
    struct tia_tile tile = rows_of(frame->job, index);
    size_t at = (size_t)tile.y * tile.width;
    struct tia_surface surface = {.pixels = frame->pixels + at,
                                  .step = sizeof *frame->pixels,
                                  .pitch = (ptrdiff_t)(tile.width * sizeof *frame->pixels)};
    struct tia_options options = {.debug = &(struct tia_debug){.lit = frame->timed ? NULL : frame->lit + at}};

    frame->status[index] = tia_view_draw(frame->view, frame->hits, tile, &surface, &options);
}

static int draw(struct technique_frame *frame)
{
    const struct technique_job *job = frame->job;
    unsigned count = (job->height + ROWS - 1) / ROWS;
    int status = tia_view_set_lights(frame->view, job->lights, job->light_count);

    if (status)
        return status;
    job->workers->run(job->workers->ctx, draw_rows, frame, count);
    for (unsigned i = 0; i < count && !status; i++)
        status = frame->status[i];
    return status;
}

static uint64_t cpu_now_us(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (uint64_t)now.tv_sec * 1000000 + (uint64_t)now.tv_nsec / 1000;
}

static void keep_least(uint64_t *least, uint64_t value)
{
    *least = value < *least ? value : *least;
}

static int time_it(struct technique_frame *frame)
{
    int status = TIA_OK;

    frame->timed = true;
    frame->wall_us = frame->cpu_us = UINT64_MAX;
    for (unsigned i = 0; i < frame->job->rounds && !status; i++) {
        uint64_t wall = clock_now_us(), cpu = cpu_now_us();
        status = draw(frame);
        keep_least(&frame->wall_us, clock_now_us() - wall);
        keep_least(&frame->cpu_us, cpu_now_us() - cpu);
    }
    return status;
}

static int prepare(struct technique_frame *frame)
{
    const struct technique_job *job = frame->job;
    struct tia_tile all = {0, 0, (uint16_t)job->width, (uint16_t)job->height};
    size_t count = (size_t)job->width * job->height;
    size_t view_size = tia_view_size(&frame->scene, job->light_capacity), hits_size = tia_hits_size(&frame->scene, all);

    frame->bytes = (uint64_t)view_size + hits_size;
    frame->view_memory = malloc(view_size);
    frame->hits_memory = malloc(hits_size);
    frame->pixels = malloc(count * sizeof *frame->pixels);
    frame->object = malloc(count * sizeof *frame->object);
    frame->lit = calloc(count, sizeof *frame->lit);
    frame->status = calloc((job->height + ROWS - 1) / ROWS, sizeof *frame->status);
    if (!frame->view_memory || !frame->hits_memory || !frame->pixels || !frame->object || !frame->lit || !frame->status)
        return TIA_ERR_MEMORY;
    int status = tia_view_init(&frame->view, frame->view_memory, view_size, &frame->scene, job->light_capacity,
                               job->width, job->height, NULL);
    return status ? status : tia_hits_init(&frame->hits, frame->hits_memory, hits_size, frame->view, all);
}

int technique_draw(struct technique_frame *frame, const struct technique_job *job, enum tia_shadows technique)
{
    *frame = (struct technique_frame){.job = job, .technique = technique, .scene = *job->scene};
    frame->scene.shadows = technique;
    int status = prepare(frame);
    if (!status)
        status = draw(frame);
    for (unsigned y = 0; y < job->height && !status; y++)
        for (unsigned x = 0; x < job->width; x++)
            frame->object[(size_t)y * job->width + x] = tia_hits_object(frame->hits, x, y);
    return status ? status : time_it(frame);
}

void technique_free(struct technique_frame *frame)
{
    free(frame->view_memory);
    free(frame->hits_memory);
    free(frame->pixels);
    free(frame->object);
    free(frame->lit);
    free(frame->status);
}
