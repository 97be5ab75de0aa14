/* src/read's words, lines, numbers, names and arrays. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "read/text/name_table.h"

static struct tia_read_error error;

static struct tia_text text_of(const char *string)
{
    return tia_text_begin(string, strlen(string), "", &error);
}

static struct tia_word word_of(const char *string)
{
    return (struct tia_word){string, (uint32_t)strlen(string), 1, 1};
}

TEST(numbers_of_each_format)
{
    struct tia_text t = text_of("32767.99999 -32768 1.9999999995 -2 100 -2147483647.5 32767.999993");
    tia_q16 q16 = 0;
    tia_q30 q30 = 0;
    int64_t wide = 0;

    CHECK(tia_text_has_number(&t));
    CHECK(!tia_text_q16(&t, &q16) && q16 == INT32_MAX);
    CHECK(!tia_text_q16(&t, &q16) && q16 == INT32_MIN);
    CHECK(!tia_text_q30(&t, &q30) && q30 == INT32_MAX);
    CHECK(!tia_text_q30(&t, &q30) && q30 == INT32_MIN);
    CHECK(!tia_text_integer(&t, &wide, -5, 100) && wide == 100);
    CHECK(!tia_text_q32(&t, &wide) && wide == -INT64_C(0x7fffffff80000000));
    CHECK_EQ(tia_text_q16(&t, &q16), TIA_ERR_RANGE); /* it rounds to 32768 */
    CHECK(!strcmp(error.text, "'32767.999993' is out of range, expected a number from -32768 to below 32768"));
    CHECK(!tia_text_has_number(&t));
}

static void check_error(int status, uint32_t line, uint32_t column, const char *what)
{
    CHECK_EQ(status, TIA_ERR_RANGE);
    CHECK_MSG(error.line == line && error.column == column && !strcmp(error.text, what), "%u:%u: %s",
              (unsigned)error.line, (unsigned)error.column, error.text);
}

TEST(errors_of_numbers)
{
    struct tia_text t = text_of("  abc\n5 7 1.0 x # end");
    int64_t n;
    tia_q30 q30;

    CHECK(tia_text_line(&t));
    check_error(tia_text_q30(&t, &q30), 1, 3, "'abc' is not a number, expected a number from -2 to below 2");
    CHECK(tia_text_line(&t));
    check_error(tia_text_integer(&t, &n, -1, 4), 2, 1, "'5' is out of range, expected a whole number from -1 to 4");
    CHECK_EQ(tia_text_integer(&t, &n, 7, 7), TIA_OK);
    check_error(tia_text_integer(&t, &n, 1, 2), 2, 5,
                "'1.0' is not a whole number, expected a whole number from 1 to 2");
    check_error(tia_text_end(&t), 2, 9, "'x' is too much, expected the end of the line");
    CHECK_EQ(tia_text_end(&t), TIA_OK);
    check_error(tia_text_q30(&t, &q30), 2, 11, "the line ends here, expected a number from -2 to below 2");
    t = text_of("0 0 0");
    struct tia_dir3 d;
    check_error(tia_text_dir3(&t, &d), 1, 1,
                "'0' begins a direction of no length, expected three numbers that are not all 0");
}

