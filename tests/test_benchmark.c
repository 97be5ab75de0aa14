/* The benchmark: a wrong frame has no score, totals are geometric means, and lines are parsed as strictly as printed.
 */
#include <math.h>

#include "check.h"
#include "common/benchmark/run.h"
#include "common/checksum.h"
#include "random.h"

/* ---- frames ---- */

static struct threads *pool;

/* Small frames of the benchmark's scenes, with the CRCs that they have. */
static void make_small(struct benchmark_frame frames[BENCHMARK_FRAMES])
{
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++) {
        struct benchmark_stage stage;
        frames[i] = benchmark_frames[i];
        frames[i].width = 24;
        frames[i].height = 19;
        CHECK_EQ(benchmark_open(&stage, &frames[i]), TIA_OK);
        CHECK_EQ(benchmark_draw(&stage, NULL, pool), TIA_OK);
        frames[i].crc = benchmark_check_pixels(&stage, pool);
        benchmark_close(&stage);
    }
}

/* Runs the benchmark with these frames; *text receives what it prints, to be freed. */
static int run(const struct benchmark_frame *frames, const struct tia_simd *widest, char **text)
{
    size_t length;
    char why[BENCHMARK_WHY];
    FILE *out = open_memstream(text, &length);
    const struct benchmark_wish wish = {
        .frames = frames, .widest = widest, .threads = 3, .each = 2, .us = 1, .out = out};
    int result = benchmark_run(&wish, why);

    CHECK_EQ(fclose(out), 0);
    return result;
}

static unsigned count_of(const char *text, const char *word)
{
    unsigned count = 0;

    for (const char *at = text; (at = strstr(at, word)) != NULL; at++)
        count++;
    return count;
}

TEST(right_frames_have_scores)
{
    struct benchmark_frame frames[BENCHMARK_FRAMES];
    char *text;

    make_small(frames);
    CHECK_EQ(run(frames, tia_simd_best(), &text), BENCHMARK_FINE);
    CHECK_EQ(count_of(text, "no score"), 0);
    CHECK_EQ(count_of(text, "\n" BENCHMARK_WORD), 1);
    CHECK_EQ(count_of(text, "plain.1=") + count_of(text, "plain.2=") + count_of(text, "plain.3="), 3);
    CHECK_EQ(count_of(text, "plain."), 3);
    free(text);
}

TEST(a_wrong_frame_has_no_score)
{
    for (unsigned wrong = 0; wrong < BENCHMARK_FRAMES; wrong++) {
        struct benchmark_frame frames[BENCHMARK_FRAMES];
        char *text, line[100];

        make_small(frames);
        uint32_t crc = frames[wrong].crc;
        frames[wrong].crc ^= UINT32_C(1) << 7 * wrong;
        CHECK_EQ(run(frames, NULL, &text), BENCHMARK_WRONG);
        (void)snprintf(line, sizeof line, "plain, 2 threads, %s: no score: CRC %08x, expected %08x\n",
                       frames[wrong].name, (unsigned)crc, (unsigned)frames[wrong].crc);
        CHECK_MSG(strstr(text, line), "without the line %s", line);
        CHECK_EQ(count_of(text, "expected"), 3);
        CHECK_EQ(count_of(text, "    no score"), 3);
        CHECK_EQ(count_of(text, BENCHMARK_WORD) + count_of(text, "total,"), 0);
        free(text);
    }
}

/* A frame that draws nothing does not pass for the one before it. */
TEST(pixels_do_not_stay)
{
    struct benchmark_frame frames[BENCHMARK_FRAMES];

    make_small(frames);
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++) {
        struct benchmark_stage stage;
        CHECK_EQ(benchmark_open(&stage, &frames[i]), TIA_OK);
        uint32_t undrawn = benchmark_check_pixels(&stage, pool);
        CHECK(undrawn != frames[i].crc);
        CHECK_EQ(benchmark_draw(&stage, NULL, pool), TIA_OK);
        CHECK_EQ(benchmark_check_pixels(&stage, pool), frames[i].crc);
        CHECK_EQ(benchmark_check_pixels(&stage, pool), undrawn);
        benchmark_close(&stage);
    }
}

/* ---- totals ---- */

TEST(totals)
{
    CHECK_EQ(benchmark_total((uint32_t[]){1000, 1000, 1000, 1000}), 1000);
    CHECK_EQ(benchmark_total((uint32_t[]){1, 16, 81, 10000}), 60); /* (2^4 3^4 10^4)^(1/4) */
    CHECK_EQ(benchmark_total((uint32_t[]){1, 16, 81, 9999}), 59);
    CHECK_EQ(benchmark_total((uint32_t[]){4294967291, 4294967291, 4294967291, 4294967290}), 4294967290);
    CHECK_EQ(benchmark_total((uint32_t[]){5, 5, 5, 0}), 0);
    CHECK_EQ(benchmark_total((uint32_t[]){UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX}), UINT32_MAX);
    for (unsigned i = 0; i < check_count(20000); i++) {
        uint32_t rates[BENCHMARK_FRAMES];
        for (unsigned k = 0; k < BENCHMARK_FRAMES; k++)
            rates[k] = (uint32_t)random_short(32);
        double want = sqrt(sqrt((double)rates[0] * rates[1]) * sqrt((double)rates[2] * rates[3])),
               got = benchmark_total(rates);
        CHECK_MSG(got <= want + 1e-5 && got > want - 1.00001, "the total is %.0f, not %.6f", got, want);
    }
}

/* ---- lines ---- */

static struct benchmark_line made, parsed;
static char made_text[BENCHMARK_LINE], changed[BENCHMARK_LINE], why[BENCHMARK_WHY];

