/* views.h - false colours instead of a picture, and the rays of one pixel: a core that draws observations of another
 * core's rays (struct tia_observer), with a legend. A program has only one such core, since a core has no context. */
#ifndef TOOLS_VIEWS_VIEWS_H
#define TOOLS_VIEWS_VIEWS_H

#include <tia/render.h>

#include "lines.h"
#include "view_kind.h"

struct views {
    enum view view;
    bool draws_rays;
    uint16_t x, y; /* the pixel whose rays are drawn; a picture that does not contain it has no rays */
};

/* Returns "colour", ...; NULL for VIEW_COUNT and above. */
const char *view_name(unsigned view);

/* Returns the core for these views. `watched` is tia_core_watched, the core that observes rays. It is a parameter, so
 * that programs without views need not link it. */
const struct tia_core *views_core(const struct views *views, const struct tia_core *watched);

/* Stores the rays of a pixel as lines, for callers that draw them themselves; `view` is a view of the core for these
 * views. *lines are valid until the next call. Returns a negative status on failure. */
int views_point(const struct tia_view *view, unsigned x, unsigned y, const struct line **lines, unsigned *count);

/* Changes the scene so that rays draw it instead of spans, with the same picture up to rounding. */
void views_need_rays(struct tia_scene *scene);

#endif
