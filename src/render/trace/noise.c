#include "noise.h"

static uint32_t hash(const uint32_t corner[3], uint32_t octave)
{
    uint32_t h = UINT32_C(0x9e3779b1) * corner[0] + UINT32_C(0x85ebca77) * corner[1] +
                 UINT32_C(0xc2b2ae3d) * corner[2] + UINT32_C(0x27d4eb2f) * octave;

    h = (h ^ h >> 16) * UINT32_C(0x21f0aaad);
    h = (h ^ h >> 15) * UINT32_C(0x735a2d97);
    return h ^ h >> 15;
}

/* Returns the product of a corner's gradient and the vector from the corner. */
static num_length contribution(uint32_t h, const num_length from[3])
{
    unsigned edge = (unsigned)((h >> 16) * 12 >> 16);
    num_length a = from[edge < 4 ? 1 : 0], b = from[edge < 8 ? 2 : 1];

    return (edge & 1 ? -a : a) + (edge & 2 ? -b : b);
}

/* Returns t^3 (t (6 t - 15) + 10). */
static num_length fade(num_length t)
{
    num_length square = num_product(t, t);

    return num_product(num_product(square, t), 6 * square - 15 * t + 10 * NUM_LENGTH_ONE);
}

static num_length octave_value(const struct noise_place *p, uint32_t octave)
{
    num_length value[8];

    for (int i = 0; i < 8; i++) {
        uint32_t corner[3];
        num_length from[3];
        for (int k = 0; k < 3; k++) {
            int beyond = i >> k & 1;
            corner[k] = ((uint32_t)p->cell[k] + (uint32_t)beyond) & INT32_MAX;
            from[k] = p->part[k] - (num_length)beyond * NUM_LENGTH_ONE;
        }
        value[i] = contribution(hash(corner, octave), from);
    }
    for (int k = 0, pairs = 4; k < 3; k++, pairs /= 2) {
        num_length part = fade(p->part[k]);
        for (int i = 0; i < pairs; i++)
            value[i] = value[2 * i] + num_product(value[2 * i + 1] - value[2 * i], part);
    }
    return value[0];
}

/* Returns the part of an octave that is left of its mean over `width`, in units of the octave. */
static num_length left_over(num_length width)
{
    return num_length_clamp(2 * (NUM_LENGTH_ONE - width), 0, NUM_LENGTH_ONE);
}

/* Doubles the place: the next octave. */
static void next_octave(struct noise_place *p)
{
    for (int k = 0; k < 3; k++) {
        p->cell[k] = (int32_t)(2 * (uint32_t)p->cell[k] & INT32_MAX);
        p->part[k] *= 2;
    }
    noise_carry(p);
}

num_length noise_value(const struct noise_place *place, unsigned octaves, num_length width)
{
    struct noise_place at = *place;
    num_length sum = 0, left;

    for (unsigned i = 0; i < octaves && (left = left_over(width)) > 0; i++) {
        num_length value = octave_value(&at, i);
        sum += (left < NUM_LENGTH_ONE ? num_product(value, left) : value) / (num_length)(INT32_C(1) << i);
        width *= 2;
        next_octave(&at);
    }
    return NUM_LENGTH_ONE / 2 + 3 * sum / 4;
}
