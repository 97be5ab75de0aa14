#include "benchmark_check.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/benchmark/line.h"
#include "common/benchmark/stage.h"
#include "common/record/record.h"
#include "tia/checking.h"
#include "tia/fail.h"

enum { PLACE = 256 };

struct lines {
    const char *path; /* NULL: a line of the command line */
    unsigned number;  /* number of the line, from 1 */
    unsigned seen;    /* lines of the benchmark */
    const struct tia_simd *simd;
    unsigned threads;
    bool drawn; /* the frames were drawn again, and had the right CRCs */
    char how[64];
};

/* Returns what begins a message about the current line: "FILE:3: ". */
static const char *place(const struct lines *l, char text[PLACE])
{
    text[0] = '\0';
    if (l->path)
        (void)snprintf(text, PLACE, "%.200s:%u: ", l->path, l->number);
    return text;
}

/* ---- the frames, drawn again ---- */

/* Draws a frame; *crc receives its CRC-32. */
static int draw_frame(struct lines *l, struct threads *pool, const struct benchmark_frame *frame, uint32_t *crc)
{
    struct benchmark_stage stage;
    int status = benchmark_open(&stage, frame);

    status = status ? status : benchmark_draw(&stage, l->simd, pool);
    if (!status) {
        *crc = benchmark_check_pixels(&stage, pool);
        (void)snprintf(l->how, sizeof l->how, "%s, %u thread%s", tia_view_simd(stage.view), threads_count(pool),
                       threads_count(pool) == 1 ? "" : "s");
    }
    benchmark_close(&stage);
    return status ? fail(CHECK_FAILED, "%s: %s", frame->name, fail_reason(status)) : CHECK_SAME;
}

static int draw_frames(struct lines *l)
{
    struct threads *pool = threads_create(l->threads);
    int result = pool ? CHECK_SAME : fail(CHECK_FAILED, "memory: exhausted");

    for (unsigned i = 0; i < BENCHMARK_FRAMES && !result; i++) {
        uint32_t crc = 0;
        result = draw_frame(l, pool, &benchmark_frames[i], &crc);
        if (!result && crc != benchmark_frames[i].crc)
            result = fail(CHECK_FAILED,
                          "%s: drawn here, its CRC-32 is %08x, not %08x: this tia or this machine draws wrong bits",
                          benchmark_frames[i].name, (unsigned)crc, (unsigned)benchmark_frames[i].crc);
    }
    threads_destroy(pool);
    l->drawn = !result;
    return result;
}

/* ---- a line ---- */

static int check_crcs(const struct lines *l, const struct benchmark_line *line)
{
    char at[PLACE];
    int result = CHECK_SAME;

    for (unsigned i = 0; i < BENCHMARK_FRAMES && !result; i++)
        if (line->crcs[i] != benchmark_frames[i].crc) {
            (void)printf("%s%s: CRC-32 %08x, right is %08x: no score\n", place(l, at), benchmark_frames[i].name,
                         (unsigned)line->crcs[i], (unsigned)benchmark_frames[i].crc);
            result = CHECK_DIFFERS;
        }
    return result;
}

static int check_line(struct lines *l, const char *text, size_t length)
{
    static struct benchmark_line line; /* too large for the stack */
    char why[BENCHMARK_WHY], at[PLACE];

    l->seen++;
    if (!benchmark_parse(&line, text, length, why))
        return fail(CHECK_FAILED, "%s%s", place(l, at), why);
    if (line.definition != RECORD_DEFINITION)
        return fail(CHECK_FAILED, "%sdrawn by definition %u; this tia draws definition %u", place(l, at),
                    line.definition, (unsigned)RECORD_DEFINITION);
    int result = check_crcs(l, &line);
    if (!result && !l->drawn)
        result = draw_frames(l);
    if (!result)
        (void)printf("%s%s: %u row%s of scores: all %u frames have the right CRC-32, drawn again here as well (%s)\n",
                     place(l, at), line.cpu, line.row_count, line.row_count == 1 ? "" : "s", (unsigned)BENCHMARK_FRAMES,
                     l->how);
    return result;
}

/* ---- a file ---- */

/* Reads lines, which may be indented, until the end. Returns the worst result. */
static int check_file(struct lines *l, FILE *file)
{
    char *text = NULL;
    size_t size = 0;
    int worst = CHECK_SAME;

    for (ssize_t length; (length = getline(&text, &size, file)) >= 0;) {
        const char *at = text + strspn(text, " ");
        size_t left = (size_t)length - (size_t)(at - text);
        l->number++;
        if (strncmp(at, BENCHMARK_WORD, sizeof BENCHMARK_WORD - 1) != 0)
            continue;
        left -= left > 0 && at[left - 1] == '\n';
        int result = check_line(l, at, left);
        worst = result > worst ? result : worst;
    }
    free(text);
    if (ferror(file))
        return fail(CHECK_FAILED, "%.300s: %s", l->path, strerror(errno));
    return l->seen ? worst : fail(CHECK_FAILED, "%.300s: no line of tia --benchmark in it", l->path);
}

static int check_path(struct lines *l)
{
    struct stat status;

    if (strcmp(l->path, "-") == 0) {
        l->path = "standard input";
        return check_file(l, stdin);
    }
    FILE *file = stat(l->path, &status) == 0 && S_ISREG(status.st_mode) ? fopen(l->path, "re") : NULL;
    if (!file)
        return fail(CHECK_FAILED, "%.300s: %s", l->path, errno ? strerror(errno) : "not a regular file");
    int result = check_file(l, file);
    (void)fclose(file);
    return result;
}

int benchmark_check(const char *line_or_path, const struct tia_simd *simd, unsigned threads)
{
    struct lines lines = {.simd = simd, .threads = threads};
    bool is_line = strncmp(line_or_path, BENCHMARK_WORD, sizeof BENCHMARK_WORD - 1) == 0;

    errno = 0;
    lines.path = is_line ? NULL : line_or_path;
    int result = is_line ? check_line(&lines, line_or_path, strlen(line_or_path)) : check_path(&lines);
    return fflush(stdout) == 0 ? result : fail_output();
}
