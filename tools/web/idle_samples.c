/* idle_samples.c - draws samples while the page is idle, and shows the picture as it improves.
 *
 * A part is one sample of each pixel of a few rows. This worker and its helpers (page_share.c) draw parts in turn, one
 * sample of the picture after the other. The sums are integers, so it does not matter who draws a part, and when it
 * arrives. If only parts are left that helpers have, this worker draws them too, and what arrives first counts. */
#include <stdlib.h>
#include <string.h>
#include <tia/tone.h>

#include "page.h"

#define EXPORT(name) __attribute__((export_name(name)))

enum {
    SHOW_US = 150000, /* time between two intermediate pictures */
    SLOW_US = 100000, /* time after which helpers are asked */
    ROWS = 4,         /* rows of a part */
    AWAY = 32         /* most parts that helpers have at a time */
};

/* Samples number `sample` of rows y .. y + count - 1, in the layout that the script reads. */
struct part {
    uint32_t y, count, sample;
};

static struct {
    struct tia_sum *sums;                /* of the picture's pixels */
    struct tia_sum *own_sums, *got_sums; /* of the part that this worker draws; of one that has arrived */
    uint32_t *counts;                    /* for each group of ROWS rows: the number of samples that its pixels have */
    bool ready;                          /* there is memory for this picture's sums */
    struct part next;                    /* begin of the next part that nobody has */
    struct part own;                     /* the part that this worker draws; count 0: none */
    uint32_t own_rows;                   /* rows of it that are drawn */
    struct part away[AWAY];              /* the parts that helpers have */
    unsigned away_count;
    uint32_t done, shown; /* number of samples that all pixels have; the same when a picture was last shown */
    uint64_t copied;      /* samples that helpers have drawn */
    uint64_t begun_us, shown_us;
    bool asked; /* helpers have been asked */
} now;

void samples_reset(void)
{
    now.next = now.own = (struct part){0, 0, 0};
    now.away_count = now.done = now.shown = 0;
    now.copied = 0;
    now.asked = now.ready = false;
    now.begun_us = now.shown_us = web_clock.now_us(NULL);
}

bool samples_left(void)
{
    return seat.view && session.spp > 1 && now.done < session.spp;
}

/* ---- sums ---- */

static bool get_memory(void)
{
    size_t width = session.screen.width, height = session.screen.height;

    free(now.sums);
    free(now.own_sums);
    free(now.got_sums);
    free(now.counts);
    now.sums = calloc(width * height, sizeof *now.sums);
    now.own_sums = malloc(ROWS * width * sizeof *now.own_sums);
    now.got_sums = malloc(ROWS * width * sizeof *now.got_sums);
    now.counts = calloc((height + ROWS - 1) / ROWS, sizeof *now.counts);
    return now.sums && now.own_sums && now.got_sums && now.counts;
}

int samples_sum(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums)
{
    const struct tia_estimator *estimator =
        session.settings.arithmetic == ARITHMETIC_F64 ? &tia_estimator_f64 : &tia_estimator_q16;

    memset(sums, 0, (size_t)tile.width * tile.height * sizeof *sums);
    return estimator->sample(view, tile, first, end, sums, tile.width);
}

/* Adds the sums of a part to those of the picture. */
static void add(const struct part *part, const struct tia_sum *sums)
{
    size_t width = session.screen.width, pixels = part->count * width;
    struct tia_sum *to = now.sums + part->y * width;
    uint32_t least = ++now.counts[part->y / ROWS];

    for (size_t i = 0; i < pixels; i++)
        for (unsigned c = 0; c < 3; c++)
            to[i].rgb[c] += sums[i].rgb[c];
    for (uint32_t i = 0; i * ROWS < session.screen.height; i++)
        least = now.counts[i] < least ? now.counts[i] : least;
    now.done = least;
}

/* ---- parts ---- */

/* Takes the next part that nobody has. Returns false if there is none. */
static bool take_next(struct part *part)
{
    uint32_t left = session.screen.height - now.next.y;

    if (now.next.sample == session.spp)
        return false;
    *part = (struct part){now.next.y, left < ROWS ? left : ROWS, now.next.sample};
    now.next.y += part->count;
    if (now.next.y == session.screen.height)
        now.next = (struct part){0, 0, now.next.sample + 1};
    return true;
}

/* Takes the next part for a helper. Returns NULL if there is none. */
EXPORT("web_part") const struct part *web_part(void);
const struct part *web_part(void)
{
    struct part *part = &now.away[now.away_count];

    return now.away_count < AWAY && take_next(part) ? &now.away[now.away_count++] : NULL;
}

/* Returns memory for the sums of a part. */
EXPORT("web_part_sums") struct tia_sum *web_part_sums(void);
struct tia_sum *web_part_sums(void)
{
    return now.got_sums;
}

/* Adds the sums in web_part_sums, unless this worker draws the part. */
EXPORT("web_part_done") void web_part_done(unsigned y, unsigned sample);
void web_part_done(unsigned y, unsigned sample)
{
    unsigned i = 0;

    while (i < now.away_count && (now.away[i].y != y || now.away[i].sample != sample))
        i++;
    if (i == now.away_count)
        return;
    add(&now.away[i], now.got_sums);
    now.copied += (uint64_t)now.away[i].count * session.screen.width;
    now.away_count--;
    memmove(&now.away[i], &now.away[i + 1], (now.away_count - i) * sizeof now.away[0]);
}

/* Draws a row of the part that this worker has, or of a new one. */
static int draw_row(void)
{
    uint16_t width = session.screen.width;

    if (!now.own.count) {
        now.own_rows = 0;
        if (!take_next(&now.own))
            now.own = now.away[--now.away_count];
    }
    const struct tia_tile row = {0, (uint16_t)(now.own.y + now.own_rows), width, 1};
    int status = samples_sum(seat.view, row, now.own.sample, now.own.sample + 1, now.own_sums + now.own_rows * width);
    if (status)
        return status;
    if (++now.own_rows == now.own.count) {
        add(&now.own, now.own_sums);
        now.own.count = 0;
    }
    return TIA_OK;
}

/* ---- pictures ---- */

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

/* Rows may have more samples than others, never fewer than now.done. */
bool samples_show(void)
{
    if (now.done == 0)
        return false;
    const struct tia_integration *how = &session.scene.integration;
    size_t width = session.screen.width, group = width * ROWS, pixels = width * session.screen.height;

    for (size_t i = 0; i < pixels; i++)
        session.screen.pixels[i] = samples_pixel(how, &now.sums[i], now.counts[i / group]);
    session.frame.samples = now.shown = now.done;
    session.frame.copied = (uint32_t)((now.copied << 16) / pixels / session.spp);
    if (now.done == session.spp)
        share_end();
    session_show();
    now.shown_us = web_clock.now_us(NULL);
    return true;
}

int samples_go_on(void)
{
    uint64_t now_us = web_clock.now_us(NULL);

    now.ready = now.ready || get_memory();
    if (!now.ready)
        return TIA_ERR_MEMORY;
    if (!now.asked && now_us >= now.begun_us + SLOW_US) {
        now.asked = true;
        share_samples();
    }
    int status = draw_row();
    if (!status && (now.done == session.spp || (now.done > now.shown && now_us >= now.shown_us + SHOW_US)))
        (void)samples_show();
    return status;
}
