#include "sample_picture.h"

#include <stdlib.h>
#include <tia/tone.h>

#include "arithmetic.h"
#include "clock.h"
#include "common/image/image.h"
#include "common/sink.h"
#include "estimation.h"
#include "fail.h"
#include "film_plan.h"
#include "surfaces.h"

enum { LOOK_US = 5000 };

/* True if the drawing must stop. All threads call this after every few rays; once in LOOK_US microseconds, one of them
 * checks for the time limit and signals. The time of the last check has 32 bits, since some processors lack 64-bit
 * atomics; after an overflow the next check is still at most LOOK_US away. */
static bool stops(void *ctx)
{
    struct estimation *e = ctx;
    uint64_t now = e->end_us ? clock_now_us() : 0;

    if (!e->end_us || atomic_load(&e->stopped))
        return e->end_us != 0;
    if ((uint32_t)now - atomic_load(&e->looked_us) >= LOOK_US) {
        atomic_store(&e->looked_us, (uint32_t)now);
        if (now >= e->end_us || signals_asked(NULL))
            atomic_store(&e->stopped, true);
    }
    return atomic_load(&e->stopped);
}

/* Warns of the first light inside an object, where it illuminates nothing else. */
static void warn_of_walls(const struct estimation *e)
{
    const struct film_scene *film = &e->film_scene;

    for (uint32_t i = 0; i < film->lights.count && film->scene->integration.integrator == TIA_PATHS; i++) {
        uint32_t object = e->estimator->enclosing(film->view, i), spheres = film->scene->sphere_count;
        if (object == TIA_NO_OBJECT)
            continue;
        note("--integrator path: light %u is inside %s %u: it lights nothing else", (unsigned)i,
             object < spheres ? "sphere" : "shape", (unsigned)(object < spheres ? object : object - spheres));
        return;
    }
}

static int begin(struct estimation *e)
{
    const struct options *options = e->options;

    e->bytes = malloc((size_t)estimation_band_rows(e) * e->film.width * (sizeof(struct tia_sum) + 4));
    e->pool = threads_create(options->threads);
    if (!e->bytes || !e->pool)
        return TIA_ERR_MEMORY;
    e->film_scene.job = (struct tia_job){.stop = stops, .ctx = e};
    int status = film_scene_begin(&e->film_scene, options, e->why);
    status = status ? status : film_scene_update(&e->film_scene, 0);
    if (!status)
        warn_of_walls(e);
    return status;
}

static int finish(struct estimation *e, int status)
{
    if (e->sink) {
        if (!status)
            status = sink_commit(e->sink);
        else
            sink_discard(e->sink);
        free(e->sink);
    } else if (e->image && !status) {
        return image_finish(e->image);
    } else if (e->image) {
        image_discard(e->image);
    }
    return status;
}

static void prepare(struct estimation *e)
{
    const struct options *options = e->options;
    const struct tia_integration *how = &options->scene.integration;

    e->estimator = arithmetic_estimator(options->core);
    e->film.depth = options->format == IMAGE_PART ? 0 : options->depth_bits;
    e->sums = (struct sums){.width = e->film.width,
                            .height = e->film.height,
                            .count = how->spp ? how->spp : TIA_SPP_DEFAULT,
                            .tone = tia_tone_of(how),
                            .exposure = how->exposure,
                            .crc = e->film.crc,
                            .guided = options->denoise || options->guide};
    if (options->samples_range) {
        e->sums.first = options->first_sample;
        e->sums.count = options->last_sample - options->first_sample + 1;
    }
    e->film.transfer = sums_transfer(&e->sums, e->film.depth);
    e->row_bytes =
        options->format == IMAGE_PART ? sums_row_bytes(&e->sums) : (size_t)e->film.width * 3 * e->film.depth / 8;
}

static int report(const struct estimation *e, int status)
{
    if (!status)
        return signals_end(EXIT_FINE);
    if (status == TIA_STOPPED) { /* a signal needs no message */
        (void)signals_end(EXIT_RUNNING);
        return fail(EXIT_RUNNING, "--time-limit: not one sample of each pixel was drawn by then");
    }
    return signals_end(
        fail(status == TIA_ERR_RANGE ? EXIT_USAGE : EXIT_RUNNING, "%s", e->why[0] ? e->why : fail_reason(status)));
}

/* Draws the picture in rounds if there is memory for them or an option needs them, else in bands. */
static int draw(struct estimation *e)
{
    const struct options *options = e->options;
    int status = rounds_possible(e) ? rounds_draw(e) : bands_draw(e);

    if (status != ROUNDS_NO_MEMORY)
        return status;
    return options->error || options->time_limit ? TIA_ERR_MEMORY : bands_draw(e);
}

int estimate(const struct options *options)
{
    struct estimation e = {.options = options};
    struct image_surface *surfaces = NULL;
    int status = film_plan(options, &e.film);

    if (status != EXIT_FINE)
        return status;
    prepare(&e);
    progress_begin(&e.progress, options, (uint64_t)e.film.width * e.film.height, 1);
    status = begin(&e);
    if (!status && options->format == IMAGE_EXR)
        status = surfaces_find(&surfaces, options, e.why);
    e.film.surfaces = surfaces;
    if (!status)
        status = draw(&e);
    if (options->tap && options->tap->samples)
        *options->tap->samples = e.unfinished ? 0 : e.sums.count;
    status = finish(&e, status);
    progress_end(&e.progress);
    threads_destroy(e.pool);
    film_scene_end(&e.film_scene);
    free(e.bytes);
    free(surfaces);
    return report(&e, status);
}
