/* idle_samples.c - draws samples while the page is idle, and shows the picture as it improves. */
#include <stdlib.h>
#include <tia/tone.h>

#include "page.h"

enum { SHOW_US = 150000 }; /* time between two intermediate pictures */

static struct {
    struct tia_sum *sums;
    size_t room;        /* size of the sums */
    uint32_t done, row; /* number of samples that all pixels have; number of rows that have one more */
    uint64_t shown_us;  /* time when a picture was last shown */
} now;

void samples_reset(void)
{
    now.done = now.row = 0;
    now.shown_us = web_clock.now_us(NULL);
}

bool samples_left(void)
{
    return seat.view && session.spp > 1 && now.done < session.spp;
}

static bool get_memory(size_t pixels)
{
    if (now.room < pixels) {
        free(now.sums);
        now.sums = malloc(pixels * sizeof *now.sums);
        now.room = now.sums ? pixels : 0;
    }
    for (size_t i = 0; now.sums && now.done == 0 && now.row == 0 && i < pixels; i++)
        now.sums[i] = (struct tia_sum){{0, 0, 0}};
    return now.sums;
}

unsigned samples_level(const struct tia_integration *how, enum tia_tone tone, int64_t sum, uint32_t count,
                       unsigned bits)
{
    const struct tia_exposure exposure = tia_exposure_of(how->exposure);

    return tia_tone_level(tone, tia_exposed(&exposure, sum, count), bits);
}

tia_rgb565 samples_pixel(const struct tia_integration *how, const struct tia_sum *sum, uint32_t count)
{
    static const unsigned bits[3] = {5, 6, 5};
    unsigned pixel = 0;

    for (int c = 0; c < 3; c++)
        pixel = pixel << bits[c] | samples_level(how, tia_tone_of(how), sum->rgb[c], count, bits[c]);
    return (tia_rgb565)pixel;
}

static void show(void)
{
    const struct tia_integration *how = &session.scene.integration;

    for (size_t i = 0; i < (size_t)session.screen.width * session.screen.height; i++)
        session.screen.pixels[i] = samples_pixel(how, &now.sums[i], now.done);
    session.frame.samples = now.done;
    session_show();
    now.shown_us = web_clock.now_us(NULL);
}

int samples_go_on(void)
{
    const struct tia_estimator *estimator =
        session.settings.arithmetic == ARITHMETIC_F64 ? &tia_estimator_f64 : &tia_estimator_q16;
    uint16_t width = session.screen.width;

    if (!get_memory((size_t)width * session.screen.height))
        return TIA_ERR_MEMORY;
    struct tia_tile row = {0, (uint16_t)now.row, width, 1};
    int status = estimator->sample(seat.view, row, now.done, now.done + 1, now.sums + (size_t)now.row * width, width);
    if (status) {
        samples_reset(); /* the row's sums are undefined */
        return status;
    }
    if (++now.row == session.screen.height) {
        now.row = 0;
        now.done++;
        if (now.done == session.spp || web_clock.now_us(NULL) >= now.shown_us + SHOW_US)
            show();
    }
    return TIA_OK;
}
