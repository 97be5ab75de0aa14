/* read_tia.c - any bytes as a .tia file: an error with a text, or a scene that tia_scene_check accepts, in
 * exactly the memory that was asked for. */
#include <stdio.h>

#include "bytes.h"

static const uint8_t texels[12];

static int fetch(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)ctx;
    if (*name == 'x') {
        *why = "no such file";
        return TIA_ERR_DEVICE;
    }
    texture->width = texture->height = 2;
    texture->texels = texels;
    return TIA_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct tia_reader reader = {.text = (const char *)data, .length = size, .image = size % 16 ? fetch : NULL};
    struct tia_scene scene;
    void *memory = NULL;
    size_t need = 1, again = 1;
    int status = tia_read(&reader, &scene, NULL, 0, &need);

    if (status == TIA_ERR_MEMORY) {
        MUST(need > 0 && need < 100 * size + 1000);
        memory = malloc(need);
        MUST(tia_read(&reader, &scene, memory, need - 1, &again) == TIA_ERR_MEMORY && again == need);
        status = tia_read(&reader, &scene, memory, need, &again);
        MUST(again == need);
    }
    if (status == TIA_OK)
        MUST(tia_scene_check(&scene, NULL) == TIA_OK);
    else
        MUST(status == TIA_ERR_RANGE && *reader.error.text && reader.error.line <= size + 1 &&
             reader.error.column <= size + 1);
    free(memory);
    return 0;
}
