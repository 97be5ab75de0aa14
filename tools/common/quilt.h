/* quilt.h - reads the names of quilts: NAME_qs8x6a0.75.png has 8 columns, 6 rows, and views of the aspect ratio
 * 0.75. */
#ifndef TOOLS_QUILT_H
#define TOOLS_QUILT_H

#include <tia/lightfield.h>

/* True if a file's name is that of a quilt; *aspect receives the aspect ratio of a view in thousandths, rounded
 * down. */
bool quilt_named(const char *path, struct tia_quilt *quilt, uint32_t *aspect);

/* Stores the default size of a quilt in pixels: views are 480 high, or less if the quilt would be too large. */
void quilt_size(const struct tia_quilt *quilt, uint32_t aspect, uint16_t *width, uint16_t *height);

#endif
