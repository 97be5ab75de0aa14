#include "surface.h"

#include "math/integer.h"

tia_q30 tia_q30_product(tia_q30 a, tia_q30 b)
{
    int64_t product = tia_round_shift((int64_t)a * b, 30);
    return product > INT32_MAX ? INT32_MAX : (tia_q30)product;
}

struct tia_rgb tia_rgb_product(struct tia_rgb colour, tia_q30 by)
{
    return (struct tia_rgb){tia_q30_product(colour.r, by), tia_q30_product(colour.g, by),
                            tia_q30_product(colour.b, by)};
}

int tia_text_exponent(struct tia_text *t, tia_q16 *out)
{
    struct tia_text before = *t;
    int64_t wide;
    int status = tia_text_q32(t, &wide);

    *out = TIA_EXPONENT_MAX;
    if (status || wide >= (int64_t)TIA_EXPONENT_MAX << 16)
        return status;
    *t = before;
    return tia_text_q16(t, out);
}

void tia_set_highlight(struct tia_material *material, struct tia_rgb specular, tia_q16 exponent)
{
    material->specular = exponent ? specular : tia_grey(0);
    material->exponent = exponent >= 0 && exponent < TIA_Q16_ONE ? TIA_Q16_ONE : exponent;
}
