/* The lines of tia --benchmark (common/benchmark/line.h): raw bytes, and lines as tia prints them with some bytes
 * changed and their check word made right again. What is accepted is printed as the same bytes, and has nothing in it
 * that a terminal would obey. */
#include <stdio.h>
#include <string.h>

#include "bytes.h"
#include "common/benchmark/line.h"
#include "common/checksum.h"

enum { CHECK = 15 }; /* bytes of " check=XXXXXXXX" */

static void take_rows(struct bytes *b, struct benchmark_line *line)
{
    static const char *const levels[] = {"plain", "scalar", "avx2", "rvv"};
    uint8_t count = take_byte(b);

    for (unsigned i = 0; i < count % 6u; i++) {
        struct benchmark_row *row = &line->rows[line->row_count++];
        (void)snprintf(row->level, sizeof row->level, "%s", levels[i / 2]);
        row->threads = i % 2 ? 2 + take_byte(b) % 2u : 1;
        for (unsigned k = 0; k < BENCHMARK_FRAMES; k++)
            row->rates[k] = take_word(b) >> take_byte(b) % 32;
    }
}

static void take_line(struct bytes *b, struct benchmark_line *line)
{
    char name[20];

    *line = (struct benchmark_line){.set = BENCHMARK_SET, .definition = take_byte(b), .version = "0.1.0", .threads = 3};
    for (unsigned i = 0; i + 1 < sizeof name; i++)
        name[i] = (char)take_byte(b);
    name[sizeof name - 1] = '\0';
    benchmark_set_text(line->cpu, sizeof line->cpu, name);
    benchmark_set_text(line->compiler, sizeof line->compiler, name + 9);
    line->by_frames = take_byte(b) & 1;
    line->each = take_word(b);
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        line->crcs[i] = take_word(b);
    take_rows(b, line);
}

/* Changes some bytes, or cuts the text, and then makes the check word right, so that the change is seen by the other
 * checks. */
static size_t damage(struct bytes *b, char *text, size_t length)
{
    uint8_t changes = take_byte(b);
    char word[CHECK + 1];

    for (unsigned i = 0; i < changes % 4u; i++)
        text[take_word(b) % length] = (char)take_byte(b);
    if (changes & 4)
        length = take_word(b) % length;
    if (changes & 8 || length < CHECK)
        return length;
    (void)snprintf(word, sizeof word, " check=%08x", (unsigned)checksum_bytes(0, text, length - CHECK));
    memcpy(text + length - CHECK, word, CHECK);
    return length;
}

/* Parses a copy of the bytes, so that reading beyond them is noticed. */
static bool must_parse_well(const char *bytes, size_t length)
{
    static struct benchmark_line line;
    char again[BENCHMARK_LINE], why[BENCHMARK_WHY], *text = malloc(length + !length);

    MUST(text);
    memcpy(text, bytes, length);
    bool accepted = benchmark_parse(&line, text, length, why);
    if (accepted) {
        MUST(benchmark_print(&line, again) == length && memcmp(again, text, length) == 0);
        for (size_t i = 0; i < length; i++)
            MUST(text[i] >= ' ' && text[i] <= '~');
        MUST(line.row_count > 0 && benchmark_total(line.rows[0].rates) > 0);
    } else {
        MUST(*why && memchr(why, '\0', sizeof why) && !strchr(why, '\n'));
    }
    free(text);
    return accepted;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct benchmark_line line;
    struct bytes bytes = {data, size};
    char text[BENCHMARK_LINE];

    if (size && data[0] == 't') {
        (void)must_parse_well((const char *)data, size);
        return 0;
    }
    (void)take_byte(&bytes);
    take_line(&bytes, &line);
    size_t length = benchmark_print(&line, text);
    (void)must_parse_well(text, damage(&bytes, text, length));
    return 0;
}
