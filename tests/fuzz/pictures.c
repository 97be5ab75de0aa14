/* pictures.c - files of other programs: pictures for textures, and the first lines of parts of films. Accepted values
 * keep their limits. */
#include <stdio.h>

#include "bytes.h"
#include "common/image/decode.h"
#include "common/image/part.h"

#define SIDE 50
#define MOST 5000

static void must_decode(const uint8_t *data, size_t size)
{
    struct image_texels texels = {0, 0, NULL, NULL};
    const char *why = NULL;
    uint32_t sum = 0;

    if (image_decode(&texels, data, size, SIDE, MOST, &why)) {
        MUST(why && *why && !texels.rgb && !texels.alpha);
        return;
    }
    MUST(texels.width >= 1 && texels.width <= SIDE && texels.height >= 1 && texels.height <= SIDE);
    MUST(texels.width * texels.height * 3 <= MOST);
    for (unsigned i = 0; i < texels.width * texels.height * 3; i++)
        sum += texels.rgb[i];
    MUST(sum <= 255 * MOST);
    image_channel(&texels, (enum tia_channel)(data[size - 1] % TIA_CHANNELS));
    MUST(!texels.rgb);
    for (unsigned i = 0; i < texels.width * texels.height; i++)
        sum += texels.alpha[i];
    MUST(sum <= 255 * 2 * MOST);
    image_free(&texels);
}

static void must_be_whole(const struct image_film *film, size_t line, size_t size)
{
    MUST(line <= size && film->width >= 1 && film->width <= TIA_SIZE_MAX && film->height <= TIA_SIZE_MAX);
    MUST(film->rows >= 1 && film->first_row + film->rows <= film->height && film->rate[0] && film->rate[1]);
    MUST(film->frames >= 1 && (uint64_t)film->first_frame + film->frames <= film->all_frames);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct image_film film;
    size_t line;

    must_decode(data, size);
    line = image_part_parse(&film, (const char *)data, size);
    if (line)
        must_be_whole(&film, line, size);
    line = image_y4m_parse(&film, (const char *)data, size);
    if (line)
        must_be_whole(&film, line, size);
    return 0;
}
