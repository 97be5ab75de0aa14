#include "unused.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

enum { NUMBERS = 9999 };

/* Removes the file unless a complete picture has replaced it; may run in a signal's handler. */
static void remove_empty(void *arg)
{
    const struct unused *unused = arg;
    struct stat status;

    if (stat(unused->path, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0)
        (void)unlink(unused->path);
}

static bool create(struct unused *unused)
{
    int fd = open(unused->path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);

    if (fd >= 0)
        (void)close(fd);
    return fd >= 0;
}

bool unused_create(struct unused *unused, const char *extension)
{
    bool created;
    unsigned number = 0;

    *unused = (struct unused){.cleanup = {.undo = remove_empty, .arg = unused}};
    (void)snprintf(unused->path, sizeof unused->path, "tia.%s", extension);
    signals_hold();
    while (!(created = create(unused)) && errno == EEXIST && number < NUMBERS)
        (void)snprintf(unused->path, sizeof unused->path, "tia-%u.%s", ++number, extension);
    if (created)
        signals_add(&unused->cleanup);
    signals_allow();
    return created;
}

void unused_end(struct unused *unused)
{
    signals_remove(&unused->cleanup);
    remove_empty(unused);
}
