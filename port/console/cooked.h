/* cooked.h - puts terminals back: their modes, and texts such as the end of a picture. Private to the guardian. */
#ifndef PORT_CONSOLE_COOKED_H
#define PORT_CONSOLE_COOKED_H

#include "restore_table.h"

/* Opens a device without waiting and without taking it for the controlling terminal. */
int cooked_open(const char *path);

/* Puts back, once the process of this group has died, all that no stop has put back before. A terminal that accepts no
 * text delays it by 0.4 s at most; then that text remains, with a descriptor for cooked_write. */
void cooked_at_the_end(pid_t group);

/* Puts back, when the process has stopped, the terminals that it had in front; true if there were any. They stay so
 * until a message reports that the process has changed them again. */
bool cooked_at_a_stop(pid_t group);

/* Writes a text that remains, as much as the terminal accepts; false: some is left after timeout_ms. */
bool cooked_write(struct saved *saved, int timeout_ms);

#endif
