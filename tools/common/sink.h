/* sink.h - writes bytes to a file that appears complete or not at all. */
#ifndef TOOLS_SINK_H
#define TOOLS_SINK_H

#include <stdbool.h>
#include <stddef.h>

#include "temporary.h"

struct sink {
    int fd;                     /* -1: none */
    char *path;                 /* the file's final name; NULL: the file is written directly */
    struct temporary temporary; /* the file's name until it is published */
    const char *name;           /* name in messages */
    char *why;
    size_t used;
    bool failed;
    unsigned char buffer[65536];
};

/* Opens a sink. TIA_OK, or TIA_ERR_DEVICE with the reason in `why`. `name` must outlive the sink. All functions but
 * sink_write are to be called on the main thread: see common/signals.h. */
int sink_open(struct sink *sink, const char *name, char *why);
int sink_write(struct sink *sink, const void *bytes, size_t count);

/* Flushes all bytes to the disk, so that only the renaming can still fail. A failure ends the sink. */
int sink_seal(struct sink *sink);

/* Ends the sink: gives a sealed file its final name. After a failure no file is left. */
int sink_publish(struct sink *sink);
/* Seals and publishes the file. */
int sink_commit(struct sink *sink);
/* Ends the sink without a file. */
void sink_discard(struct sink *sink);

/* True if two names, each a sink's or NULL, are of one file, however they are spelled: the second sink would leave only
 * its own bytes. Standard output takes both. */
bool sink_is_same(const char *a, const char *b);

#endif
