/* calibration.c - the calibration of a light-field display: any bytes as visual.json and as the value of --lenticular.
 * Accepted values keep their limits. */
#include <string.h>

#include "common/lenticular.h"
#include "files.h"

static void must_be_lens(const struct lenticular *panel, int status)
{
    const struct tia_lenticular *lens = &panel->lens;

    if (status) {
        MUST(status == TIA_ERR_RANGE || status == TIA_ERR_DEVICE || status == TIA_ERR_MEMORY);
        MUST(*panel->why && memchr(panel->why, '\0', sizeof panel->why));
        return;
    }
    MUST(lens->pitch && llabs(lens->pitch) < TIA_PITCH_MAX && llabs(lens->rise) < TIA_PITCH_MAX);
    MUST(lens->subpixels <= TIA_SUBPIXELS_NONE);
    MUST(panel->width <= TIA_SIZE_MAX && panel->height <= TIA_SIZE_MAX && !panel->width == !panel->height);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct memory_file file;
    struct lenticular panel;
    char *text = malloc(size + 1);

    MUST(text);
    if (size)
        memcpy(text, data, size);
    text[size] = '\0';
    must_be_lens(&panel, lenticular_parse(&panel, text));
    free(text);
    memory_file_write(&file, data, size);
    memory_file_save(&file);
    must_be_lens(&panel, calibration_read(&panel, file.path));
    return 0;
}
