/* descriptor.h - descriptors of terminals that never block. */
#ifndef PORT_TERMINAL_DESCRIPTOR_H
#define PORT_TERMINAL_DESCRIPTOR_H

/* Opens the terminal of this name, or whatever it is, with O_NONBLOCK. -1 and errno on failure. */
int descriptor_open(const char *path, int access);

/* The same for the terminal that `fd` is. The shell shares `fd`'s open file description and with it
 * O_NONBLOCK, so this opens one of our own. A terminal without a name, or that we may not open, is
 * only duplicated, and may block. */
int descriptor_copy(int fd, int access);

#endif
