/* answers.h - the kinds of pictures that a terminal can show, according to its own answers. */
#ifndef PORT_TERMINAL_ANSWERS_H
#define PORT_TERMINAL_ANSWERS_H

#include <stdbool.h>
#include <stdint.h>

/* Ways to show pictures, the best last. */
enum pictures { PICTURES_HALF_BLOCKS, PICTURES_SYMBOLS, PICTURES_SIXEL, PICTURES_KITTY };

/* True if `term`, the value of $TERM, is NULL or names tmux or screen. These never show pictures of kitty's protocol:
 * they treat them as titles, or ignore them. */
bool answers_multiplexer(const char *term);

#define ANSWERS_MS 150 /* time limit for a terminal's answers: over a network they come within a round trip */

/* The largest picture of sixel that a terminal shows, in pixels; 0: unknown. xterm drops larger ones. */
struct limit {
    uint16_t width, height;
};

/* The answers to the three queries, read byte by byte. The answer about kitty's protocol, ESC _ G i=31 ; OK ESC \,
 * comes first, then the limit of sixel, ESC [ ? 2 ; 0 ; width ; height S (xterm control sequences, XTSMGRAPHICS). The
 * device's attributes follow, ESC [ ? n ; n ... c, which every terminal sends; the attribute 4 means sixel. */
struct answers {
    uint8_t state;
    uint16_t numbers[4];         /* the first numbers of the sequence being read */
    uint8_t count;               /* how many of its numbers are complete */
    bool has_sixel;              /* a number of it is 4 */
    char message[8];             /* the beginning of kitty's message */
    uint8_t length;              /* length of `message` */
    bool sixel, kitty, complete; /* complete: all answers have come */
    struct limit limit;
};

void answers_byte(struct answers *answers, uint8_t byte);

/* Queries the terminal of `fd` and waits ANSWERS_MS at most. A terminal that cannot be read or does not answer gets
 * half blocks; one that answers, but has neither sixel nor kitty's protocol, gets symbols. No query is sent to a
 * terminal that is not the controlling one, or that has another process group in the foreground: a shell would take the
 * answers as typed. `term` is $TERM: the query for kitty's protocol is not sent to tmux and screen, which would show it
 * as a title. `limit` is set for sixel. */
enum pictures answers_ask(int fd, const char *term, struct limit *limit);

#endif
