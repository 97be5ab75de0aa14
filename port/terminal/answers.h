/* answers.h - finds out the kinds of pictures that a terminal supports, by query. */
#ifndef PORT_TERMINAL_ANSWERS_H
#define PORT_TERMINAL_ANSWERS_H

#include <stdbool.h>
#include <stdint.h>

/* Ways to show pictures, the best last. */
enum pictures { PICTURES_HALF_BLOCKS, PICTURES_SYMBOLS, PICTURES_SIXEL, PICTURES_KITTY };

/* True if $TERM is that of tmux or screen, which show kitty's pictures nowhere: they take them for titles or nothing.
 */
bool answers_multiplexer(const char *term);

#define ANSWERS_MS 150 /* longest wait for a terminal: over a network the answers come within a round trip */

/* Parser of the answers to the two queries, byte by byte: kitty's, ESC _ G i=31 ; OK ESC \, comes before the device's
 * attributes, ESC [ ? n ; n ... c, which every terminal sends and which has a 4 where there is sixel. */
struct answers {
    uint8_t state;
    uint16_t number;             /* the attribute being read */
    char message[8];             /* the beginning of kitty's message */
    uint8_t length;              /* length of `message` */
    bool sixel, kitty, complete; /* complete: no more bytes will come */
};

void answers_byte(struct answers *answers, uint8_t byte);

/* Queries the terminal of `fd` and waits ANSWERS_MS at most. A terminal that cannot be read or does not answer gets
 * half blocks; one that answers and has neither sixel nor kitty's protocol gets symbols. A terminal that is not ours,
 * or not now, gets no query: its shell would take the answers as typed. `term` is $TERM: tmux and screen get no query
 * for kitty's protocol, since they would show it as a title. */
enum pictures answers_ask(int fd, const char *term);

#endif
