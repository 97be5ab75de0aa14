/* camera_line.h - a camera as a line of a .tia file. */
#ifndef TOOLS_TIA_CAMERA_LINE_H
#define TOOLS_TIA_CAMERA_LINE_H

#include <tia/read.h>

#define CAMERA_LINE 400

/* Writes the statement `camera` for this camera, in the coordinates of its file. */
void camera_line(char line[CAMERA_LINE], const struct tia_camera *camera, const struct tia_placement *placement);

#endif
