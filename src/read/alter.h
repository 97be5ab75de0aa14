/* alter.h - a file's camera, changed by the caller. */
#ifndef TIA_READ_ALTER_H
#define TIA_READ_ALTER_H

#include <tia/read.h>

#include "text/length.h"

/* Applies reader->camera, if any, to a camera whose lengths are in the unit of `lengths`; before the last pass,
 * measures the lengths. */
void tia_alter_measured(const struct tia_reader *reader, struct tia_camera *camera, struct tia_lengths *lengths);

#endif