TEST(lines_and_words)
{
    static const char bytes[] = "\n  # comment\r\none two\r\n\t\t3#4 # 5\n\r\nsix \\\n  seven\\\r\neight \\nine\nten";
    static const struct {
        const char *word;
        uint32_t line, column;
    } want[] = {{"one", 3, 1},   {"two", 3, 5},   {"", 3, 8},       {"3#4", 4, 3}, {"", 4, 7},    {"six", 6, 1},
                {"seven", 7, 3}, {"eight", 8, 1}, {"\\nine", 8, 7}, {"", 8, 12},   {"ten", 9, 1}, {"", 9, 4}};
    /* a copy of exactly this size, for the sanitizers */
    char *copy = malloc(sizeof bytes - 1);
    memcpy(copy, bytes, sizeof bytes - 1);
    struct tia_text t = tia_text_begin(copy, sizeof bytes - 1, "", &error);
    struct tia_word word, peeked;
    bool line = tia_text_line(&t);

    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        bool is_there = tia_text_peek(&t, &peeked);
        CHECK(line);
        CHECK_EQ(tia_text_word(&t, &word), is_there);
        CHECK_MSG(tia_word_is(&word, want[i].word) && word.line == want[i].line && word.column == want[i].column &&
                      word.at == peeked.at,
                  "word %zu is '%.*s' at %u:%u", i, (int)word.length, word.at, (unsigned)word.line,
                  (unsigned)word.column);
        if (!is_there)
            line = tia_text_line(&t);
    }
    CHECK(!line && !tia_text_line(&t));
    free(copy);
    t = tia_text_begin(NULL, 0, "", &error);
    CHECK(!tia_text_line(&t) && !tia_text_word(&t, &word));
}

TEST(names_and_files)
{
    struct tia_text t = text_of("plain \"two words.png\" \"\" \"open");
    struct tia_word word;
    char name[TIA_NAME_MAX + 1], lengthy[300];

    CHECK(!tia_text_file(&t, &word, "a file") && tia_word_is(&word, "plain"));
    CHECK(!tia_text_file(&t, &word, "a file") && tia_word_is(&word, "two words.png"));
    CHECK_EQ(word.column, 8);
    tia_word_copy(name, &word);
    CHECK(!strcmp(name, "two words.png"));
    check_error(tia_text_file(&t, &word, "a file"), 1, 23, "'\"\"' is empty, expected a file");
    t.next++;
    check_error(tia_text_file(&t, &word, "a file"), 1, 26, "'\"open' has no closing quote, expected a file");
    memset(lengthy, 'x', 299);
    lengthy[299] = 0;
    t = text_of(lengthy + 44);
    CHECK_EQ(tia_text_name(&t, &word, "a name"), TIA_OK);
    t = text_of(lengthy + 43);
    check_error(tia_text_name(&t, &word, "a name"), 1, 1,
                "'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' is longer than 255 bytes, expected a name");
    t = text_of("a\033[2Jb\377");
    check_error(tia_text_name(&t, &word, "a name"), 1, 1, "'a?[2Jb?' contains a control character, expected a name");
}

static void check_direction(int64_t x, int64_t y, int64_t z)
{
    struct tia_dir3 d = {0, 0, 0};
    int64_t v[3] = {x, y, z};
    long double length = hypotl(hypotl((long double)x, (long double)y), (long double)z);

    CHECK(tia_dir3_of(&d, v));
    CHECK(fabsl((long double)x / length * TIA_Q30_ONE - d.x) <= 2);
    CHECK(fabsl((long double)y / length * TIA_Q30_ONE - d.y) <= 2);
    CHECK(fabsl((long double)z / length * TIA_Q30_ONE - d.z) <= 2);
}

TEST(directions_have_length_1)
{
    int64_t v[3];

    check_direction(0, -5, 0);
    check_direction(1, 1, 1);
    check_direction(INT64_MAX, -INT64_MAX, INT64_MAX);
    check_direction(INT64_MAX, 1, 0);
    check_direction((INT64_C(1) << 33) - 1, (INT64_C(1) << 33) - 1, 1);
    for (int i = 0; i < 30000; i++) {
        for (int j = 0; j < 3; j++) {
            uint64_t n = random_bits();
            v[j] = (int64_t)(n >> (1 + (unsigned)i % 50)) * (n & 1 << 10 ? 1 : -1);
        }
        check_direction(v[0], v[1], v[2]);
    }
    struct tia_dir3 d;
    CHECK(!tia_dir3_of(&d, (int64_t[3]){0, 0, 0}));
    struct tia_text t = text_of("0 -3000 0");
    CHECK(!tia_text_dir3(&t, &d) && d.x == 0 && d.y == -TIA_Q30_ONE && d.z == 0);
}

