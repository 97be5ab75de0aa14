#include "panel.h"

#include <math.h>

/* Slack of comparisons, as in field_display.c: equal numbers compare as equal on every machine. */
#define SLACK 0x1p-24

void panel_init(struct panel *panel, const struct tia_lenticular *lens, unsigned width, unsigned height)
{
    *panel = (struct panel){.pitch = ldexp((double)lens->pitch, -40),
                            .rise = ldexp((double)lens->rise, -40),
                            .centre = ldexp((double)lens->centre, -40),
                            .subpixels = lens->subpixels,
                            .flipped = lens->flipped,
                            .inverted = lens->inverted,
                            .width = width,
                            .height = height};
}

/* Returns the number of a channel's subpixel in its pixel, 0 to 2, from the left of the shown picture. */
static unsigned third_of(const struct panel *panel, unsigned channel)
{
    unsigned stored = panel->subpixels == TIA_SUBPIXELS_BGR ? 2 - channel : channel;

    return panel->flipped ? 2 - stored : stored;
}

/* The subpixels of one colour in a row. All positions are in pixels from the left of the shown picture. */
struct row {
    double first, step; /* phase of the leftmost subpixel, and its step to the next */
    double target;      /* the eye's phase */
};

/* Returns the distance of subpixel i's phase from the eye's, modulo 1. */
static double apart(const struct row *row, double i)
{
    double phase = row->first + i * row->step - row->target;

    return fabs(phase - round(phase));
}

/* Returns the subpixel in first..last whose phase is nearest to the eye's; of equally near ones the first. The phases
 * equal the eye's at positions a lens apart, and first..last is at most a lens long. So the result is next to that one
 * of these positions which is nearest to the middle. If this position is outside first..last, the next one is outside,
 * too, and farther from the other end. */
static double nearest_of(const struct row *row, double first, double last)
{
    double middle = (first + last) / 2;
    double miss = row->first + middle * row->step - row->target;
    double meets = floor(middle - (miss - round(miss)) / row->step);
    double best = first;

    for (int i = 0; i < 2; i++) {
        double at = fmin(fmax(meets + i, first), last);
        if (apart(row, at) < apart(row, best) - SLACK)
            best = at;
    }
    return best;
}

int panel_column(const struct panel *panel, unsigned row, unsigned channel, double point, double phase)
{
    const struct panel *p = panel;
    bool whole = p->subpixels == TIA_SUBPIXELS_NONE;
    double third = whole ? 0 : third_of(p, channel) / 3.0;
    double middle = whole ? 0.5 : third + 1 / 6.0;
    double from_below = p->height - 1 - row + 0.5;
    double half = p->width / fabs(p->pitch) / 2;
    double first = fmax(ceil(point * p->width - half - middle - SLACK), 0);
    double last = fmin(floor(point * p->width + half - middle + SLACK), p->width - 1.0);
    struct row r = {.first = ((0.5 + third) * p->pitch + from_below * p->rise) / p->width - p->centre,
                    .step = p->pitch / p->width,
                    .target = p->inverted ? 1 - phase : phase};

    if (first > last)
        return -1;
    unsigned column = (unsigned)nearest_of(&r, first, last);
    return (int)(p->flipped ? p->width - 1 - column : column);
}
