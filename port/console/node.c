#include "node.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *node_error(int error, char text[PORT_WHY])
{
    (void)snprintf(text, PORT_WHY, "%s", strerror(error));
    text[0] = (char)tolower((unsigned char)text[0]);
    return text;
}

/* Writes the remedy for missing permission to open the node: joining its group, if the group may read the node, else
 * running as root. */
static void fix(const char *path, char text[64])
{
    char buffer[1024];
    struct group entry, *group = NULL;
    struct stat s;

    (void)snprintf(text, 64, " (run as root)");
    if (stat(path, &s) != 0 || s.st_gid == 0 || (s.st_mode & S_IRGRP) == 0)
        return;
    if (getgrgid_r(s.st_gid, &entry, buffer, sizeof buffer, &group) == 0 && group)
        (void)snprintf(text, 64, " (join group '%.40s')", group->gr_name);
    else
        (void)snprintf(text, 64, " (join group %u)", (unsigned)s.st_gid);
}

int node_open(const char *path, int flags, char why[PORT_WHY])
{
    int fd = open(path, flags | O_CLOEXEC), error = errno;
    char reason[PORT_WHY], help[64] = "";

    if (fd >= 0)
        return fd;
    if (error == EACCES)
        fix(path, help);
    (void)snprintf(why, PORT_WHY, "%.80s: %.80s%s", path, node_error(error, reason), help);
    return -1;
}

int node_each(const char *prefix, int limit, bool (*visit)(void *arg, const char *path), void *arg)
{
    char path[64];
    struct stat s;
    int visited = 0;

    for (int i = 0; i < limit; i++) {
        (void)snprintf(path, sizeof path, "%.50s%d", prefix, i);
        if (stat(path, &s) != 0)
            continue;
        visited++;
        if (visit(arg, path))
            break;
    }
    return visited;
}

/* True if the process holds the device open. */
static bool holds(long pid, dev_t device)
{
    char path[64];
    struct dirent *entry;
    struct stat s;
    bool found = false;
    DIR *folder;

    (void)snprintf(path, sizeof path, "/proc/%ld/fd", pid);
    folder = opendir(path);
    if (!folder)
        return false;
    while (!found && (entry = readdir(folder)) != NULL)
        found = fstatat(dirfd(folder), entry->d_name, &s, 0) == 0 && S_ISCHR(s.st_mode) && s.st_rdev == device;
    (void)closedir(folder);
    return found;
}

static void name_of(long pid, char text[NODE_HOLDER])
{
    char path[64], name[32] = "";
    FILE *file;

    (void)snprintf(path, sizeof path, "/proc/%ld/comm", pid);
    file = fopen(path, "re");
    if (file) {
        if (fscanf(file, "%31[^\n]", name) != 1)
            name[0] = '\0';
        (void)fclose(file);
    }
    (void)snprintf(text, NODE_HOLDER, "%.20s (pid %ld)", name[0] != '\0' ? name : "a program", pid);
}

const char *node_holder(const char *path, char text[NODE_HOLDER])
{
    struct dirent *entry;
    struct stat s;
    DIR *processes = opendir("/proc");

    (void)snprintf(text, NODE_HOLDER, "another program");
    while (stat(path, &s) == 0 && processes && (entry = readdir(processes)) != NULL) {
        long pid = strtol(entry->d_name, NULL, 10);
        if (pid > 0 && pid != getpid() && holds(pid, s.st_rdev)) {
            name_of(pid, text);
            break;
        }
    }
    if (processes)
        (void)closedir(processes);
    return text;
}