static size_t make_line(void)
{
    made = (struct benchmark_line){.set = BENCHMARK_SET,
                                   .definition = 1,
                                   .version = "0.1.0",
                                   .machine = "riscv64",
                                   .compiler = "gcc 12.2.0",
                                   .each = 1500,
                                   .threads = 3,
                                   .crcs = {1, 0xf00df00d, 2, UINT32_MAX},
                                   .rows = {{"plain", 1, {1, 2, 3, 1000}},
                                            {"plain", 2, {UINT32_MAX, 2, 3, 1000}},
                                            {"rvv", 1, {1, 2, 3, 1000}},
                                            {"rvv", 3, {1, 2000, 3, 1000}}},
                                   .row_count = 4};
    benchmark_set_text(made.cpu, sizeof made.cpu, "\t \"Brand\" \\ 7\x80 \n");
    return benchmark_print(&made, made_text);
}

/* Makes the check word of changed[length] right, if it has one. */
static void set_check(size_t length)
{
    char word[9];

    if (length < 15)
        return;
    (void)snprintf(word, sizeof word, "%08x", (unsigned)checksum_bytes(0, changed, length - 15));
    memcpy(changed + length - 8, word, 8);
}

TEST(a_line_is_parsed_as_printed)
{
    size_t length = make_line();

    CHECK(strcmp(made.cpu, "Brand 7") == 0);
    CHECK_MSG(benchmark_parse(&parsed, made_text, length, why), "refused: %s", why);
    CHECK_EQ(benchmark_print(&parsed, changed), length);
    CHECK(memcmp(changed, made_text, length) == 0);
    CHECK_EQ(parsed.rows[3].rates[1], 2000);
    CHECK_EQ(parsed.crcs[3], UINT32_MAX);
    made.by_frames = true;
    CHECK(benchmark_parse(&parsed, made_text, benchmark_print(&made, made_text), why) && parsed.by_frames);
}

TEST(cut_and_changed_lines)
{
    size_t length = make_line();

    for (size_t i = 0; i < length; i++) {
        CHECK_MSG(!benchmark_parse(&parsed, made_text, i, why), "cut after %zu bytes", i);
        memcpy(changed, made_text, length);
        changed[i] ^= 1;
        CHECK_MSG(!benchmark_parse(&parsed, changed, length, why), "byte %zu changed", i);
        CHECK(strlen(why) > 0 && !strchr(why, '\n'));
    }
}

/* With the check word made right, a line is refused, or has another content in the one spelling. */
TEST(lines_with_a_new_check_word)
{
    size_t length = make_line(), accepted = 0;

    for (size_t i = 0; i + 15 < length; i++)
        for (unsigned bit = 0; bit < 8; bit++) {
            memcpy(changed, made_text, length);
            changed[i] = (char)(changed[i] ^ 1 << bit);
            set_check(length);
            if (!benchmark_parse(&parsed, changed, length, why))
                continue;
            accepted++;
            CHECK_EQ(benchmark_print(&parsed, made_text), length);
            CHECK_MSG(memcmp(changed, made_text, length) == 0, "byte %zu", i);
            (void)make_line();
        }
    CHECK(accepted > 0);
}

/* Replaces a text of the line, and expects this reason. */
static void refused(const char *from, const char *to, const char *says)
{
    size_t length = make_line();
    const char *at = strstr(made_text, from);

    CHECK_MSG(at, "no %s", from);
    if (!at)
        return;
    int used = snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - made_text), made_text, to, at + strlen(from));
    length = (size_t)used;
    set_check(length);
    CHECK_MSG(!benchmark_parse(&parsed, changed, length, why), "%s for %s is accepted", to, from);
    CHECK_MSG(strstr(why, says), "%s for %s: %s", to, from, why);
}

TEST(what_is_refused)
{
    refused("tia-benchmark 1", "tia-benchmark 2", "of benchmark 2; this tia has benchmark 1");
    refused("tia-benchmark 1", "tia-benchmark x", "not a line");
    refused("threads=3", "threads=03", "not spelled");
    refused("threads=3", "threads=2", "rvv.3: not the row");
    refused("threads=3", "threads=1025", "not spelled");
    refused("plain.1=", "rvv.1=", "rvv.1: not the row");
    refused("rvv.1=", "plain.1=", "plain.1: not the row");
    refused("rvv.3=", "rvv.1=", "rvv.1: not the row");
    refused("rvv.1=", "RVV.1=", "row 3 of scores is not spelled");
    refused("=0.001,", "=0.000,", "row 1 of scores is not spelled");
    refused("=0.001,", "=0.01,", "not spelled");
    refused("=4294967.295,", "=4294967.296,", "row 2 of scores is not spelled");
    refused(":0.008", ":0.009", "plain.1: its total is not the geometric mean");
    refused("seconds=1.500", "seconds=1.5", "not spelled");
    refused("seconds=1.500", "frames=0x", "not spelled");
    refused(",rays:", ",ways:", "not spelled");
    refused("spans:00000001", "spans:1", "not spelled");
    refused("spans:00000001", "spans:0000000A", "not spelled");
    refused(" cpu=", "  cpu=", "not spelled");
    refused("riscv64", "riscv64riscv64riscv64riscv64riscv64", "not spelled");
    refused("Brand 7", "Brand\n7", "not spelled");
}

int main(void)
{
    pool = threads_create(2);
    RUN(right_frames_have_scores);
    RUN(a_wrong_frame_has_no_score);
    RUN(pixels_do_not_stay);
    RUN(totals);
    RUN(a_line_is_parsed_as_printed);
    RUN(cut_and_changed_lines);
    RUN(lines_with_a_new_check_word);
    RUN(what_is_refused);
    threads_destroy(pool);
    return check_status();
}
