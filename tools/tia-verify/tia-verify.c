/* tia-verify - draws a part of a picture again and compares its bits; see tia-verify(1). */
#include <stdio.h>
#include <string.h>

#include "benchmark_check.h"
#include "common/signals.h"
#include "common/verify/choice.h"
#include "record_check.h"
#include "record_file.h"
#include "tia/arguments.h"
#include "tia/checking.h"
#include "tia/fail.h"

/* The options of tia come first: their rows have offsets in struct options. */
struct verify {
    struct options drawn;
    struct choice_wish wish;
    const char *root;
    const char *benchmark; /* a line of tia --benchmark, or a file */
    const char *drawing;   /* the first option given that a record has; NULL: none */
};

static const struct option_row rows[] = {
    CHOICE_ROWS(struct verify, wish),
    {"root", 0, OPTION_TEXT, "HASH", "the record must have this root, 64 hexadecimal digits",
     OPTION_TO(struct verify, root)},
    {"benchmark", 0, OPTION_TEXT, "FILE|LINE",
     "verify a line of tia --benchmark, or those of a file, or of - for standard input",
     OPTION_TO(struct verify, benchmark)},
    OPTION_END};

/* Remembers an option of tia, which a record already has. */
static void remember(void *ctx, const struct option_row *row, const char *value)
{
    struct verify *verify = ctx;
    bool own = row >= rows && row < rows + sizeof rows / sizeof *rows;

    (void)value;
    if (!own && !verify->drawing && strcmp(row->name, "threads") != 0)
        verify->drawing = row->name;
}

static int run_record(const struct verify *verify, int argc, char **argv)
{
    const struct record_wish wish = {verify->wish, verify->root, verify->drawn.threads};

    if (verify->drawing)
        return fail(CHECK_FAILED, "--%s: the record has the options", verify->drawing);
    if (argc > 2)
        return fail(CHECK_FAILED, "%.200s: one picture at a time", argv[2]);
    return argc == 1 ? record_check(argv[0], &wish) : record_compare(argv[0], argv[1], &wish);
}

static int run_benchmark(struct verify *verify, int argc, char **argv)
{
    if (verify->drawing || choice_given(&verify->wish) || verify->root || argc > 0)
        return fail(CHECK_FAILED, "--benchmark: alone, or with --threads");
    int result = arguments_check(&verify->drawn, argc, argv);
    return result ? CHECK_FAILED : benchmark_check(verify->benchmark, verify->drawn.simd, verify->drawn.threads);
}

static int run(struct verify *verify, int argc, char **argv)
{
    const char *why = choice_check(&verify->wish);

    if (verify->benchmark)
        return run_benchmark(verify, argc, argv);
    if (why)
        return fail(CHECK_FAILED, "%s", why);
    if (argc == 0)
        return fail(CHECK_FAILED, "no picture is named (tia-verify -h)");
    if (record_file_is(argv[argc > 1]))
        return run_record(verify, argc, argv);
    if (verify->root)
        return fail(CHECK_FAILED, "--root: is for records");
    struct checking_wish wish = {.choice = verify->wish, .out = stdout, .before = "", .from = ""};
    int result = checking_picture(&verify->drawn, argc - 1, argv + 1, argv[0], &wish);
    return fflush(stdout) == 0 ? result : fail_output();
}

int main(int argc, char **argv)
{
    static struct verify verify; /* too large for the stack */
    static const struct command command = {
        "tia-verify",
        "Usage: tia-verify PICTURE [SCENE] [options of tia, as drawn]\n"
        "       tia-verify RECORD\n"
        "       tia-verify PICTURE RECORD\n"
        "       tia-verify --benchmark LINE\n"
        "Draws random rows of a picture or film by tia again and compares their bits,\n"
        "without a threshold; or draws the picture that a record describes; or compares\n"
        "a picture with its record; or verifies a result of tia --benchmark.\n"
        "\n",
        rows,
        "\n"
        "All options of tia that the picture was drawn with must be given as well\n"
        "(tia -h). The size may be left out.\n"
        "\n"
        "Exit status: 0 all compared rows are as drawn, 1 something differs,\n"
        "2 an error.\n"};

    const struct command_extra extra = {tia_command.options, remember, &verify};

    signals_prepare();
    fail_as("tia-verify");
    arguments_default(&verify.drawn);
    int result = command_parse_extra(&command, &extra, &verify, &argc, &argv);
    return result == COMMAND_RUN ? run(&verify, argc, argv) : result;
}
