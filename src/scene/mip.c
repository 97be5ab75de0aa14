/* mip.c - the levels of a picture, each the means of the one before. */
#include <tia/mip.h>

#include "picture.h"

/* A level: its texels of one or three channels. */
struct level {
    const uint8_t *texels;
    uint32_t width, height, channels;
};

size_t tia_mip_size(const struct tia_texture *t)
{
    uint32_t width = t->width, height = t->height;
    uint64_t size = 0;

    while (width > 1 || height > 1) {
        width = picture_half(width);
        height = picture_half(height);
        size += (uint64_t)picture_channels(t) * width * height;
    }
    return size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

/* The texels of a level's side that texel i of the next one covers: those from `first` to `last`, measured in units in
 * which a texel of this level is `next` long, and one of the next is `side` long. */
struct cover {
    uint32_t first, last, from, to, next;
};

static struct cover cover_of(uint32_t side, uint32_t next, uint32_t i)
{
    struct cover c = {.from = i * side, .to = (i + 1) * side, .next = next};

    c.first = c.from / next;
    c.last = (c.to - 1) / next;
    return c;
}

/* Returns the length of the part of texel n that is covered. */
static uint32_t covered(const struct cover *c, uint32_t n)
{
    uint32_t from = n * c->next, to = from + c->next;

    return (to < c->to ? to : c->to) - (from > c->from ? from : c->from);
}

/* Returns the mean of a channel. Weights sum up to the area of the level, at most 2^28. */
static uint8_t mean(const struct level *l, const struct cover *x, const struct cover *y, uint32_t channel)
{
    uint64_t sum = 0, area = (uint64_t)l->width * l->height;

    for (uint32_t j = y->first; j <= y->last; j++) {
        const uint8_t *row = l->texels + (size_t)l->channels * l->width * j + channel;
        uint64_t part = 0;
        for (uint32_t i = x->first; i <= x->last; i++)
            part += (uint64_t)covered(x, i) * row[(size_t)l->channels * i];
        sum += part * covered(y, j);
    }
    return (uint8_t)((sum + area / 2) / area);
}

void tia_mip_build(const struct tia_texture *t, uint8_t *levels)
{
    struct level l = {t->texels, t->width, t->height, picture_channels(t)};

    while (l.width > 1 || l.height > 1) {
        const uint32_t width = picture_half(l.width), height = picture_half(l.height);
        uint8_t *to = levels;
        for (uint32_t y = 0; y < height; y++) {
            const struct cover down = cover_of(l.height, height, y);
            for (uint32_t x = 0; x < width; x++) {
                const struct cover across = cover_of(l.width, width, x);
                for (uint32_t c = 0; c < l.channels; c++)
                    *to++ = mean(&l, &across, &down, c);
            }
        }
        l = (struct level){levels, width, height, l.channels};
        levels = to;
    }
}
