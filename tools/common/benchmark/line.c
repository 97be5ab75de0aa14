#include "line.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "common/checksum.h"

/* ---- totals ---- */

/* A product of two numbers of 64 bits. */
struct product {
    uint64_t high, low;
};

/* Multiplies as by hand, in halves of 32 bits; no sum overflows. */
static struct product multiply(uint64_t a, uint64_t b)
{
    uint64_t low = (a & UINT32_MAX) * (b & UINT32_MAX), middle = (a >> 32) * (b & UINT32_MAX) + (low >> 32);
    uint64_t other = (a & UINT32_MAX) * (b >> 32) + (middle & UINT32_MAX);

    return (struct product){(a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32), other << 32 | (low & UINT32_MAX)};
}

uint32_t benchmark_total(const uint32_t rates[BENCHMARK_FRAMES])
{
    const struct product all = multiply((uint64_t)rates[0] * rates[1], (uint64_t)rates[2] * rates[3]);
    uint32_t found = 0;

    for (uint32_t bit = UINT32_C(1) << 31; bit; bit >>= 1) {
        uint64_t square = (uint64_t)(found | bit) * (found | bit);
        struct product fourth = multiply(square, square);
        if (fourth.high < all.high || (fourth.high == all.high && fourth.low <= all.low))
            found |= bit;
    }
    return found;
}

/* ---- printing ---- */

static bool is_plain(char c)
{
    return c >= ' ' && c <= '~' && c != '"' && c != '\\';
}

void benchmark_set_text(char *field, size_t size, const char *text)
{
    size_t used = 0;

    for (; *text != '\0' && used + 1 < size; text++) {
        char c = is_plain(*text) ? *text : ' ';
        if (c != ' ' || (used > 0 && field[used - 1] != ' '))
            field[used++] = c;
    }
    while (used > 0 && field[used - 1] == ' ')
        used--;
    field[used] = '\0';
}

struct printer {
    char *text;
    size_t used;
};

__attribute__((format(printf, 2, 3))) static void put(struct printer *p, const char *format, ...)
{
    va_list values;
    size_t left = BENCHMARK_LINE - p->used;

    va_start(values, format);
    int length = vsnprintf(p->text + p->used, left, format, values);
    va_end(values);
    p->used += length < 0 ? 0 : (size_t)length < left ? (size_t)length : left - 1;
}

static void put_rate(struct printer *p, char before, uint32_t rate)
{
    put(p, "%c%" PRIu32 ".%03" PRIu32, before, rate / 1000, rate % 1000);
}

static void put_row(struct printer *p, const struct benchmark_row *row)
{
    put(p, " %s.%u", row->level, row->threads);
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        put_rate(p, i ? ',' : '=', row->rates[i]);
    put_rate(p, ':', benchmark_total(row->rates));
}

size_t benchmark_print(const struct benchmark_line *line, char *text)
{
    struct printer p = {text, 0};

    put(&p, BENCHMARK_WORD "%u version=%s definition=%u", line->set, line->version, line->definition);
    put(&p, " cpu=\"%s\" machine=\"%s\" compiler=\"%s\" threads=%u", line->cpu, line->machine, line->compiler,
        line->threads);
    if (line->by_frames)
        put(&p, " frames=%" PRIu32, line->each);
    else
        put(&p, " seconds=%" PRIu32 ".%03" PRIu32, line->each / 1000, line->each % 1000);
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        put(&p, "%s%s:%08" PRIx32, i ? "," : " crc=", benchmark_frames[i].name, line->crcs[i]);
    for (unsigned i = 0; i < line->row_count; i++)
        put_row(&p, &line->rows[i]);
    put(&p, " check=%08" PRIx32, checksum_bytes(0, text, p.used));
    return p.used;
}
