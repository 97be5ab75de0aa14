/* join_sums.h - adds files of summed samples, see common/image/sums.h. */
#ifndef TIA_JOIN_JOIN_SUMS_H
#define TIA_JOIN_JOIN_SUMS_H

#include "common/image/image.h"

#define SUMS_WHY 512

/* True if the file contains summed samples. */
bool is_sums(const char *path);

/* Adds the parts, whose samples must be consecutive. Writes a part if the format is IMAGE_PART, and
 * otherwise a picture, whose samples must begin with number 0. Returns 0; 1 if the file cannot be written; 2 if the
 * parts do not fit together, or not with the format. A failure has one line in `why`, SUMS_WHY
 * bytes. */
int join_sums(char *const *paths, unsigned count, const char *output, enum image_format format, char *why);

#endif
