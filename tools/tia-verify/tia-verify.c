/* tia-verify - draws a part of a picture again and compares its bits; see tia-verify(1). */
#include <stdio.h>
#include <string.h>

#include "common/signals.h"
#include "common/verify/choice.h"
#include "tia/arguments.h"
#include "tia/checking.h"
#include "tia/fail.h"

/* The options of tia come first: their rows have offsets in struct options. */
struct verify {
    struct options drawn;
    struct choice_wish wish;
};

static const struct option_row rows[] = {CHOICE_ROWS(struct verify, wish), OPTION_END};

static int run(struct verify *verify, int argc, char **argv)
{
    const char *why = choice_check(&verify->wish);

    if (why)
        return fail(CHECK_FAILED, "%s", why);
    if (argc == 0)
        return fail(CHECK_FAILED, "no picture is named (tia-verify -h)");
    return checking_picture(&verify->drawn, argc - 1, argv + 1, argv[0], &verify->wish, "");
}

int main(int argc, char **argv)
{
    static struct verify verify; /* too large for the stack */
    static const struct command command = {
        "tia-verify",
        "Usage: tia-verify PICTURE [SCENE] [options of tia, as drawn]\n"
        "Draws random rows of a picture or film by tia again and compares their bits, without a threshold.\n"
        "\n",
        rows,
        "\n"
        "All options of tia that the picture was drawn with must be given as well (tia -h). The size may be\n"
        "left out.\n"
        "\n"
        "Exit status: 0 all compared rows are as drawn, 1 something differs, 2 an error.\n"};

    const struct command_extra extra = {.more = tia_command.options};

    signals_prepare();
    fail_as("tia-verify");
    arguments_default(&verify.drawn);
    int result = command_parse_extra(&command, &extra, &verify, &argc, &argv);
    return result == COMMAND_RUN ? run(&verify, argc, argv) : result;
}
