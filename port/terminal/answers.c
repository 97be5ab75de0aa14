#include "answers.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include "clock.h"
#include "console/guardian.h"
#include "descriptor.h"
#include "typed.h"
#include "window_signals.h"

#define ESC 0x1b
#define SIXEL_ATTRIBUTE 4
#define SIXEL_ITEM 2

enum { NUMBERS = 4 };
enum { GROUND, ESCAPE, CSI, SEQUENCE, MESSAGE, MESSAGE_ESCAPE };

/* Queries: for kitty's protocol, a picture of one pixel that the terminal only checks; for sixel, the largest picture
 * and the device's attributes. */
static const char ask_kitty[] = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\", ask_sixel[] = "\033[?2;1;0S\033[c";

static void begin(struct answers *a, uint8_t state)
{
    a->state = state;
    memset(a->numbers, 0, sizeof a->numbers);
    a->count = 0;
    a->has_sixel = false;
    a->length = 0;
}

/* Evaluates a sequence at its end. The limit's first number, 2, stands for sixel, the second for success. */
static void end_sequence(struct answers *a, uint8_t final)
{
    const uint16_t *n = a->numbers;

    if (final == 'c') {
        a->sixel |= a->has_sixel;
        a->complete = true;
    } else if (final == 'S' && a->count == NUMBERS && n[0] == SIXEL_ITEM && n[1] == 0) {
        a->limit = (struct limit){n[2], n[3]};
    }
    begin(a, GROUND);
}

static void after_number(struct answers *a, uint8_t byte)
{
    /* Numbers beyond the first four overwrite the fourth. */
    uint16_t *number = &a->numbers[a->count < NUMBERS ? a->count : NUMBERS - 1];

    if (byte >= '0' && byte <= '9') {
        *number = *number < 6000 ? (uint16_t)(*number * 10 + byte - '0') : *number;
        return;
    }
    a->has_sixel |= *number == SIXEL_ATTRIBUTE;
    a->count = (uint8_t)(a->count < NUMBERS ? a->count + 1 : NUMBERS);
    if (byte != ';')
        end_sequence(a, byte);
    else if (a->count == NUMBERS)
        a->numbers[NUMBERS - 1] = 0;
}

/* Evaluates kitty's message at its end: "Gi=31;OK" reports support; 31 is the query's number. */
static void after_message(struct answers *a, uint8_t byte)
{
    if (byte == ESC) {
        a->kitty |= a->length == sizeof a->message && memcmp(a->message, "Gi=31;OK", sizeof a->message) == 0;
        a->state = MESSAGE_ESCAPE;
    } else if (a->length < sizeof a->message) {
        a->message[a->length++] = (char)byte;
    }
}

void answers_byte(struct answers *a, uint8_t byte)
{
    switch (a->state) {
    case ESCAPE:
        begin(a, byte == '[' ? CSI : byte == '_' ? MESSAGE : byte == ESC ? ESCAPE : GROUND);
        break;
    case CSI:
        begin(a, byte == '?' ? SEQUENCE : byte == ESC ? ESCAPE : GROUND);
        break;
    case SEQUENCE:
        after_number(a, byte);
        break;
    case MESSAGE:
        after_message(a, byte);
        break;
    default:
        begin(a, byte == ESC ? ESCAPE : GROUND);
        break;
    }
}

static void read_answers(int fd, struct answers *answers)
{
    uint64_t end = clock_now_us() + ANSWERS_MS * UINT64_C(1000), now;
    uint8_t bytes[64];

    while (!answers->complete && (now = clock_now_us()) < end) {
        struct pollfd ready = {.fd = fd, .events = POLLIN};
        if (poll(&ready, 1, (int)((end - now) / 1000) + 1) <= 0)
            return;
        ssize_t n = read(fd, bytes, sizeof bytes);
        if (n <= 0 && errno != EAGAIN && errno != EINTR)
            return;
        if (n > 0)
            typed_keep(bytes, (size_t)n);
        for (ssize_t i = 0; i < n; i++)
            answers_byte(answers, bytes[i]);
    }
}

static bool say(int fd, const char *text)
{
    return terminal_write(fd, text, strlen(text)) == (ssize_t)strlen(text);
}

bool answers_multiplexer(const char *term)
{
    return !term || strncmp(term, "tmux", 4) == 0 || strncmp(term, "screen", 6) == 0;
}

static void ask(int fd, const char *term, struct answers *answers)
{
    if ((answers_multiplexer(term) || say(fd, ask_kitty)) && say(fd, ask_sixel))
        read_answers(fd, answers);
}

/* Queries the terminal in raw mode; keys typed meanwhile are stored for the keyboard input. If that input has set raw
 * mode already, the modes and the guardian's entry for them stay. */
static void ask_raw(int fd, const char *term, struct answers *answers)
{
    struct termios before, raw;

    if (tcgetattr(fd, &before) != 0)
        return;
    typed_forget();
    if (!(before.c_lflag & (tcflag_t)ICANON)) {
        ask(fd, term, answers);
        return;
    }
    raw = before;
    raw.c_lflag &= ~(tcflag_t)(ECHO | ICANON);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    (void)guardian_keep_terminal(fd, &raw);
    if (tcsetattr(fd, TCSANOW, &raw) == 0)
        ask(fd, term, answers);
    (void)tcsetattr(fd, TCSANOW, &before);
    guardian_forget_terminal(fd);
}

static enum pictures best(const struct answers *answers)
{
    enum pictures characters = answers->complete ? PICTURES_SYMBOLS : PICTURES_HALF_BLOCKS;

    return answers->kitty ? PICTURES_KITTY : answers->sixel ? PICTURES_SIXEL : characters;
}

enum pictures answers_ask(int fd, const char *term, struct limit *limit)
{
    struct answers answers = {0};
    int both = descriptor_copy(fd, O_RDWR);

    *limit = (struct limit){0};
    if (both < 0)
        return PICTURES_HALF_BLOCKS;
    terminal_signals_begin();
    if (tcgetpgrp(both) == getpgrp())
        ask_raw(both, term, &answers);
    terminal_signals_end();
    (void)close(both);
    *limit = answers.kitty ? (struct limit){0} : answers.limit;
    return best(&answers);
}
