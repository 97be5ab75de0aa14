/* node.h - opens device nodes, with a helpful reason on failure, and finds other processes that have them open. */
#ifndef PORT_COMMON_NODE_H
#define PORT_COMMON_NODE_H

#include "device.h"

/* Opens a node. Returns a descriptor (closed on exec), or -1 with the reason in `why`: "/dev/fb0: permission denied
 * (join group 'video')". */
int node_open(const char *path, int flags, char why[PORT_WHY]);

/* Calls `visit` for each node that exists among PREFIX0, PREFIX1, ... below PREFIX<limit>, until a call returns true.
 * Returns the number of calls. */
int node_each(const char *prefix, int limit, bool (*visit)(void *arg, const char *path), void *arg);

/* Returns strerror(error) in `text` with a lower-case first letter, as in tia's messages: "no such device". */
const char *node_error(int error, char text[PORT_WHY]);

#define NODE_HOLDER 48
/* Writes the name of another process that has the node open to `text` and returns it: "Xorg (pid 812)", or "another
 * program" if the process cannot be identified, since it belongs to another user. */
const char *node_holder(const char *path, char text[NODE_HOLDER]);

#endif
