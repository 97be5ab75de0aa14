/* tia-compare - compares fixed point with floating point, pixel by pixel, over a set of scenes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/corpus/corpus.h"
#include "common/corpus/corpus_hard.h"
#include "common/corpus/corpus_rays.h"
#include "common/corpus/corpus_ties.h"
#include "common/message.h"
#include "common/scene/scene_load.h"
#include "common/scene/scene_report.h"
#include "common/signals.h"
#include "common/thread_pool.h"
#include "exact_compare.h"
#include "heatmap.h"
#include "heatmap_files.h"
#include "options.h"
#include "report.h"
#include "shadows_compare.h"

#ifdef TIA_HAVE_F64

struct run {
    struct options options;
    struct measure what;
    struct report report;
    struct pictures pictures;
    struct exact_run exact;
};

static int failed(const char *what, const char *why)
{
    return message_why("tia-compare", 1, what, why);
}

/* Converts a status of run->pictures to an exit status, after printing the reason of an error. */
static int report(const struct run *run, int status)
{
    if (!status)
        return 0;
    return message("tia-compare", 1, "%s", run->pictures.why);
}

/* Chooses the reference, and the cores to compare with it. Returns 0, or an exit status after printing the reason. */
static int choose_cores(struct measure *what, const char *reference)
{
    if (strcmp(reference, tia_core_f64.name) == 0) {
        what->reference = &tia_core_f64;
        what->cores[what->core_count++] = &tia_core_q16;
        what->cores[what->core_count++] = &tia_core_f32;
        return 0;
    }
#ifdef TIA_HAVE_F128
    what->reference = &tia_core_f128;
    what->cores[what->core_count++] = &tia_core_q16;
    what->cores[what->core_count++] = &tia_core_f64;
    what->cores[what->core_count++] = &tia_core_f32;
    return 0;
#else
    return message_why("tia-compare", 2, "--arithmetic", "this build has no numbers of 113 bits");
#endif
}

static int measure_frame(struct run *run, const char *name, const struct tia_scene *scene, unsigned width,
                         unsigned height)
{
    struct measure what = run->what;
    struct tally tallies[MEASURE_CORES];
    struct heatmap map = {0};
    int status = TIA_OK, result = 0;

    what.scene = scene;
    what.width = width;
    what.height = height;
    if (run->options.heatmap) {
        status =
            heatmap_alloc(&map, what.width, what.height, what.core_count, heatmap_verdicts) ? TIA_OK : TIA_ERR_MEMORY;
        what.picture = map.picture;
        what.differs = heatmap_mark;
        what.arg = &map;
    }
    if (!status)
        status = measure(&what, tallies);
    if (status)
        result = failed(name, status == TIA_ERR_MEMORY ? "out of memory" : "the scene cannot be drawn");
    else if (run->options.heatmap)
        result = report(run, pictures_add(&run->pictures, &map));
    if (result == 0)
        report_frame(&run->report, name, what.width, what.height, tallies);
    heatmap_free(&map);
    return result;
}

static int run_frame(struct run *run, const char *name, const struct tia_scene *scene, unsigned width, unsigned height)
{
    const struct options *o = &run->options;

    width = o->width > 0 ? o->width : width;
    height = o->width > 0 ? o->height : height;
    return o->exact ? exact_frame(&run->exact, name, scene, width, height)
                    : measure_frame(run, name, scene, width, height);
}

static int run_thesis(struct run *run, const char *keys)
{
    struct corpus_scene c;
    char name[64];

    if (corpus_thesis(&c, keys, 1920, 1080) < 0)
        return failed(keys, "one of these keys would quit");
    (void)snprintf(name, sizeof name, "thesis %s", *keys != '\0' ? keys : "none");
    return run_frame(run, name, &c.scene, c.width, c.height);
}

/* Compares `count` random scenes of a kind. */
static int run_random(struct run *run, const char *kind,
                      void (*make)(struct corpus_scene *out, uint64_t seed, unsigned index), unsigned count)
{
    struct corpus_scene c;
    char name[24];
    int result = 0;

    for (unsigned i = 0; i < count && result == 0; i++) {
        make(&c, run->options.seed, i);
        (void)snprintf(name, sizeof name, "%s %u", kind, i);
        result = run_frame(run, name, &c.scene, c.width, c.height);
    }
    return result;
}

