/* file_watch.h - finds out when a file of the scene has changed, for --watch. A file counts as changed when a program
 * closes it after writing, or when another file gets its name, as with editors that write a copy first. */
#ifndef TOOLS_TIA_FILE_WATCH_H
#define TOOLS_TIA_FILE_WATCH_H

#include <stdbool.h>
#include <stddef.h>

struct watched_file; /* a name in a folder */

/* All zero: closed. */
struct file_watch {
    bool is_open;
    int fd;
    unsigned round; /* number of the last reading of the scene */
    struct watched_file *files;
    size_t count, room;
};

/* Opens it. From then on, a change ends the wait for input (tia_input.wait): the kernel sends SIGIO, which is blocked
 * except during that wait. Must be called before threads are created. False, with errno: not possible. */
bool file_watch_open(struct file_watch *watch);
void file_watch_close(struct file_watch *watch);

/* Begins another reading of the scene, for which file_watch_add gets each file before it is read. */
void file_watch_begin(struct file_watch *watch);
/* Adds a file, which need not exist; `ctx` is the watch. A file that cannot be watched is left out. Returns true. */
bool file_watch_add(void *ctx, const char *path);
/* Drops the files of earlier readings; to be called after a successful one. */
void file_watch_end(struct file_watch *watch);

/* True if a file has changed since the last call. */
bool file_watch_fires(struct file_watch *watch);

#endif
