/* eye_options.h - the options for the camera: --eye, --look, --up, --fov, --orthographic and --fit. */
#ifndef TOOLS_TIA_EYE_OPTIONS_H
#define TOOLS_TIA_EYE_OPTIONS_H

#include <tia/read.h>

struct eye_options {
    struct tia_camera_change change;
    bool fit;
};

#endif
