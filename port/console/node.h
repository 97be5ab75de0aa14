/* node.h - opens device nodes, with a helpful reason on failure, and finds who else has them open. */
#ifndef PORT_COMMON_NODE_H
#define PORT_COMMON_NODE_H

#include "device.h"

/* Opens a node; returns a descriptor (closed on exec), or -1 and `why`: "/dev/fb0: permission denied (join group
 * 'video')". */
int node_open(const char *path, int flags, char why[PORT_WHY]);

/* Visits those of PREFIX0, PREFIX1, ... below PREFIX<limit> that exist, until a visit returns true. Returns the number
 * of nodes visited. */
int node_each(const char *prefix, int limit, bool (*visit)(void *arg, const char *path), void *arg);

/* Returns strerror with a lower-case first letter, as in our error messages: "no such device". */
const char *node_error(int error, char text[PORT_WHY]);

/* Another process that has the node open: "Xorg (pid 812)", or "another program" when it belongs to
 * another user and cannot be seen. */
#define NODE_HOLDER 48
const char *node_holder(const char *path, char text[NODE_HOLDER]);

#endif
