/* lightfield_options.h - the options for light-field displays. */
#ifndef TOOLS_TIA_LIGHTFIELD_OPTIONS_H
#define TOOLS_TIA_LIGHTFIELD_OPTIONS_H

#include <tia/lightfield.h>

struct light_options {
    const char *lenticular, *calibration, *modules; /* NULL: not given */
    uint32_t views;                                 /* 0: not given */
    bool module_range;

    struct tia_light_field field;
    bool has_field;
    uint32_t pictures;      /* number of pictures, one per view or module; 0: a single picture */
    tia_q16 spacing;        /* spacing of modules */
    uint16_t width, height; /* panel size of the calibration */
};

#endif
