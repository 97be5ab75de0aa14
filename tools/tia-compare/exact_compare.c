#include "exact_compare.h"

#include <inttypes.h>
#include <stdio.h>
#include <tia/debug.h>

#include "common/message.h"

void exact_begin(struct exact_run *run, const struct options *options, const struct tia_workers *workers)
{
    *run = (struct exact_run){.what = {.dither = options->dither, .step = options->every, .workers = workers},
                              .report = {.json = options->json, .summary = options->summary}};
    exact_drawers(&run->what);
#ifdef TIA_HAVE_F64
    exact_add(&run->what, &tia_core_f64);
    exact_add(&run->what, &tia_core_f32);
#endif
    run->report.what = &run->what;
    exact_report_begin(&run->report);
}

static void keep_first(struct exact_run *run, const char *name, const struct exact_tally *tally)
{
    for (unsigned n = 0; n < run->what.drawer_count && !*run->first; n++) {
        const struct exact_drawn *drawn = &tally->by[n];
        if (drawn->differ && !run->what.drawers[n].approximate)
            (void)snprintf(run->first, sizeof run->first,
                           "%.60s: %s: pixel (%u, %u) is %04x, not %04x, and %" PRIu64 " more differ", name,
                           run->what.drawers[n].name, drawn->x, drawn->y, drawn->got, drawn->want, drawn->differ - 1);
    }
}

int exact_frame(struct exact_run *run, const char *name, const struct tia_scene *scene, unsigned width, unsigned height)
{
    struct exact_measure what = run->what;
    struct exact_tally tally;

    what.scene = scene;
    what.width = width;
    what.height = height;
    int status = exact_measure(&what, &tally);
    if (status == TIA_ERR_UNSUPPORTED)
        return message("tia-compare", 2, "%s: --exact: not a scene of matt balls, which docs/definition.md is for",
                       name);
    if (status)
        return message_why("tia-compare", 1, name,
                           status == TIA_ERR_MEMORY ? "out of memory" : "the scene cannot be drawn");
    keep_first(run, name, &tally);
    exact_report_frame(&run->report, name, &what, &tally);
    return 0;
}

int exact_end(const struct exact_run *run)
{
    exact_report_end(&run->report);
    return *run->first ? message("tia-compare", 1, "%s", run->first) : 0;
}