static int run_rays_random(struct run *run, unsigned i)
{
    struct corpus_rays c;
    char name[24];

    corpus_random_rays(&c, run->options.seed, i);
    (void)snprintf(name, sizeof name, "rays %u", i);
    return run_frame(run, name, &c.scene, c.width, c.height);
}

static int run_file(struct run *run, const char *path)
{
    struct scene_file file;
    const struct scene_wish wish = {.threads = run->options.threads};
    const char *slash = strrchr(path, '/');

    if (scene_open_for(&file, path, scene_format_of(path), false, &wish))
        return scene_report_print(&file, "tia-compare", 2);
    char line[SCENE_WHY];
    for (unsigned at = 0; scene_warning(&file, &at, line);)
        (void)message("tia-compare", 0, "%s", line);
    int result = run_frame(run, slash ? slash + 1 : path, &file.scene, 640, 480);
    scene_close(&file);
    return result;
}

static int run_frames(struct run *run)
{
    static const char *const all_keys[] = {"", "a", "d", "s", "w"};
    const struct options *o = &run->options;
    unsigned thesis = !o->thesis ? 0 : o->keys ? 1 : 5;
    unsigned count = thesis + o->random + o->ties + o->hard + o->rays_random + (unsigned)o->scene_count;
    int result = 0;

    if (o->heatmap && !pictures_begin(&run->pictures, o->heatmap, count))
        result = report(run, TIA_ERR_MEMORY);
    for (unsigned i = 0; i < thesis && result == 0; i++)
        result = run_thesis(run, o->keys ? o->keys : all_keys[i]);
    if (result == 0)
        result = run_random(run, "random", corpus_random, o->random);
    if (result == 0)
        result = run_random(run, "ties", corpus_ties, o->ties);
    if (result == 0)
        result = run_random(run, "hard", corpus_hard, o->hard);
    for (unsigned i = 0; i < o->rays_random && result == 0; i++)
        result = run_rays_random(run, i);
    for (int i = 0; i < o->scene_count && result == 0; i++)
        result = run_file(run, o->scenes[i]);
    if (result == 0)
        result = report(run, pictures_publish(&run->pictures));
    pictures_end(&run->pictures);
    return result;
}

/* Checks the limits, which apply to q16, the first core, over all frames together. */
static int check_bounds(const struct run *run)
{
    const struct options *o = &run->options;
    const struct tally *sum = &run->report.sums[0];
    int result = 0;

    if (tally_percent(sum) < o->require_identical)
        result = message("tia-compare", 1, "q16: %.7f %% identical: less than %g %%", tally_percent(sum),
                         o->require_identical);
    if (o->max_flips >= 0 && sum->flips > (uint64_t)o->max_flips)
        result = message("tia-compare", 1, "q16: %llu flips: more than %lld", (unsigned long long)sum->flips,
                         (long long)o->max_flips);
    if (o->max_levels >= 0 && sum->astray > (uint64_t)o->max_levels)
        result = message("tia-compare", 1, "q16: a pixel of the same state is off by %llu levels: more than %lld",
                         (unsigned long long)sum->astray, (long long)o->max_levels);
    return result;
}

static int compare_exactly(struct run *run, const struct tia_workers *workers)
{
    exact_begin(&run->exact, &run->options, workers);
    int result = run_frames(run);

    return result ? result : exact_end(&run->exact);
}

static int compare_arithmetics(struct run *run)
{
    report_begin(&run->report);
    int result = run_frames(run);
    if (result == 0) {
        report_end(&run->report);
        result = check_bounds(run);
    }
    return result;
}

int main(int argc, char **argv)
{
    struct run run = {0};
    int result = options_parse(&run.options, argc, argv);

    if (result != COMMAND_RUN)
        return result;
    result = choose_cores(&run.what, run.options.arithmetic);
    if (result != 0)
        return result;
    signals_prepare();
    struct threads *pool = threads_create(run.options.threads);
    if (!pool)
        return failed("threads", "out of memory");
    run.what.dither = run.options.dither;
    run.what.workers = threads_workers(pool);
    run.report = (struct report){.json = run.options.json, .summary = run.options.summary, .what = &run.what};
    result = run.options.exact     ? compare_exactly(&run, threads_workers(pool))
             : run.options.shadows ? shadows_compare(&run.options, pool)
                                   : compare_arithmetics(&run);
    threads_destroy(pool);
    return message_output("tia-compare", "") ? 1 : result;
}

#else

int main(void)
{
    (void)fputs("tia-compare: f64: this build has no floating-point arithmetic (make F64=yes)\n", stderr);
    return 1;
}

#endif
