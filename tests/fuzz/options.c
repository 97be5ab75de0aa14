/* options.c - the command line: any bytes, a newline between arguments. What is accepted keeps its
 * limits. */
#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "bytes.h"
#include "tools/tia/fail.h"
#include "tools/tia/options.h"

#define ARGUMENTS 24

static void must_keep_limits(const struct options *o)
{
    MUST(o->scene && o->core && o->display && o->input);
    MUST(!o->width == !o->height && o->width <= TIA_SIZE_MAX && o->height <= TIA_SIZE_MAX);
    MUST(o->action != ACTION_DRAW || o->output);
    MUST(o->threads >= 1);
    MUST(!o->key_count || o->keys);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1), *argv[ARGUMENTS + 2] = {"tia"};
    struct options options;
    int argc = 1, status;

    MUST(text);
    if (size)
        memcpy(text, data, size);
    text[size] = '\0';
    for (char *word = strtok(text, "\n"); word && argc <= ARGUMENTS; word = strtok(NULL, "\n"))
        argv[argc++] = word;
    optind = 0; /* glibc: start anew */
    status = options_parse(&options, argc, argv);
    MUST(status == EXIT_FINE || status == EXIT_USAGE || status == EXIT_DISPLAY || status == EXIT_RUNNING);
    if (status == EXIT_FINE && options.action != ACTION_HELP && options.action != ACTION_VERSION)
        must_keep_limits(&options);
    options_free(&options);
    free(text);
    return 0;
}
