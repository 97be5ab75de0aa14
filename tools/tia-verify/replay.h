/* replay.h - draws the picture of a record again. */
#ifndef TOOLS_VERIFY_REPLAY_H
#define TOOLS_VERIFY_REPLAY_H

#include "common/row_tap.h"
#include "record_file.h"

/* Draws with the record's options and files; the tap receives the rows that it wants, and no file is written. Returns a
 * status of tia/checking.h; if it is not 0, after a message. */
int replay(struct record_place *place, const struct row_tap *tap, unsigned threads);

#endif
