/* typed.h - stores bytes that the controlling terminal sends during the display's queries, for the keyboard input. */
#ifndef PORT_TERMINAL_TYPED_H
#define PORT_TERMINAL_TYPED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TYPED_MOST 256 /* capacity in bytes: answers of about 40, and the keys typed within ANSWERS_MS */

/* Empties the buffer. */
void typed_forget(void);
/* Stores bytes, including answers: the keyboard's decoder recognises that an answer is no key. If the end of the wait
 * has cut an answer off, the decoder reads the rest from the keyboard. Bytes beyond TYPED_MOST are lost. */
void typed_keep(const uint8_t *bytes, size_t count);

bool typed_any(void);

/* Moves the stored bytes to `bytes`, which has room for TYPED_MOST. Returns their number. */
size_t typed_take(uint8_t *bytes);

#endif
