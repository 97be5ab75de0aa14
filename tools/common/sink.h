/* sink.h - writes bytes to a file that appears complete or not at all. */
#ifndef TOOLS_SINK_H
#define TOOLS_SINK_H

#include <stdbool.h>
#include <stddef.h>

struct sink {
    int fd;           /* -1: none */
    char *path;       /* the file's final name; NULL: written directly */
    char *temporary;  /* the name until then */
    const char *name; /* for messages */
    char *why;
    size_t used;
    bool failed;
    unsigned char buffer[65536];
};

/* TIA_OK, or TIA_ERR_DEVICE with the reason in `why`. `name` must outlive the sink. */
int sink_open(struct sink *sink, const char *name, char *why);
int sink_write(struct sink *sink, const void *bytes, size_t count);
/* Both end the sink; after a failure no file is left. */
int sink_commit(struct sink *sink);
void sink_discard(struct sink *sink);

#endif
