/* scene_load.h - loads a scene file: reads the text, loads the files that it refers to, builds the hierarchy. */
#ifndef TOOLS_SCENE_SCENE_LOAD_H
#define TOOLS_SCENE_SCENE_LOAD_H

#include "file.h"

#define SCENE_UNKNOWN (-1)
#define SCENE_MODEL 1000 /* a format of libassimp, see common/scene/model/model.h */

/* Returns the format of a file by its extension; SCENE_UNKNOWN for others. */
int scene_format_of(const char *path);

/* Reads the scene `path` ("-": standard input) of `format` (enum tia_format, or SCENE_MODEL). Files that it refers to
 * are relative to its directory. Returns TIA_OK; TIA_ERR_MEMORY; TIA_ERR_DEVICE if a file cannot be read; TIA_ERR_RANGE
 * if it is not a valid scene. After an error file->why has the reason, the first mistake, and file->report all of them:
 * scene_report_print, scene_report_free or scene_close frees it, and nothing else needs to be closed. `path` must
 * outlive the file. With `strict`, warnings are errors. */
int scene_open(struct scene_file *file, const char *path, int format, bool strict);

/* Reads the scene as scene_open does, with the settings `wish`, which must outlive the call. */
int scene_open_for(struct scene_file *file, const char *path, int format, bool strict, const struct scene_wish *wish);

/* Gets the next warning about the opened scene, "FILE:LINE: WHAT (N more)". *at is the state of the loop over the
 * warnings, 0 at first. Returns false if there are no more. */
bool scene_warning(const struct scene_file *file, unsigned *at, char line[SCENE_WHY]);
void scene_close(struct scene_file *file);

#endif
