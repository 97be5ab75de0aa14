/* whole_file.c - common/scene/whole_file.h without a file system: files come from the page. */
#include "common/scene/whole_file.h"

#include <stdlib.h>
#include <string.h>

#include "web/web.h"

int whole_read(struct whole *whole, const char *path, size_t most, const char **why)
{
    uint32_t name = (uint32_t)strlen(path);
    int32_t size = web_file_size(path, name);

    *whole = (struct whole){NULL, 0};
    if (size < 0 || (size_t)size > most) {
        *why = size < 0 ? "not among this page's files" : "too large";
        return size < 0 ? TIA_ERR_DEVICE : TIA_ERR_RANGE;
    }
    whole->bytes = malloc((size_t)size + 1);
    if (!whole->bytes) {
        *why = "memory: exhausted";
        return TIA_ERR_MEMORY;
    }
    whole->length = (size_t)size;
    web_file_read(path, name, whole->bytes);
    return TIA_OK;
}

int whole_read_from(struct whole *whole, int fd, size_t most, const char **why)
{
    (void)fd;
    (void)most;
    *whole = (struct whole){NULL, 0};
    *why = "no standard input";
    return TIA_ERR_DEVICE;
}
