/* test_answers.c - a terminal's answers about the pictures that it can show. */
#include "check.h"
#include "terminal/answers.h"

static struct answers heard(const char *text)
{
    struct answers a = {0};

    for (const char *c = text; *c; c++)
        answers_byte(&a, (uint8_t)*c);
    return a;
}

static void check_heard(const char *text, bool sixel, bool kitty, bool complete)
{
    struct answers a = heard(text);

    CHECK_MSG(a.sixel == sixel && a.kitty == kitty && a.complete == complete, "%s: %d %d %d", text + 1, a.sixel,
              a.kitty, a.complete);
}

#define KITTY_OK "\033_Gi=31;OK\033\\"

TEST(what_terminals_answer)
{
    check_heard("\033[?63;1;2;4;6;9;15;22c", true, false, true);
    check_heard("\033[?62;4c", true, false, true);
    check_heard("\033[?64;1;2;6;9;14;24;44c", false, false, true);
    check_heard("\033[?1;2c", false, false, true);
    check_heard("\033[?6c", false, false, true);
    check_heard("\033[?62;4", false, false, false);
    check_heard("\033[62;4c", false, false, false);
    check_heard(KITTY_OK "\033[?62;c", false, true, true);
    check_heard(KITTY_OK, false, true, false);
    check_heard("\033_Gi=31;ENOENT\033\\\033[?62;4c", true, false, true);
    check_heard("\033_Gi=30;OK\033\\\033[?62c", false, false, true);
    check_heard("ab\033\033[?62;4;99999999999999c", true, false, true);
    check_heard("\033[A\033[?62;65540c", false, false, true);
}

TEST(largest_pictures_that_terminals_answer)
{
    static const struct {
        const char *text;
        unsigned width, height;
    } rows[] = {
        {"\033[?2;0;1000;800S\033[?62;4c", 1000, 800}, /* as xterm answers */
        {"\033[?2;3;0S\033[?62;4c", 0, 0},             /* failure */
        {"\033[?1;0;256;4S\033[?62;4c", 0, 0},         /* registers of colours */
        {"\033[?2;0;1000;800c", 0, 0},
        {"\033[2;0;1000;800S", 0, 0},
    };

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct limit limit = heard(rows[i].text).limit;
        CHECK_MSG(limit.width == rows[i].width && limit.height == rows[i].height, "row %zu: %u x %u", i, limit.width,
                  limit.height);
    }
    check_heard("\033[?2;0;4;4S", false, false, false);
    check_heard("\033[?2;0;4;4S\033[?62c", false, false, true);
}

int main(void)
{
    RUN(what_terminals_answer);
    RUN(largest_pictures_that_terminals_answer);
    return check_status();
}
