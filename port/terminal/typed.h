/* typed.h - what the controlling terminal sent while the display asked it, for its keyboard. */
#ifndef PORT_TERMINAL_TYPED_H
#define PORT_TERMINAL_TYPED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TYPED_MOST 256 /* bytes: answers of about 40 and what a person types within ANSWERS_MS */

/* Answers are kept too: the decoder knows that they are no keys, and one that is cut off by the end of the wait goes on
 * when the keyboard is read. What finds no room is lost. */
void typed_forget(void);
void typed_keep(const uint8_t *bytes, size_t count);

bool typed_any(void);

/* Moves what was kept to `bytes`, which has room for TYPED_MOST. Returns how many. */
size_t typed_take(uint8_t *bytes);

#endif
