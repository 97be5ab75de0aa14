/* recording.h - --record: draws a picture, and writes a record of it (common/record/record.h). */
#ifndef TOOLS_TIA_RECORDING_H
#define TOOLS_TIA_RECORDING_H

#include "options.h"

/* Loads the scene, draws options->output, and writes options->record. Returns the exit status, after an error message
 * if it is not 0. */
int recording_draw(struct options *options);

/* True if a record has the option: pixels can depend on it, and it names no file. */
bool recording_has(const struct option_row *row);

/* Returns the row of the option of tia in "name=value" or "name"; NULL: there is none. */
const struct option_row *recording_option(const char *text);

#endif
