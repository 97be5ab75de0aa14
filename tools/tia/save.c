#include "save.h"

#include <stdio.h>
#include <unistd.h>

enum { NUMBERS = 9999 };

int save_picture(const struct letterbox *letterbox, const char *path, enum image_format format, char *why)
{
    const unsigned width = letterbox->place.width, height = letterbox->place.height;
    struct image *image = image_create(path, format, width, height, why);

    if (!image)
        return TIA_ERR_DEVICE;
    bool up = image_bottom_up(image);
    for (unsigned i = 0; i < height; i++)
        (void)image_band(image, letterbox->frame + (size_t)(up ? height - 1 - i : i) * width, 1);
    return image_finish(image);
}

int save_numbered(const struct letterbox *letterbox, unsigned *number, char text[PORT_WHY])
{
    enum image_format format = image_format_built(IMAGE_PNG) ? IMAGE_PNG : IMAGE_PPM;
    char path[32], why[PORT_WHY] = "";

    do
        (void)snprintf(path, sizeof path, "tia-%04u.%s", ++*number, image_format_name(format));
    while (access(path, F_OK) == 0 && *number < NUMBERS);
    int status = save_picture(letterbox, path, format, why);
    if (status)
        (void)snprintf(text, PORT_WHY, "%.200s", why);
    else
        (void)snprintf(text, PORT_WHY, "saved %s", path);
    return status;
}
