/* technique_frame.h - draws a scene with one technique for shadows: the lights that reach each pixel, and the cost. */
#ifndef TIA_COMPARE_TECHNIQUE_FRAME_H
#define TIA_COMPARE_TECHNIQUE_FRAME_H

#include <tia/port.h>

/* A drawing; the scene's own technique is ignored. */
struct technique_job {
    const struct tia_scene *scene;
    const struct tia_light *lights;
    uint32_t light_count, light_capacity;
    unsigned width, height, rounds; /* rounds: timed runs */
    const struct tia_workers *workers;
};

struct technique_frame {
    const struct technique_job *job;
    enum tia_shadows technique;
    tia_rgb565 *pixels;
    uint32_t *object;
    uint64_t *lit; /* lights that reach each pixel, see struct tia_debug */
    uint64_t wall_us, cpu_us, bytes;

    /* Private. */
    struct tia_scene scene;
    struct tia_view *view;
    struct tia_hits *hits;
    void *view_memory, *hits_memory;
    bool timed;
    int *status; /* status of each job of rows */
};

/* Draws a frame. wall_us and cpu_us are the least times of all rounds, from setting the lights to the finished pixels;
 * `bytes` is the memory of the view and of the whole picture's hits. Returns a negative tia_status on failure; call
 * technique_free in either case. */
int technique_draw(struct technique_frame *frame, const struct technique_job *job, enum tia_shadows technique);
void technique_free(struct technique_frame *frame);

#endif
