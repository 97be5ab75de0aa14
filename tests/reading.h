/* reading.h - reads scene texts as programs do: the memory provided is exactly what tia_read needs. */
#ifndef TESTS_READING_H
#define TESTS_READING_H

#include <stdlib.h>

#include "check.h"
#include <tia/read.h>

struct reading {
    struct tia_reader reader;
    struct tia_scene scene;
    void *memory; /* exactly the memory that the scene needs */
    size_t need;
    int status;
};

static inline void read_end(struct reading *r)
{
    free(r->memory);
    r->memory = NULL;
}

/* Reads a copy of r->reader's text, in memory of exactly its length, so that a sanitizer detects reads beyond its
 * end. */
static inline void read_begin(struct reading *r)
{
    const char *text = r->reader.text;
    size_t again = 0;
    char *copy = malloc(r->reader.length + 1);

    memcpy(copy, text, r->reader.length);
    copy = realloc(copy, r->reader.length ? r->reader.length : 1);
    r->reader.text = copy;
    r->memory = NULL;
    r->status = tia_read(&r->reader, &r->scene, NULL, 0, &r->need);
    if (r->status == TIA_ERR_MEMORY) {
        r->memory = malloc(r->need);
        memset(r->memory, 0xaa, r->need); /* code must not rely on zeros */
        CHECK_EQ(tia_read(&r->reader, &r->scene, r->memory, r->need - 1, &again), TIA_ERR_MEMORY);
        CHECK_EQ(again, r->need);
        r->status = tia_read(&r->reader, &r->scene, r->memory, r->need, &again);
        CHECK(r->status ? again >= r->need : again == r->need);
    }
    free(copy);
    r->reader.text = text;
}

static inline void read_string(struct reading *r, enum tia_format format, const char *text)
{
    *r = (struct reading){.reader = {.format = format, .text = text, .length = strlen(text)}};
    read_begin(r);
}

/* Returns the contents of a file, followed by a zero; NULL if there is no such file. */
static inline char *load_file(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    if (!file)
        return NULL;
    (void)fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    (void)fseek(file, 0, SEEK_SET);
    char *text = calloc(1, *length + 1);
    CHECK(fread(text, 1, *length, file) == *length);
    (void)fclose(file);
    return text;
}

/* Checks the error of the text, as "LINE:COLUMN: TEXT" or "FILE:LINE:COLUMN: TEXT". */
static inline void check_read_error(struct reading *r, const char *want)
{
    const struct tia_read_error *e = &r->reader.error;
    char got[600];

    (void)snprintf(got, sizeof got, "%s%s%u:%u: %s", e->file, *e->file ? ":" : "", (unsigned)e->line,
                   (unsigned)e->column, e->text);
    CHECK_MSG(r->status == TIA_ERR_RANGE && !strcmp(got, want), "%d, '%.150s', not '%.150s'", r->status, got, want);
    read_end(r);
}

/* Checks that every text that is cut off somewhere is either accepted, or refused with a line within it. */
static inline void check_truncated(const struct tia_reader *reader)
{
    for (size_t length = 0; length <= reader->length; length++) {
        struct reading r = {.reader = *reader};
        uint32_t lines = 1;

        r.reader.length = length;
        for (size_t i = 0; i < length; i++)
            lines += reader->text[i] == '\n';
        read_begin(&r);
        CHECK(!r.status || r.status == TIA_ERR_RANGE);
        if (r.status)
            CHECK_MSG(*r.reader.error.text && r.reader.error.line <= lines, "%zu bytes: line %u: %s", length,
                      (unsigned)r.reader.error.line, r.reader.error.text);
        read_end(&r);
    }
}

#endif
