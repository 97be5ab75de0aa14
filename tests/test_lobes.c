/* A glossy lobe's reflectance and density against their formulas with the power by square roots, bit for bit. */
#include "check.h"
#include "random.h"
#include "render/path/scatter.h"

#define ROUNDS 20000

/* Returns (n + k)/2 of a power, see scatter.h. */
static num_length height(tia_q16 n, int k, num_unit power)
{
    return num_times(num_length_of(n + k * TIA_Q16_ONE) / 2, power);
}

static num_length any_part(void)
{
    return (num_length)(random_bits() >> (64 - 45));
}

/* Sets a surface that has a diffuse and a glossy lobe, and mirrors along z. */
static void set_surface(struct scatter *s, struct shading *surface, struct tia_material *material)
{
    *material = (struct tia_material){.exponent = TIA_Q16_ONE + (tia_q16)(random_bits() >> 34 >> random_bits() % 30)};
    *surface = (struct shading){.material = material};
    *s = (struct scatter){.surface = surface, .mirrored = {0, 0, NUM_UNIT_ONE}};
    s->below[2] = (uint32_t)random_bits() | 1;
    for (int c = 0; c < 3; c++) {
        surface->colour[c] = any_part();
        s->specular[c] = any_part();
    }
}

static bool is_same(struct num_density a, struct num_density b)
{
    return a.mantissa == b.mantissa && a.exponent == b.exponent;
}

TEST(lobes_have_the_bits_of_roots)
{
    unsigned long apart = 0;

    for (int i = 0; i < ROUNDS; i++) {
        struct tia_material material;
        struct shading surface;
        struct scatter s;
        num_length reflected[3];
        struct num_density density;
        set_surface(&s, &surface, &material);
        tia_q16 n = material.exponent;
        num_unit along = NUM_UNIT_ONE - (num_unit)random_short(62), cosine = (num_unit)random_short(62), off;
        num_unit power = num_power(along, n), near = num_power_near(along, n, &off);
        apart += height(n, 2, near) != height(n, 2, power);
        scatter_evaluate(&s, (struct num_dir){0, 0, along}, cosine, reflected, &density);
        for (int c = 0; c < 3; c++)
            CHECK_EQ(reflected[c], num_times(surface.colour[c], cosine) +
                                       num_times(num_product(s.specular[c], height(n, 2, power)), cosine));
        num_unit glossy = num_of_chance(s.below[2]), diffuse = NUM_UNIT_ONE - glossy;
        struct num_density flat = num_density_product(num_density_of_unit(diffuse), num_density_of_unit(cosine));
        struct num_density lobe = num_density_product(num_density_of_unit(glossy), num_density_of(height(n, 1, power)));
        CHECK(is_same(density, num_density_sum(flat, lobe)));
    }
    CHECK_MSG(apart > ROUNDS / 100, "the logarithm's power decides %lu heights alone", apart);
}

int main(void)
{
    RUN(lobes_have_the_bits_of_roots);
    return check_status();
}
