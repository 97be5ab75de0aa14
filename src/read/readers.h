/* readers.h - the readers that tia_read chooses from, one per format.
 *
 * A reader fills *scene, which is all zeros, from reader->text and allocates arrays in the arena. It returns TIA_OK,
 * also when the arena was too small (see arena.h), or TIA_ERR_RANGE with reader->error. tia_read then runs
 * tia_scene_check; for a fault, the format's `locate` function finds the line of the faulty object.
 *
 * Treat the text and all loaded files as hostile. Time and memory must stay about linear in the bytes of text: a
 * library that is named a thousand times must not be read a thousand times, and a .tia file is included 64 times at
 * most.
 */
#ifndef TIA_READ_READERS_H
#define TIA_READ_READERS_H

#include "read/text/arena.h"
#include "read/text/text_lines.h"

int tia_read_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);
int tia_read_nff(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);
int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);

/* Sets the line and column of reader->error, which are 0 before, to a fault's place in the text, and the fault's thing
 * and field to the words of the file. Nothing changes if the place is not found. The arena is as the reader left it.
 * There is no such function for .obj, whose statements have already refused all values that tia_scene_check might
 * refuse. */
void tia_locate_tia(struct tia_reader *reader, struct tia_fault *fault, struct tia_arena *arena);
/* Does the same for a .nff file. */
void tia_locate_nff(struct tia_reader *reader, struct tia_fault *fault);

#endif
