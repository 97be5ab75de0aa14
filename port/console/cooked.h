/* cooked.h - restores terminals: their modes, and texts such as the end of a picture. Private to the guardian. */
#ifndef PORT_CONSOLE_COOKED_H
#define PORT_CONSOLE_COOKED_H

#include "kept.h"

/* Opens a device without waiting and without taking it for the controlling terminal. */
int cooked_open(const char *path);

/* Called when the process of this group has died: restores all that no stop has restored before. A terminal that
 * accepts no text delays it by 0.4 s at most; then that text remains, with a descriptor for cooked_write. */
void cooked_at_the_end(pid_t group);

/* Called when it has stopped: restores the terminals that it had in front. They stay so until a message reports another
 * change. Returns true if there were any. */
bool cooked_at_a_stop(pid_t group);

/* Writes as much of a remaining text as the terminal accepts; false if some is left after timeout_ms. */
bool cooked_write(struct saved *saved, int timeout_ms);

#endif
