#include <stddef.h>
#include <tia/shadow.h>

#define NAMED(names, n) ((n) < sizeof names / sizeof *names ? names[n] : NULL)

const char *tia_shadows_name(unsigned technique)
{
    static const char *const names[] = {"traced", "rays", "zpass", "zfail", "map", "map-exact", "zpass-plain"};

    return NAMED(names, technique);
}

const char *tia_bias_name(unsigned bias)
{
    static const char *const names[] = {NULL, "none", "constant", "slope", "normal", "plane"};

    return NAMED(names, bias);
}

const char *tia_filter_name(unsigned filter)
{
    static const char *const names[] = {NULL, "none", "bilinear", "3x3", "5x5", "7x7", "poisson", "pcss"};

    return NAMED(names, filter);
}
