/* scene_part.h - the files that a scene refers to, relative to its own: each is loaded once, and freed by
 * scene_close. */
#ifndef TOOLS_SCENE_SCENE_PART_H
#define TOOLS_SCENE_SCENE_PART_H

#include "file.h"

/* Implements the callback `library` of tia/read.h; `ctx` is the scene file. */
int part_library(void *ctx, const char *name, const char **text, size_t *length, const char **why);
/* Implements `image`. */
int part_image(void *ctx, const char *name, struct tia_texture *texture, const char **why);
/* Implements `opacity`. */
int part_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture, const char **why);

/* Returns the path of the file that the scene calls `name`, to be freed by free(); NULL if there is no memory. */
char *part_path(const struct scene_file *file, const char *name);

void part_free_all(struct scene_file *file);

#endif
