/* cooked.h - restores terminals: their modes, and texts such as the end of a picture. Private to the guardian. */
#ifndef PORT_CONSOLE_COOKED_H
#define PORT_CONSOLE_COOKED_H

#include "restore_table.h"

/* Opens a device without waiting and without making it the controlling terminal. Returns a descriptor, or -1. */
int cooked_open(const char *path);

/* Restores, once the process of `group` has died, all terminals that no stop has restored before. A terminal that
 * accepts no text causes a delay of 0.4 s at most; the text then remains, with a descriptor for cooked_write. */
void cooked_at_the_end(pid_t group);

/* Restores, when the process of `group` has stopped, the terminals that it had in front; true if there were any. They
 * stay restored until a message reports that the process has changed them again. */
bool cooked_at_a_stop(pid_t group);

/* Writes a remaining text, as much of it as the terminal accepts within timeout_ms; false if some is left. */
bool cooked_write(struct saved *saved, int timeout_ms);

#endif
