/* scene_report.h - the mistakes of a scene file as a text for people: a message "FILE:LINE:COLUMN: WHAT", and below it
 * the line with a mark under the word.
 *
 *     a.tia:3:12: 'colr' is not a field of a material, expected colour
 *         3 | material m colr 1 0 0
 *           |            ^~~~
 */
#ifndef TOOLS_SCENE_SCENE_REPORT_H
#define TOOLS_SCENE_SCENE_REPORT_H

#include <stddef.h>

#include "file.h"

/* Appends a mistake to file->report. Without memory it is left out. Control characters become '?', and so do those that
 * turn the direction of a line; a tab becomes blanks; of a long line the part around the word is shown. */
void scene_report_add(struct scene_file *file, const char *message, const struct tia_read_error *error);

/* Appends that there are more mistakes than were told. */
void scene_report_more(struct scene_file *file);

/* Prints the report to standard error, each message after "TOOL: ", or else file->why; frees it. Returns `status`. */
int scene_report_print(struct scene_file *file, const char *tool, int status);

/* Frees the report. */
void scene_report_free(struct scene_file *file);

#endif
