/* only_png.c - the name of the only format that a page writes, without the encoders of image.c. */
#include "common/image/image.h"

const char *image_format_name(enum image_format format)
{
    return format == IMAGE_PNG ? "png" : "";
}
