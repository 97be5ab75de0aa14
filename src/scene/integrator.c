#include <stddef.h>
#include <tia/integrator.h>

#define NAMED(names, n) ((n) < sizeof names / sizeof *names ? names[n] : NULL)

const char *tia_integrator_name(unsigned integrator)
{
    static const char *const names[] = {"whitted", "ao", "path"};

    return NAMED(names, integrator);
}

const char *tia_tone_name(unsigned tone)
{
    static const char *const names[] = {NULL, "linear", "srgb"};

    return NAMED(names, tone);
}
