/* readers.h - the readers that tia_read chooses from, one per format.
 *
 * A reader fills *scene, which is all zeros, from reader->text and allocates arrays in the arena. It returns TIA_OK,
 * even if the arena is too small (see arena.h), or sets reader->error and returns TIA_ERR_RANGE. tia_read then runs
 * tia_scene_check; for a fault, the format's `locate` function finds the line of the faulty object.
 *
 * Treat the text and all loaded files as hostile. Time and memory must stay about linear in the size of the text: a
 * library that is named a thousand times must not be read a thousand times, and a scene includes at most 64 files.
 */
#ifndef TIA_READ_READERS_H
#define TIA_READ_READERS_H

#include "read/text/arena.h"
#include "read/text/text_lines.h"

int tia_read_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);
int tia_read_nff(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);

/* Readers of models. `use` is NULL for a scene of its own; see model/model.h. */
struct tia_model_use;
int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                 struct tia_model_use *use);
int tia_read_stl(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                 struct tia_model_use *use);
int tia_read_ply(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                 struct tia_model_use *use);
int tia_read_off(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                 struct tia_model_use *use);
int tia_read_pgm(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                 struct tia_model_use *use);
/* Reads a model in any of these formats. */
int tia_read_model(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                   struct tia_model_use *use);

/* Tells all mistakes of a .tia text in which tia_read_tia found one, see `mistake` in tia/read.h, and sets
 * reader->error to the first. Uses the scene and the arena anew, whose `used` becomes what is needed to tell all. */
void tia_tell_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena);

/* Finds a fault in the text. Sets the line and column of reader->error, which must be 0, and replaces the fault's thing
 * and field by the words that the file uses. Changes nothing if the fault is not found. The arena must be as the reader
 * left it. Models need no such function: their readers refuse all values that tia_scene_check would refuse. */
void tia_locate_tia(struct tia_reader *reader, struct tia_fault *fault, struct tia_arena *arena);
/* Does the same for a .nff file. */
void tia_locate_nff(struct tia_reader *reader, struct tia_fault *fault);

#endif
