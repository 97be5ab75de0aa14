/* page_core.c - the core for the settings. It records its view, with which samples and single rays are drawn later. */
#include "page.h"

#include <tia/debug.h>

struct seat seat;
static struct tia_core own;
static struct tia_drawing base_drawing, drawing;

static int view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                     const struct tia_scene *scene, uint32_t capacity, unsigned width, unsigned height,
                     const struct tia_job *job)
{
    seat.view = NULL;
    int status = seat.base->view_init(core, view, memory, size, scene, capacity, width, height, job);
    seat.view = status ? NULL : *view;
    return status;
}

/* Sets the lights, before each frame. */
static int set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    samples_reset();
    share_begin();
    for (unsigned i = 0; i < 3; i++)
        difference_counts[i] = 0;
    return base_drawing.set_lights(view, lights, count);
}

static const struct tia_core *base_of(const struct settings *settings)
{
    const struct views views = {.view = settings->view};

    if (settings->arithmetic == ARITHMETIC_DIFFERENCE)
        return &difference_core;
    if (settings->arithmetic == ARITHMETIC_F64)
        return &tia_core_f64;
    if (session.scene.integration.integrator != TIA_WHITTED || (settings->view == VIEW_COLOUR && !settings->rays))
        return &tia_core_q16;
    views_need_rays(&session.scene);
    return views_core(&views, &tia_core_watched);
}

const struct tia_core *seat_core(void)
{
    seat = (struct seat){.base = base_of(&session.settings)};
    own = *seat.base;
    own.view_init = view_init;
    own.drawing = &drawing;
    base_drawing = seat.base->drawing ? *seat.base->drawing : tia_drawing;
    drawing = base_drawing;
    drawing.set_lights = set_lights;
    share_wrap(&base_drawing, &drawing);
    return &own;
}
