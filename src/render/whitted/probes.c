/* probes.c - the means of noise and pictures over a footprint.
 *
 * Each place is averaged over a round part of the width w. Octaves of noise fade with w. A picture has the levels by
 * which its filter has the variance of the exact one. A level's texel is the mean of a^2 texels, with the variance
 * (a^2 - 1)/12, and is blended by a triangle of the variance a^2/6: together (3 a^2 - 1)/12. A box of width w over the
 * picture's own texels has w^2/12 + 1/12, or w^2/12 + 1/6 if they are blended. So
 *
 *     a^2 = (w^2 + 2)/3   or   (w^2 + 3)/3,
 *
 * where the level with a = w, often taken, is smoother than the box. Between the levels a = 2^n and 2^(n + 1), whose
 * variances are in the ratio 1 to 4, the blend is (a^2/4^n - 1)/3. */
#include "probes.h"

#include "render/trace/noise.h"
#include "render/trace/rgb.h"
#include "render/trace/texture.h"
#include "scene/picture.h"

/* The places: `count` of them, each `width` wide, from `first` on at the distance `step`, relative to the centre. */
struct probes {
    int count;
    num_length width, first[3], step[3];
};

#define PLACES 16 /* most of a picture */

/* Places up to `most` probes in a footprint whose edges are `longer` and `shorter` long, in units of the width. */
static struct probes probes_of(const struct print *p, int most, num_length longer, num_length shorter)
{
    struct probes at = {.count = 1};

    while (at.count < most && (num_length)at.count * shorter < longer)
        at.count++;
    num_length piece = longer / (num_length)at.count;
    at.width = piece > shorter ? piece : shorter;
    for (int k = 0; k < 3; k++) {
        at.step[k] = p->edge[0][k] / (num_length)at.count;
        at.first[k] = at.step[k] * (num_length)(1 - at.count) / 2;
    }
    return at;
}

bool mean_of_noise(const struct tia_texture *t, const struct print *p, num_length rgb[3])
{
    const num_length longer = print_length(p->edge[0]);
    const struct probes probes = probes_of(p, PIECES, longer, print_length(p->edge[1]));
    num_length sum = 0;

    if (longer < NUM_LENGTH_ONE / (num_length)(INT32_C(1) << t->octaves)) /* no octave fades */
        return false;
    for (int i = 0; i < probes.count; i++) {
        struct noise_place place;
        for (int k = 0; k < 3; k++) {
            place.cell[k] = p->cell[k];
            place.part[k] = p->part[k] + probes.first[k] + (num_length)i * probes.step[k];
        }
        noise_carry(&place);
        sum += num_length_clamp(noise_value(&place, t->octaves, probes.width), 0, NUM_LENGTH_ONE);
    }
    ray_rgb_blend(t->cells, sum / (num_length)probes.count, rgb);
    return true;
}

static bool has_next(const struct texels *level)
{
    return level->width > 1 || level->height > 1;
}

/* Goes to the next level of a picture; a level is halved as in tia/mip.h. */
static void next_level(const struct tia_texture *t, struct texels *level)
{
    const uint8_t *behind = level->first + level->channels * (size_t)level->width * (size_t)level->height;

    level->first = level->first == t->texels ? t->mip_levels : behind;
    level->width = (int32_t)picture_half((uint32_t)level->width);
    level->height = (int32_t)picture_half((uint32_t)level->height);
}

/* Moves a position between the centres of two texels away from the edge between them, so that a blend of the texels is
 * the mean of a box of this width over them. */
static num_length sharpened(num_length x, num_length width)
{
    num_length whole = num_integer(num_floor(x));
    num_length part = num_ratio(x - whole - NUM_LENGTH_ONE / 2, width) + NUM_LENGTH_ONE / 2;

    return whole + num_length_clamp(part, 0, NUM_LENGTH_ONE);
}

/* Looks up one level at a position in the picture, 0..1. */
static void look_up(const struct texels *level, const num_length at[2], num_length sharp, num_length value[3])
{
    num_length u = at[0] * (num_length)level->width - NUM_LENGTH_ONE / 2;
    num_length v = at[1] * (num_length)level->height - NUM_LENGTH_ONE / 2;

    if (sharp < NUM_LENGTH_ONE) {
        u = sharpened(u, sharp);
        v = sharpened(v, sharp);
    }
    texture_blend(level, u, v, value);
}

/* Computes the mean over a round part, `width` texels wide. */
static void mean_around(const struct tia_texture *t, const num_length at[2], num_length width, num_length value[3])
{
    const num_length sharp = t->bilinear || width >= NUM_LENGTH_ONE ? NUM_LENGTH_ONE : width;
    struct texels level = texture_texels(t);
    num_length more[3], own = (t->bilinear ? 3 : 2) * NUM_LENGTH_ONE;

    for (; width >= 8 * NUM_LENGTH_ONE && has_next(&level); width /= 2, own /= 4)
        next_level(t, &level);
    num_length area = (num_product(width, width) + own) / 3;
    for (; area >= 4 * NUM_LENGTH_ONE && has_next(&level); area /= 4)
        next_level(t, &level);
    look_up(&level, at, sharp, value);
    if (area <= NUM_LENGTH_ONE || !has_next(&level))
        return;
    next_level(t, &level);
    look_up(&level, at, NUM_LENGTH_ONE, more);
    for (unsigned c = 0; c < level.channels; c++)
        value[c] += num_product(more[c] - value[c], (area - NUM_LENGTH_ONE) / 3);
}

#define POINT (NUM_LENGTH_ONE / 8) /* a shorter footprint is its centre */
#define WHOLE (4 * NUM_LENGTH_ONE) /* a footprint of more pictures sees their mean */

/* Returns an edge's length in texels. */
static num_length texels_long(const struct tia_texture *t, const num_length edge[3])
{
    return num_norm3(num_length_clamp(edge[0], -WHOLE, WHOLE) * t->width,
                     num_length_clamp(edge[1], -WHOLE, WHOLE) * t->height, 0);
}

bool mean_of_picture(const struct tia_texture *t, const struct print *p, num_length value[3])
{
    const num_length edge[2] = {texels_long(t, p->edge[0]), texels_long(t, p->edge[1])};
    const int first = edge[1] > edge[0]; /* in texels, the other edge may be the longer one */
    const struct print turned = {.edge = {{p->edge[first][0], p->edge[first][1], 0}}};
    const struct probes probes = probes_of(&turned, PLACES, edge[first], edge[!first]);
    const uint32_t channels = texture_texels(t).channels;

    if (t->bilinear && edge[first] < POINT)
        return false;
    for (unsigned c = 0; c < channels; c++)
        value[c] = 0;
    for (int i = 0; i < probes.count; i++) {
        num_length at[2], one[3];
        for (int k = 0; k < 2; k++) {
            at[k] = p->part[k] + probes.first[k] + (num_length)i * probes.step[k];
            at[k] -= num_integer(num_floor(at[k]));
        }
        mean_around(t, at, probes.width, one);
        for (unsigned c = 0; c < channels; c++)
            value[c] += one[c] / (num_length)probes.count;
    }
    return true;
}
