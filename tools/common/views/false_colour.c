#include "false_colour.h"

#include <math.h>

#include "common/views/palette.h"

void seen_ray(void *ctx, const struct tia_traced *traced)
{
    struct seen *seen = ctx;

    seen->rays++;
    if (traced->ray == TIA_RAY_SHADOW) {
        uint32_t n = traced->light < 31 ? traced->light : 31;
        if (seen->direct && traced->arrives)
            seen->lights |= UINT32_C(1) << n;
        return;
    }
    seen->direct = traced->ray == TIA_RAY_PRIMARY && seen->primaries == 0;
    if (seen->direct)
        seen->first = *traced;
    seen->primaries += traced->ray == TIA_RAY_PRIMARY;
}

static double channel(uint32_t lights, int c)
{
    static const int shift[3] = {11, 5, 0}, most[3] = {31, 63, 31};
    double sum = 0;

    for (uint32_t n = 0; n < 32; n++)
        if (lights >> n & 1)
            sum += (palette_number(n) >> shift[c] & most[c]) / (double)most[c];
    return sum;
}

tia_rgb565 seen_lights(uint32_t lights)
{
    return palette_rgb(channel(lights, 0), channel(lights, 1), channel(lights, 2));
}

/* Returns the colour of a count: 1..4096 on a logarithmic scale. */
static tia_rgb565 count_colour(uint32_t count)
{
    return palette_heat(count > 0 ? log2(count) / 12 : 0);
}

tia_rgb565 seen_colour(const struct seen *seen, enum view view, uint32_t tests, double scale)
{
    const struct tia_traced *first = &seen->first;
    double depth = first->length / 65536.0;
    bool nothing = seen->primaries == 0 || first->length == INT32_MAX;

    if (view == VIEW_COST)
        return count_colour(tests);
    if (view == VIEW_PATH)
        return count_colour(seen->rays);
    if (nothing)
        return 0;
    if (view == VIEW_DEPTH)
        return palette_heat(scale / (depth + scale));
    if (first->object == TIA_NO_OBJECT) /* the first hit is a light itself */
        return 0xffff;
    if (view == VIEW_NORMAL)
        return palette_rgb((first->normal.x / 65536.0 + 1) / 2, (first->normal.y / 65536.0 + 1) / 2,
                           (first->normal.z / 65536.0 + 1) / 2);
    return view == VIEW_OBJECT ? palette_number(first->object) : seen_lights(seen->lights);
}
