/* text_file.h - writes formatted text to a file that appears complete or not at all. */
#ifndef TOOLS_COMMON_TEXT_FILE_H
#define TOOLS_COMMON_TEXT_FILE_H

#include "sink.h"

struct text {
    struct sink sink;
    unsigned column; /* column of the next word, from 0 */
    unsigned indent; /* indent of the lines that text_word begins */
    bool tight;      /* no space after an opening brace */
    char last;       /* the last byte written */
};

/* Opens the file as sink_open does: the name "-" is standard output; `why` has PORT_WHY bytes. */
int text_open(struct text *text, const char *name, char *why);

/* Prints as printf does, at most TEXT_MOST bytes per call. Failures are stored; checking text_close is enough. */
#define TEXT_MOST 1024
__attribute__((format(printf, 2, 3))) void text_print(struct text *text, const char *format, ...);

/* Prints a word of a paragraph. It is separated by a space, or by a new line if it would not fit. A leading comma
 * directly follows the previous word. */
__attribute__((format(printf, 2, 3))) void text_word(struct text *text, const char *format, ...);

int text_close(struct text *text);

#endif
