/* keeper.h - the guarded process's side: starts and ends the guardian, and sends it the states to restore. Private to
 * guardian.c. */
#ifndef PORT_CONSOLE_KEEPER_H
#define PORT_CONSOLE_KEEPER_H

#include "restore_table.h"

/* Stores a state in the table and sends it to the guardian. Returns 0 or -1, as the guardian_keep_... functions do. */
int keeper_keep(const struct saved *saved);
/* Removes a state; ends the guardian when no state is left to restore. */
void keeper_forget(struct saved *saved);
/* Sends the table's entry for the terminal of `like` again, if there is one. */
void keeper_again(const struct saved *like);
/* Waits for the guardian, see guardian_sync. */
void keeper_sync(void);

#endif
