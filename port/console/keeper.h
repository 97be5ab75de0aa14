/* keeper.h - the guarded process's side: starts and ends the guardian, and sends it what it has to put back. Private to
 * guardian.c. */
#ifndef PORT_CONSOLE_KEEPER_H
#define PORT_CONSOLE_KEEPER_H

#include "kept.h"

/* 0, or -1: see guardian.h. */
int keeper_keep(const struct saved *saved);
/* Also ends the guardian when nothing is left to put back. */
void keeper_forget(struct saved *saved);
/* Sends the table's entry for the same terminal once more, if there is one. */
void keeper_again(const struct saved *like);
/* See guardian_sync. */
void keeper_sync(void);

#endif
