/* answers.h - what a terminal can show, as it says itself. */
#ifndef PORT_TERMINAL_ANSWERS_H
#define PORT_TERMINAL_ANSWERS_H

#include <stdbool.h>
#include <stdint.h>

/* Ways to show pictures, the best last. */
enum pictures { PICTURES_HALF_BLOCKS, PICTURES_SYMBOLS, PICTURES_SIXEL, PICTURES_KITTY };

/* Whether $TERM is that of tmux or screen, which show kitty's pictures nowhere: they take them for titles or nothing.
 */
bool answers_multiplexer(const char *term);

#define ANSWERS_MS 150 /* how long a terminal may take: over a network the answers come within a round trip */

/* The answers to the two questions, byte by byte: kitty's, ESC _ G i=31 ; OK ESC \, comes before the device's
 * attributes, ESC [ ? n ; n ... c, which every terminal sends and which has a 4 where there is sixel. */
struct answers {
    uint8_t state;
    uint16_t number;             /* the attribute being read */
    char message[8];             /* the beginning of kitty's message */
    uint8_t length;              /* of it */
    bool sixel, kitty, complete; /* complete: nothing more will come */
};

void answers_byte(struct answers *answers, uint8_t byte);

/* Asks the terminal of `fd` and waits ANSWERS_MS at most. What cannot be read or answers nothing has half blocks.
 * What answers and has neither sixel nor kitty's protocol has symbols. Nor is a terminal asked that is not ours, or not
 * now: its shell would take the answers as typed. `term` is $TERM: tmux and screen are not asked for kitty's protocol,
 * since they make a title of the question. */
enum pictures answers_ask(int fd, const char *term);

#endif