TEST(names_sorted_and_found)
{
    enum { COUNT = 5000 };
    static struct tia_name names[COUNT];
    static char texts[COUNT][8];

    for (uint32_t i = 0; i < COUNT; i++) {
        (void)snprintf(texts[i], sizeof texts[i], "%x", (unsigned)(i * 7919u % COUNT));
        names[i] = (struct tia_name){word_of(texts[i]), i % 3, i};
        names[i].word.line = i + 1;
    }
    tia_names_sort(names, COUNT);
    CHECK(!tia_names_twice(names, COUNT));
    for (uint32_t i = 0; i < COUNT; i++) {
        struct tia_word word = word_of(texts[i]);
        const struct tia_name *found = tia_names_find(names, COUNT, i % 3, &word);
        CHECK(found && found->index == i);
        CHECK(!tia_names_find(names, COUNT, (i + 1) % 3, &word));
    }
    names[17].word.line = 9000; /* the same name as an earlier one: the later one is reported */
    names[18].word = names[17].word;
    names[18].kind = names[17].kind;
    names[18].word.line = 8000;
    names[18].index = COUNT;
    tia_names_sort(names, COUNT);
    const struct tia_name *twice = tia_names_twice(names, COUNT);
    CHECK(twice && twice->word.line == 9000);
    CHECK(!tia_names_find(names, 0, 0, &names[0].word));
}

TEST(arrays_are_counted_then_filled)
{
    uint64_t memory[8];
    struct tia_arena arena = {(unsigned char *)memory, sizeof memory, 0};
    struct tia_array bytes = {.item = 3}, words = {.item = sizeof(uint64_t)}, none = {.item = 5};

    for (int pass = 0; pass < 2; pass++) {
        for (unsigned i = 0; i < 5; i++)
            tia_array_add(&bytes, (unsigned char[3]){(unsigned char)i, 1, 2});
        for (uint64_t i = 0; i < 6; i++)
            tia_array_add(&words, &i);
        if (pass)
            break;
        CHECK(tia_array_place(&arena, &bytes) == memory && tia_array_place(&arena, &words) == memory + 2);
        CHECK(!tia_array_place(&arena, &none));
        CHECK(bytes.count == 0 && tia_arena_fits(&arena) && arena.used == sizeof memory);
    }
    CHECK(bytes.items[0] == 0 && bytes.items[12] == 4 && bytes.items[14] == 2);
    CHECK(memory[2] == 0 && memory[7] == 5 && words.count == 6);
    tia_array_add(&bytes, "no more"); /* more than was counted is not stored */
    CHECK(memory[2] == 0 && bytes.count == 6);
}

TEST(memory_that_is_missing_is_counted)
{
    uint64_t memory[2];
    struct tia_arena arena = {(unsigned char *)memory, 15, 0};

    CHECK(tia_arena_take(&arena, 8, 1) == memory);
    CHECK(!tia_arena_take(&arena, 8, 1) && !tia_arena_fits(&arena));
    CHECK_EQ(arena.used, 16);
    CHECK(!tia_arena_take(&arena, 9, 1));
    CHECK_EQ(arena.used, 32);
    CHECK(!tia_arena_take(&arena, 8, SIZE_MAX / 4) && !tia_arena_fits(&arena));
    CHECK(!tia_arena_take(&arena, 1, 1) && !tia_arena_fits(&arena) && arena.used > SIZE_MAX / 2);
}

int main(void)
{
    RUN(numbers_of_each_format);
    RUN(errors_of_numbers);
    RUN(lines_and_words);
    RUN(names_and_files);
    RUN(directions_have_length_1);
    RUN(names_sorted_and_found);
    RUN(arrays_are_counted_then_filled);
    RUN(memory_that_is_missing_is_counted);
    return check_status();
}
