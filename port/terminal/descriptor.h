/* descriptor.h - descriptors of terminals that never block. */
#ifndef PORT_TERMINAL_DESCRIPTOR_H
#define PORT_TERMINAL_DESCRIPTOR_H

/* -1 and errno, or the terminal of this name (or whatever it is), with O_NONBLOCK. */
int descriptor_open(const char *path, int access);

/* The same for the terminal that `fd` is. O_NONBLOCK belongs to a file description, which the
 * shell shares: this one is our own. A terminal without a name, or that we may not open, is only
 * duplicated, and may block. */
int descriptor_copy(int fd, int access);

#endif
