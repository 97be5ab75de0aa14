/* descriptor.h - opens terminals so that they never block. */
#ifndef PORT_TERMINAL_DESCRIPTOR_H
#define PORT_TERMINAL_DESCRIPTOR_H

#include <stdbool.h>

/* Opens the file `path`, a terminal or not, with O_NONBLOCK and `access` (O_RDWR, ...). Returns -1 and errno on
 * failure. */
int descriptor_open(const char *path, int access);

/* Opens the terminal of `fd` again: setting O_NONBLOCK on `fd` itself would set it for the shell, which shares the open
 * file description. If the terminal has no name or cannot be opened, only duplicates `fd`, and may block. */
int descriptor_copy(int fd, int access);

/* True unless another process group is in the foreground of the terminal, such as a shell with its own modes and
 * screen. */
bool descriptor_in_front(int fd);

/* Stops this process, if it is in the background, until it is in the foreground or a signal comes. Returns
 * descriptor_in_front(fd). */
bool descriptor_await_front(int fd);

/* Drops the output that the kernel has not yet passed to the terminal. */
void descriptor_drop_output(int fd);

#endif
