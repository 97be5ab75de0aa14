#include "verify_parts.h"

#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/message.h"
#include "tia/arguments.h"
#include "tia/checking.h"
#include "tia/fail.h"

enum { NODE = 100 };

void verify_split(struct verify_wish *wish, int *argc, char **argv)
{
    static char name[] = "tia-join";
    bool asked = false;
    int at = 1;

    for (; at < *argc && strcmp(argv[at], "--") != 0; at++)
        asked = asked || strcmp(argv[at], "--verify") == 0;
    if (!asked || at >= *argc)
        return;
    wish->argc = *argc - at;
    wish->argv = argv + at;
    argv[at] = name;
    *argc = at;
}

/* Reads the name of the node that drew a part: the first line of PART.node. Writes ", drawn by NAME", or "" without. */
static void read_node(const char *part, char from[NODE + 32])
{
    char *path = NULL, name[NODE + 1] = "";
    int fd = asprintf(&path, "%s.node", part) >= 0 ? open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY) : -1;

    from[0] = '\0';
    if (fd >= 0 && read(fd, name, NODE) > 0) {
        name[strcspn(name, "\n")] = '\0';
        message_clean(name);
        (void)snprintf(from, NODE + 32, ", drawn by %s", name);
    }
    if (fd >= 0)
        (void)close(fd);
    free(path);
}

/* Parses what follows --. */
static int parse(struct options *drawn, const struct verify_wish *wish, int *argc, char ***argv)
{
    struct command command = tia_command;

    command.name = "tia-join";
    *argc = wish->argc;
    *argv = wish->argv;
    arguments_default(drawn);
    if (command_parse(&command, drawn, argc, argv) != COMMAND_RUN)
        return -1;
    if (*argc && strcmp(**argv, "-") == 0)
        return message("tia-join", -1, "--verify: standard input is no SCENE for several parts");
    return 0;
}

static int verify_all(const struct verify_wish *wish, char *const *parts, int count)
{
    struct checking_wish checking = {.choice = wish->choice, .out = stderr, .before = "tia-join: ", .quiet = true};
    static struct options drawn; /* too large for the stack */
    char from[NODE + 32], **argv;
    int argc, worst = parse(&drawn, wish, &argc, &argv) ? CHECK_FAILED : CHECK_SAME;

    for (int i = 0; i < count && worst != CHECK_FAILED; i++) {
        read_node(parts[i], from);
        checking.from = from;
        int status = checking_picture(&drawn, argc, argv, parts[i], &checking);
        worst = status > worst ? status : worst;
    }
    if (worst)
        return -1;
    return message("tia-join", 0, "%d part%s verified, %" PRIu64 " rows drawn again", count, count == 1 ? "" : "s",
                   checking.seen);
}

int verify_parts(const struct verify_wish *wish, char *const *parts, int count)
{
    const struct choice_wish *choice = &wish->choice;
    const char *why = choice_check(choice);

    fail_as("tia-join");
    if (why)
        return message("tia-join", -1, "%s", why);
    if (!wish->asked)
        return choice_given(choice)
                   ? message("tia-join", -1, "--share, --count, --rows, --all and --seed: are for --verify")
                   : 0;
    if (!wish->argc)
        return message("tia-join", -1, "--verify: SCENE and the options of tia, as drawn, follow -- (tia-join -h)");
    return verify_all(wish, parts, count);
}
