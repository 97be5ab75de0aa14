/* readers.h - what tia_read chooses from: one reader a format.
 *
 * A reader fills *scene, which is all zeros, from reader->text, its arrays from the arena. It returns
 * TIA_OK, also when the arena did not fit (see arena.h), or TIA_ERR_RANGE with reader->error. tia_read
 * runs tia_scene_check on what came out; the fault of a thing is then shown where `locate` puts it.
 *
 * The text and all that the callbacks fetch is hostile: time and memory must stay linear in the bytes
 * of text, or nearly (a library that is named a thousand times is not read a thousand times).
 * `library` is called in every pass, and must give the same each time; `image` only in the last one.
 */
#ifndef TIA_SRC_READ_READERS_H
#define TIA_SRC_READ_READERS_H

#include "read/text/arena.h"
#include "read/text/text.h"

int tia_read_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);
int tia_read_nff(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);
int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);

/* The place of a thing at fault, as file (if not the scene's own text), line and column of
 * reader->error, which are "", 0 and 0 before: where that is not cheap, they stay so. The arena is as the reader left
 * it. */
void tia_locate_tia(struct tia_reader *reader, const struct tia_fault *fault, struct tia_arena *arena);
void tia_locate_nff(struct tia_reader *reader, const struct tia_fault *fault);
void tia_locate_obj(struct tia_reader *reader, const struct tia_fault *fault);

#endif
