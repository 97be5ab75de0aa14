/* answers.h - the kinds of pictures that a terminal can show, according to its own answers. */
#ifndef PORT_TERMINAL_ANSWERS_H
#define PORT_TERMINAL_ANSWERS_H

#include <stdbool.h>
#include <stdint.h>

/* Ways to show pictures, the best last. */
enum pictures { PICTURES_HALF_BLOCKS, PICTURES_SYMBOLS, PICTURES_SIXEL, PICTURES_KITTY };

/* True if `term`, the value of $TERM, is that of tmux or screen, which never show kitty's pictures: they treat them as
 * titles, or ignore them. */
bool answers_multiplexer(const char *term);

#define ANSWERS_MS 150 /* time limit for a terminal's answers: over a network they come within a round trip */

/* The answers to the two queries, read byte by byte. kitty's, ESC _ G i=31 ; OK ESC \, comes before the device's
 * attributes, ESC [ ? n ; n ... c, which every terminal sends; 4 among them means sixel. */
struct answers {
    uint8_t state;
    uint16_t number;             /* the attribute being read */
    char message[8];             /* the beginning of kitty's message */
    uint8_t length;              /* length of `message` */
    bool sixel, kitty, complete; /* complete: all answers have come */
};

void answers_byte(struct answers *answers, uint8_t byte);

/* Queries the terminal of `fd` and waits ANSWERS_MS at most. A terminal that cannot be read or does not answer has half
 * blocks; one that answers and has neither sixel nor kitty's protocol has symbols. A terminal that is not the
 * controlling one, or not in front, gets no query: its shell would take the answers as typed. `term` is $TERM: tmux and
 * screen get no query for kitty's protocol, since they would show it as a title. */
enum pictures answers_ask(int fd, const char *term);

#endif
