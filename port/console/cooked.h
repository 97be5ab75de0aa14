/* cooked.h - restores terminals: sets their former modes, and writes closing texts, such as the end of a picture's
 * data. Private to the guardian. */
#ifndef PORT_CONSOLE_COOKED_H
#define PORT_CONSOLE_COOKED_H

#include "restore_table.h"

/* Opens a device without waiting and without making it the controlling terminal. Returns a descriptor, or -1. */
int cooked_open(const char *path);

/* Restores all terminals that were not restored at a stop; called when the process of `group` has died. A terminal that
 * accepts no text causes a delay of 0.4 s at most; its text then stays in the table, with a descriptor for
 * cooked_write. */
void cooked_at_the_end(pid_t group);

/* Restores the terminals that have `group` in the foreground; called when the process of `group` has stopped. True if
 * there were any. Their entries stay marked as restored until a message reports that the process has changed the
 * terminals again. */
bool cooked_at_a_stop(pid_t group);

/* Writes the rest of a text. Returns false if some is left because the terminal has accepted nothing for timeout_ms. */
bool cooked_write(struct saved *saved, int timeout_ms);

#endif
