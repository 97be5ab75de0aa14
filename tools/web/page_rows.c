/* page_rows.c - rows of the picture that another worker shows: to share its work, to save the picture with 16 bits a
 * channel, and for its record. */
#include "page.h"

#include <stdlib.h>
#include <tia/tone.h>

#include "common/scene/moment.h"

#define EXPORT(name) __attribute__((export_name(name)))

enum { ROWS = 16 }; /* most rows drawn at once */

static struct {
    struct moment moment;
    void *view_memory, *hits_memory, *simd_memory;
    size_t hits_size;
    struct tia_view *view;
    struct tia_sum *sums; /* of ROWS rows; NULL: Whitted's integrator */
    uint32_t samples;     /* samples of a pixel that web_rows draws */
    uint16_t *colours;    /* NULL, or 16 bits a channel of the whole picture */
} rows;

static void release(void)
{
    moment_end(&rows.moment);
    free(rows.view_memory);
    free(rows.hits_memory);
    free(rows.simd_memory);
    free(rows.sums);
    free(rows.colours);
    rows.view_memory = rows.hits_memory = rows.simd_memory = NULL;
    rows.sums = NULL;
    rows.colours = NULL;
    rows.view = NULL;
}

static bool get_memory(const struct tia_core *core, size_t view_size, size_t simd_size, bool colours)
{
    uint16_t width = session.screen.width, height = session.screen.height;

    rows.hits_size = core->hits_size(core, &session.scene, (struct tia_tile){0, 0, width, ROWS});
    rows.view_memory = malloc(view_size);
    rows.hits_memory = malloc(rows.hits_size);
    rows.simd_memory = simd_size ? malloc(simd_size) : NULL;
    rows.sums = session.spp ? malloc((size_t)ROWS * width * sizeof *rows.sums) : NULL;
    rows.colours = colours ? malloc((size_t)width * height * 3 * sizeof *rows.colours) : NULL;
    return rows.view_memory && rows.hits_memory && (rows.simd_memory || !simd_size) && (rows.sums || !session.spp) &&
           (rows.colours || !colours);
}

static int begin(bool colours)
{
    const struct tia_core *core = seat_core();
    const struct tia_simd *simd = seat.base == &tia_core_q16 && !colours ? tia_simd_best() : NULL;
    uint32_t capacity = session.lights.capacity;
    uint16_t width = session.screen.width, height = session.screen.height;
    size_t view_size = core->view_size(core, &session.scene, capacity);
    size_t simd_size = simd && core->simd_size ? core->simd_size(core, simd, &session.scene, capacity, 1) : 0;

    if (!get_memory(core, view_size, simd_size, colours))
        return TIA_ERR_MEMORY;
    int status =
        core->view_init(core, &rows.view, rows.view_memory, view_size, &session.scene, capacity, width, height, NULL);
    if (!status && simd_size)
        status = tia_view_set_simd(rows.view, simd, rows.simd_memory, simd_size);
    return status ? status : tia_view_set_lights(rows.view, session.lights.array, session.state.light_count);
}

/* Prepares the picture of the state that web_take_kept took over, with 16 bits a channel if `colours` is not 0, and
 * with `samples` samples a pixel, 0: those of the settings. Returns 0; or 1, with the reason in web_why. */
EXPORT("web_rows_begin") int web_rows_begin(int colours, unsigned samples);
int web_rows_begin(int colours, unsigned samples)
{
    release();
    int status = session_begin(true) ? moment_begin(&rows.moment, &session.scene, session.state.time) : TIA_ERR_MEMORY;
    if (!status) {
        session.scene.camera = *session_camera();
        session.scene.shadows = session.shadows;
        rows.samples = samples ? samples : session.spp;
        status = begin(colours != 0);
    }
    if (status)
        session_failed(status);
    return status != TIA_OK;
}

/* Draws a row of samples. */
static int draw_samples(uint16_t y)
{
    const struct tia_integration *how = &session.scene.integration;
    uint16_t width = session.screen.width;
    int status = samples_sum(rows.view, (struct tia_tile){0, y, width, 1}, 0, rows.samples, rows.sums);

    for (unsigned x = 0; x < width && !status; x++) {
        size_t at = (size_t)y * width + x;
        session.screen.pixels[at] = samples_pixel(how, &rows.sums[x], rows.samples);
        for (unsigned c = 0; c < 3 && rows.colours; c++)
            rows.colours[3 * at + c] =
                (uint16_t)samples_level(how, TIA_TONE_LINEAR, rows.sums[x].rgb[c], rows.samples, 16);
    }
    return status;
}

static int draw_traced(uint16_t y, uint16_t count)
{
    uint16_t width = session.screen.width;
    size_t at = (size_t)y * width;
    const struct tia_tile tile = {0, y, width, count};
    const struct tia_options options = {.colours = rows.colours ? rows.colours + 3 * at : NULL};
    const struct tia_surface surface = {.pixels = session.screen.pixels + at,
                                        .step = sizeof(tia_rgb565),
                                        .pitch = (ptrdiff_t)(width * sizeof(tia_rgb565))};
    struct tia_hits *hits;
    int status = tia_hits_init(&hits, rows.hits_memory, rows.hits_size, rows.view, tile);

    return status ? status : tia_view_draw(rows.view, hits, tile, &surface, &options);
}

int rows_draw(unsigned y, unsigned count)
{
    int status = TIA_OK;

    if (!rows.sums)
        return draw_traced((uint16_t)y, (uint16_t)count);
    for (unsigned i = 0; i < count && !status; i++)
        status = draw_samples((uint16_t)(y + i));
    return status;
}

static bool has_drawn(int status)
{
    if (status)
        session_failed(status);
    return !status;
}

static bool are_rows(unsigned y, unsigned count)
{
    return count <= ROWS && y + count <= session.screen.height;
}

/* Draws rows y .. y + count - 1, at most 16. Returns their first pixel, RGB565; NULL on failure, with the reason in
 * web_why. */
EXPORT("web_rows") const tia_rgb565 *web_rows(unsigned y, unsigned count);
const tia_rgb565 *web_rows(unsigned y, unsigned count)
{
    int status = are_rows(y, count) ? rows_draw(y, count) : TIA_ERR_ARGUMENT;

    return has_drawn(status) ? session.screen.pixels + (size_t)y * session.screen.width : NULL;
}

/* Draws one sample of the same rows, of a picture with samples. Returns their pixels' sums, or NULL. */
EXPORT("web_sums") const struct tia_sum *web_sums(unsigned y, unsigned count, unsigned sample);
const struct tia_sum *web_sums(unsigned y, unsigned count, unsigned sample)
{
    const struct tia_tile tile = {0, (uint16_t)y, session.screen.width, (uint16_t)count};
    int status = rows.sums && are_rows(y, count) ? samples_sum(rows.view, tile, sample, sample + 1, rows.sums)
                                                 : TIA_ERR_ARGUMENT;

    return has_drawn(status) ? rows.sums : NULL;
}

/* Returns the red, green and blue of all pixels drawn by web_rows, 0..65535. */
EXPORT("web_colours") const uint16_t *web_colours(void);
const uint16_t *web_colours(void)
{
    return rows.colours;
}
