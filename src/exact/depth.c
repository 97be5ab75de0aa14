/* depth.c - K = height cot(fov/2), the distance of the picture plane in half pixels, by power series. */
#include "picture.h"

/* 2^518 pi/360, rounded down, the highest word first. */
static const uint32_t half_degree[16] = {0x8efa3512u, 0x94e9c8aeu, 0x0ec5f66eu, 0x9485c4d9u, 0x00b7aef5u, 0x01b5e6b8u,
                                         0xe502a9b4u, 0xc94c8512u, 0xb6f61167u, 0x81911487u, 0x10c50c96u, 0x9d5140c9u,
                                         0x60d4a6b4u, 0x9598f1eeu, 0x71b1370fu, 0x3cabeadcu};

/* Returns 2^e as a radius. */
static struct ball_radius radius_of_bit(int e)
{
    return (struct ball_radius){UINT32_C(1) << 14, e - 14};
}

/* Sets r to the sum of a series, times count!, computed from its last term on: 1 - x^2/3! + x^4/5! - ..., up to the
 * term x^(count - 1)/count!, if `count` is odd, else 1 - x^2/2! + x^4/4! - ..., up to x^count/count!. The terms
 * alternate and shrink: for 0 < x < 1.57 the sum of the omitted ones is below the last bit of r. */
static void series(int n, struct ball *r, const struct ball *square, int count)
{
    struct ball scale, factor;

    tia_ball_set(n, r, 1, 0);
    scale = *r;
    for (; count > 1; count -= 2) {
        tia_ball_set(n, &factor, (int64_t)count * (count - 1), 0);
        tia_ball_mul(n, &scale, &scale, &factor);
        tia_ball_mul(n, r, r, square);
        tia_ball_sub(n, r, &scale, r);
    }
    factor.sign = 0;
    factor.radius = radius_of_bit(r->e);
    tia_ball_add(n, r, r, &factor);
}

/* Computes height (count + 1) c/(x s), where c = count! cos(x) and s = (count + 1)! sin(x)/x are the sums of the
 * series. */
void tia_ball_depth(int words, struct ball *r, uint32_t height, int32_t fov)
{
    struct ball x, p, cosine;
    int count = 6 * words + 16;

    tia_ball_set(words, r, height, 0);
    if (fov == INT32_C(90) << 16) /* cot(45 degrees) is 1; all others are irrational, by Niven's theorem */
        return;
    for (int i = 0; i < words; i++)
        x.m[i] = half_degree[words - 1 - i];
    x.sign = 1;
    x.e = -6 - 32 * words;
    x.radius = radius_of_bit(x.e);
    tia_ball_set(words, &p, fov, -16);
    tia_ball_mul(words, &x, &x, &p);
    tia_ball_mul(words, &p, &x, &x);
    series(words, &cosine, &p, count);
    tia_ball_mul(words, r, r, &cosine);
    series(words, &cosine, &p, count + 1);
    tia_ball_mul(words, &x, &x, &cosine);
    tia_ball_set(words, &p, count + 1, 0);
    tia_ball_mul(words, r, r, &p);
    tia_ball_div(words, r, r, &x);
}

void tia_exact_depth(struct exact_depth *depth, uint32_t height, tia_q16 fov)
{
    struct ball k;

    tia_ball_depth(4, &k, height, fov);
    tia_ball_convert(2, &k, 4, &k);
    *depth = (struct exact_depth){{k.m[0], k.m[1]}, k.e, k.radius};
}
