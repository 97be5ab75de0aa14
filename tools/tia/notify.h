/* notify.h - notifications that long work has ended, for --notify. */
#ifndef TOOLS_TIA_NOTIFY_H
#define TOOLS_TIA_NOTIFY_H

#include "options.h"

/* Begins the work; a signal that ends it is notified, too. Does nothing without --notify. */
void notify_begin(const struct options *options);

/* Notifies the controlling terminal that the work has ended with this exit status, if it took more than a second. */
void notify_end(int status);

#endif
