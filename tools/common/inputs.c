#include "inputs.h"

#include <stdlib.h>

struct input {
    dev_t device;
    ino_t inode;
};

static struct input *inputs;
static size_t count;

bool inputs_have(const struct stat *status)
{
    for (size_t i = 0; i < count; i++)
        if (inputs[i].device == status->st_dev && inputs[i].inode == status->st_ino)
            return true;
    return false;
}

void inputs_add(const struct stat *status)
{
    if (inputs_have(status))
        return;
    struct input *more = realloc(inputs, (count + 1) * sizeof *more);
    if (!more)
        return;
    inputs = more;
    inputs[count++] = (struct input){status->st_dev, status->st_ino};
}
