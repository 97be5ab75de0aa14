/* write.h - --write: a model as a scene in .tia, to be edited. */
#ifndef TOOLS_TIA_WRITE_H
#define TOOLS_TIA_WRITE_H

#include "common/text_file.h"
#include "options.h"

/* Keeps a material's name; a scene_wish has this function. `ctx`: struct write_names. */
void write_note_name(void *ctx, uint32_t index, const char *name);

void write_free_names(struct write_names *names);

/* Writes options->scene to options->write. It draws the same picture, bit for bit, with the same options. Returns the
 * exit status. */
int write_scene(const struct options *options);

/* Writes a mesh's lines, without its name. */
void write_mesh(struct text *text, const struct tia_mesh *mesh);

/* Writes " WORD NUMBER ..." for numbers times 2^-bits, with digits from which they are read again exactly. */
void write_numbers(struct text *text, const char *word, const int32_t *numbers, unsigned count, unsigned bits);

/* Writes " NUMBER" with all its digits. */
void write_exactly(struct text *text, double number);

/* Writes " WORD R G B", or one number for grey, for a colour times 2^bits. */
void write_rgb(struct text *text, const char *word, struct tia_rgb colour, unsigned bits);

#endif
