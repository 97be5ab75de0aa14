/* noise.c - gradient noise in double precision, from the formulas of tia/material.h. */
#include "rays.h"

static uint32_t hash(int64_t x, int64_t y, int64_t z, uint32_t octave)
{
    const uint64_t modulo = UINT64_C(1) << 31;
    uint64_t h = (uint64_t)x % modulo * 0x9e3779b1 + (uint64_t)y % modulo * 0x85ebca77 +
                 (uint64_t)z % modulo * 0xc2b2ae3d + octave * UINT64_C(0x27d4eb2f);

    h &= UINT32_MAX;
    h = ((h ^ h / 65536) * 0x21f0aaad) & UINT32_MAX;
    h = ((h ^ h / 32768) * 0x735a2d97) & UINT32_MAX;
    return (uint32_t)(h ^ h / 32768);
}

/* The twelve gradients of "Improving noise", in the order of tia/material.h. */
static const struct oracle_vec gradients[12] = {{0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1},
                                                {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
                                                {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};

static double fade(double t)
{
    return 6 * pow(t, 5) - 15 * pow(t, 4) + 10 * pow(t, 3);
}

double oracle_octave(struct oracle_vec p, uint32_t octave)
{
    double sum = 0;

    for (int i = 0; i < 8; i++) {
        const struct oracle_vec c = {floor(p.x) + (i & 1), floor(p.y) + (i / 2 & 1), floor(p.z) + (i / 4)};
        const struct oracle_vec from = sub(p, c);
        uint32_t h = hash((int64_t)c.x, (int64_t)c.y, (int64_t)c.z, octave);
        double weight = fade(1 - fabs(from.x)) * fade(1 - fabs(from.y)) * fade(1 - fabs(from.z));
        sum += weight * dot(gradients[(uint64_t)(h / 65536) * 12 / 65536], from);
    }
    return sum;
}

double oracle_noise(const struct tia_texture *texture, struct oracle_vec p)
{
    const double repeat = ldexp(1, -texture->repeat_bits), offset = ldexp(1, -texture->offset_bits);
    const double across = q16(texture->repeat[0]) * repeat, up = q16(texture->repeat[1]) * repeat;
    double sum = 0;

    p = (struct oracle_vec){across * (p.x - q16(texture->offset[0]) * offset),
                            up * (p.y - q16(texture->offset[1]) * offset), across * p.z};
    for (int i = 0; i < texture->octaves; i++)
        sum += ldexp(oracle_octave(scaled(p, ldexp(1, i)), (uint32_t)i), -i);
    return 0.5 + 0.75 * sum;
}
