/* sink.h - writes bytes to a file that appears complete or not at all. */
#ifndef TOOLS_SINK_H
#define TOOLS_SINK_H

#include <stdbool.h>
#include <stddef.h>

#include "temporary.h"

struct sink {
    int fd;                     /* -1: none */
    char *path;                 /* the file's final name; NULL: written directly */
    struct temporary temporary; /* under this name until then */
    const char *name;           /* for messages */
    char *why;
    size_t used;
    bool failed;
    unsigned char buffer[65536];
};

/* TIA_OK, or TIA_ERR_DEVICE with the reason in `why`. `name` must outlive the sink. From the main thread, as all but
 * sink_write: see common/signals.h. */
int sink_open(struct sink *sink, const char *name, char *why);
int sink_write(struct sink *sink, const void *bytes, size_t count);

/* All bytes are on the disk; what can still fail is the final name. After a failure the sink has ended. */
int sink_seal(struct sink *sink);

/* These end the sink; after a failure no file is left. sink_publish gives a sealed one its final name, sink_commit is
 * both. */
int sink_publish(struct sink *sink);
int sink_commit(struct sink *sink);
void sink_discard(struct sink *sink);

#endif
