#include "descriptor.h"

#include <fcntl.h>
#include <unistd.h>

int descriptor_open(const char *path, int access)
{
    return open(path, access | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

int descriptor_copy(int fd, int access)
{
    char name[64];
    int copy = ttyname_r(fd, name, sizeof name) == 0 ? descriptor_open(name, access) : -1;

    return copy >= 0 ? copy : fcntl(fd, F_DUPFD_CLOEXEC, 3);
}
