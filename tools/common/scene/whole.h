/* whole.h - a file whole in memory. */
#ifndef PORT_SCENE_WHOLE_H
#define PORT_SCENE_WHOLE_H

#include <tia/fixed.h>

struct whole {
    char *bytes; /* free() it */
    size_t length;
};

/* Reads the regular file `path`; anything else, which might block or never end, is refused. At most `most`
 * bytes. TIA_ERR_DEVICE (it cannot be opened or read), TIA_ERR_RANGE (it is too large), TIA_ERR_MEMORY; and
 * *why, a string that stays. */
int whole_read(struct whole *whole, const char *path, size_t most, const char **why);

/* The same for an open descriptor of any kind, from where it stands. */
int whole_read_from(struct whole *whole, int fd, size_t most, const char **why);

#endif
