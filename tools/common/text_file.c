#include "text_file.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define WIDTH 110

int text_open(struct text *text, const char *name, char *why)
{
    text->column = text->indent = 0;
    text->tight = false;
    text->last = '\0';
    return sink_open(&text->sink, name, why);
}

static void put(struct text *text, const char *bytes)
{
    const char *newline = strrchr(bytes, '\n');
    size_t length = strlen(bytes);

    if (length == 0)
        return;
    (void)sink_write(&text->sink, bytes, length);
    text->column = newline ? (unsigned)strlen(newline + 1) : text->column + (unsigned)length;
    text->last = bytes[length - 1];
}

void text_print(struct text *text, const char *format, ...)
{
    char bytes[TEXT_MOST + 1];
    va_list values;

    va_start(values, format);
    (void)vsnprintf(bytes, sizeof bytes, format, values);
    va_end(values);
    put(text, bytes);
}

static void put_word(struct text *text, const char *word)
{
    if (text->column > 0 && text->column + strlen(word) >= WIDTH)
        put(text, "\n");
    if (text->column == 0)
        text_print(text, "%*s", (int)text->indent, "");
    else if (!(text->tight && text->last == '{'))
        put(text, " ");
    put(text, word);
}

void text_word(struct text *text, const char *format, ...)
{
    char bytes[TEXT_MOST + 1], *word = bytes;
    va_list values;

    va_start(values, format);
    (void)vsnprintf(bytes, sizeof bytes, format, values);
    va_end(values);
    if (*word == ',') {
        put(text, ",");
        word += word[1] == ' ' ? 2 : 1;
    }
    if (*word != '\0')
        put_word(text, word);
}

int text_close(struct text *text)
{
    return sink_commit(&text->sink);
}
