/* entry.c - the way into a level from the library's functions, and out of it. */
#include "environment.h"
#include "level.h"

static const struct level_renderer *part_of(const struct tia_view *view)
{
    const struct level_renderer *part = level_renderer_for(view->level, view->renderer);

    __asm__("" : "+r"(part)); /* the compiler knows not what is called, and moves no computation out of between */
    return part;
}

static void prepare_all(struct tia_view *view, bool anew)
{
    const struct level_renderer *part = part_of(view);
    struct environment caller;

    view->level_prepared = (anew || view->level_prepared) && environment_take(&caller);
    if (!view->level_prepared)
        return;
    if (anew && part->open)
        part->open(view);
    part->prepare(view);
    environment_leave(&caller);
}

static void open(struct tia_view *view)
{
    prepare_all(view, true);
}

static void prepare(struct tia_view *view)
{
    prepare_all(view, false);
}

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options)
{
    struct environment caller;

    if (!view->level_prepared || !environment_take(&caller)) {
        tia_level_light_plain(view, tile, surface, options);
        return;
    }
    part_of(view)->light(view, tile, surface, options);
    environment_leave(&caller);
}

static void sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered)
{
    struct environment caller;

    if (!view->level_prepared || !environment_take(&caller)) {
        view->renderer->sample(view, tile, first, end, gathered);
        return;
    }
    part_of(view)->sample(view, tile, first, end, gathered);
    environment_leave(&caller);
}

const struct level_entries tia_level_entries = {open, prepare, light, sample};
