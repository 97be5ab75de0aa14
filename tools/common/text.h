/* text.h - lines of text on their way into a file that appears whole or not at all. */
#ifndef PORT_COMMON_TEXT_H
#define PORT_COMMON_TEXT_H

#include "common/image/sink.h"

struct text {
    struct sink sink;
    unsigned column; /* where the next word starts, from 0 */
    unsigned indent; /* of a line that text_word begins */
    bool tight;      /* no space behind an opening brace */
    char last;       /* the last byte */
};

/* As sink_open: `name` "-" is standard output; `why` is PORT_WHY bytes. */
int text_open(struct text *text, const char *name, char *why);

/* At most TEXT_MOST bytes at once, as printf. A failure is kept: it suffices to look at text_close. */
#define TEXT_MOST 1024
__attribute__((format(printf, 2, 3))) void text_print(struct text *text, const char *format, ...);

/* The same, as one word of a paragraph: a space before it, or a new line where it would not fit;
 * a comma that it begins with follows without either. */
__attribute__((format(printf, 2, 3))) void text_word(struct text *text, const char *format, ...);

int text_close(struct text *text);

#endif
