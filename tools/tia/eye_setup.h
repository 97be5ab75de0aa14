/* eye_setup.h - applies the options for the camera, see eye_options.h, to a scene. */
#ifndef TOOLS_TIA_EYE_SETUP_H
#define TOOLS_TIA_EYE_SETUP_H

#include "options.h"

/* Checks the options. EXIT_FINE, or EXIT_USAGE after an error message. */
int eye_check(const struct options *options);

/* Returns the change of the camera that the options ask for; NULL: none. */
const struct tia_camera_change *eye_change(const struct options *options);

/* Applies the options to options->scene, which was read with that change if it is from a file. Returns the exit status,
 * after an error message. */
int eye_load(struct options *options);

/* Converts a camera's lengths from one placement of the same file to another. */
void eye_carry(struct tia_camera *camera, const struct tia_placement *from, const struct tia_placement *to);

/* Reads the scene's file with the change that the options ask for. Returns the exit status, after an error message. */
int eye_open(struct options *options);

#endif
