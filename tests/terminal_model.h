/* terminal_model.h - a terminal for tests: interprets a program's output and stores the pixels.
 *
 * It interprets the few sequences that a picture of half blocks needs, ST, and CAN, which ends any sequence. Everything
 * else is counted in `unknown`. A cell is two pixels: foreground and background for U+2580, twice the background for a
 * space.
 */
#ifndef TESTS_TERMINAL_MODEL_H
#define TESTS_TERMINAL_MODEL_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct model {
    unsigned columns, rows;
    uint32_t *upper, *lower; /* colour of each cell, row by row: 0xRRGGBB */
    unsigned column, row;    /* position of the cursor */
    uint32_t fore, back;
    bool alternate, cursor_shown, wrap, paste, synchronised;
    int titles; /* on the stack of the window's titles */
    unsigned printed, frames, unknown, bytes;
    /* State of the parser. */
    int state; /* 0: text, 1: after ESC, 2: in CSI */
    char sequence[64];
    unsigned length;
    uint32_t character, rest;
};

static inline struct model model_new(unsigned columns, unsigned rows)
{
    struct model m = {.columns = columns, .rows = rows, .cursor_shown = true, .wrap = true, .fore = 0xffffff};

    m.upper = calloc((size_t)columns * rows, sizeof *m.upper);
    m.lower = calloc((size_t)columns * rows, sizeof *m.lower);
    if (!m.upper || !m.lower)
        abort();
    return m;
}

static inline void model_free(struct model *m)
{
    free(m->upper);
    free(m->lower);
}

/* Returns one of xterm's 256 colours; not one of the first 16, which vary. */
static inline uint32_t model_palette(unsigned index)
{
    unsigned c[3], n = index - 16;

    if (index < 16 || index > 255)
        return 0xff00ff;
    if (index >= 232)
        return (8 + 10 * (index - 232)) * 0x010101u;
    for (int i = 2; i >= 0; i--, n /= 6)
        c[i] = n % 6 == 0 ? 0 : 55 + 40 * (n % 6);
    return c[0] << 16 | c[1] << 8 | c[2];
}

static inline void model_print(struct model *m, uint32_t character)
{
    size_t at = (size_t)m->row * m->columns + m->column;

    if (m->column >= m->columns || m->row >= m->rows || (character != 0x2580 && character != ' ')) {
        m->unknown++;
        return;
    }
    m->upper[at] = character == ' ' ? m->back : m->fore;
    m->lower[at] = m->back;
    m->printed++;
    if (m->column + 1 < m->columns)
        m->column++;
    else if (m->wrap)
        m->unknown++; /* would scroll the window sooner or later */
}

static inline void model_colours(struct model *m, const unsigned *p, unsigned n)
{
    for (unsigned i = 0; i < n;) {
        uint32_t *to = p[i] == 38 ? &m->fore : &m->back;
        if (p[i] == 0) {
            m->fore = 0xffffff;
            m->back = 0;
            i++;
        } else if ((p[i] == 38 || p[i] == 48) && i + 4 < n && p[i + 1] == 2) {
            *to = p[i + 2] << 16 | p[i + 3] << 8 | p[i + 4];
            i += 5;
        } else if ((p[i] == 38 || p[i] == 48) && i + 2 < n && p[i + 1] == 5) {
            *to = model_palette(p[i + 2]);
            i += 3;
        } else {
            m->unknown++;
            return;
        }
    }
}

static inline void model_mode(struct model *m, unsigned number, bool on)
{
    if (number == 1049)
        m->alternate = on;
    else if (number == 25)
        m->cursor_shown = on;
    else if (number == 7)
        m->wrap = on;
    else if (number == 2004)
        m->paste = on;
    else if (number == 2026) {
        m->frames += m->synchronised && !on;
        m->synchronised = on;
    } else
        m->unknown++;
}

static inline void model_csi(struct model *m, char final)
{
    bool private_mode = m->sequence[0] == '?';
    unsigned p[16] = {0}, n = 1;

    for (const char *s = m->sequence + private_mode; *s; s++)
        if (*s == ';' && n < 16)
            n++;
        else if (*s >= '0' && *s <= '9')
            p[n - 1] = p[n - 1] * 10 + (unsigned)(*s - '0');
        else
            m->unknown++;
    if (private_mode && (final == 'h' || final == 'l')) {
        model_mode(m, p[0], final == 'h');
    } else if (final == 'H') {
        m->row = p[0] ? p[0] - 1 : 0;
        m->column = p[1] ? p[1] - 1 : 0;
    } else if (final == 'C') {
        m->column += p[0] ? p[0] : 1;
    } else if (final == 'm') {
        model_colours(m, p, n);
    } else if (final == 't' && (p[0] == 22 || p[0] == 23) && p[1] == 2) {
        m->titles += p[0] == 22 ? 1 : -1;
    } else if (final == 'J' && p[0] == 2) {
        for (size_t i = 0; i < (size_t)m->columns * m->rows; i++)
            m->upper[i] = m->lower[i] = m->back;
    } else {
        m->unknown++;
    }
}

static inline void model_text(struct model *m, unsigned char c)
{
    if (m->rest > 0 && (c & 0xc0) == 0x80) {
        m->character = m->character << 6 | (c & 0x3f);
        if (--m->rest == 0)
            model_print(m, m->character);
    } else if (c >= 0xe0 && c < 0xf0) {
        m->character = c & 0x0f;
        m->rest = 2;
    } else if (c == 27) {
        m->state = 1;
    } else {
        model_print(m, c);
    }
}

static inline void model_feed(struct model *m, const char *bytes, size_t count)
{
    m->bytes += (unsigned)count;
    for (size_t i = 0; i < count; i++) {
        char c = bytes[i];
        if (c == 24) {
            m->state = 0;
            m->rest = 0;
        } else if (m->state == 0) {
            model_text(m, (unsigned char)c);
        } else if (m->state == 1) {
            m->state = c == '[' ? 2 : 0;
            m->unknown += c != '[' && c != '\\';
            m->length = 0;
        } else if (c >= '@' || m->length == sizeof m->sequence - 1) {
            m->sequence[m->length] = 0;
            m->state = 0;
            model_csi(m, c);
        } else {
            m->sequence[m->length++] = c;
        }
    }
}

/* Returns pixel (x, y) of the window: 0xRRGGBB. */
static inline uint32_t model_pixel(const struct model *m, unsigned x, unsigned y)
{
    size_t at = (size_t)(y / 2) * m->columns + x;

    return y % 2 ? m->lower[at] : m->upper[at];
}

#endif
