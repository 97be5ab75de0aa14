/* words.h - a command line from a fuzzer's bytes, a newline between arguments. */
#ifndef TESTS_FUZZ_WORDS_H
#define TESTS_FUZZ_WORDS_H

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "bytes.h"

#define WORDS_MOST 24

struct words {
    char *text, *argv[WORDS_MOST + 2];
    int argc;
};

static inline struct words take_words(char *command, const uint8_t *data, size_t size)
{
    struct words w = {.text = malloc(size + 1), .argv = {command}, .argc = 1};

    MUST(w.text);
    if (size)
        memcpy(w.text, data, size);
    w.text[size] = '\0';
    for (char *word = strtok(w.text, "\n"); word && w.argc <= WORDS_MOST; word = strtok(NULL, "\n"))
        w.argv[w.argc++] = word;
    optind = 0; /* glibc: restarts getopt */
    return w;
}

#endif
