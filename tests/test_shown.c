/* test_shown.c - strips of sixel pictures: one is sent if and only if the window does not show it. */
#include "check.h"
#include "random.h"
#include "terminal/shown.h"

enum { MOST = 64 * 60 };

static struct canvas canvas;
static struct shown shown;
static tia_rgb565 window[MOST]; /* what the terminal shows */

static unsigned below(unsigned n)
{
    return (unsigned)(random_bits() % n);
}

static bool is_shown(struct strip strip)
{
    size_t first = (size_t)strip.first * canvas.width, bytes = (size_t)strip.rows * canvas.width * sizeof *window;

    return !memcmp(window + first, canvas.pixels + first, bytes);
}

static void put(struct strip strip)
{
    size_t first = (size_t)strip.first * canvas.width;

    memcpy(window + first, canvas.pixels + first, (size_t)strip.rows * canvas.width * sizeof *window);
}

/* Sends a frame in strips; all of them if nothing is known of the window. Returns how many. */
static unsigned send(unsigned rows, bool known)
{
    unsigned sent = 0;

    for (unsigned y = 0; y < canvas.height; y += rows) {
        struct strip strip = {y, canvas.height - y < rows ? canvas.height - y : rows};
        bool changed = shown_update(&shown, &canvas, strip);
        CHECK(changed == (!known || !is_shown(strip)));
        if (changed)
            put(strip);
        sent += changed;
    }
    CHECK(!memcmp(window, canvas.pixels, (size_t)canvas.width * canvas.height * sizeof *window));
    return sent;
}

static void change(unsigned pixels)
{
    for (; pixels > 0; pixels--)
        canvas.pixels[below((unsigned)canvas.width * canvas.height)] ^= 1;
}

static void try(uint16_t width, uint16_t height, unsigned rows)
{
    bool known = false;

    CHECK_EQ(canvas_resize(&canvas, width, height), TIA_OK);
    CHECK_EQ(shown_resize(&shown, &canvas), TIA_OK);
    memset(window, 0x77, sizeof window);
    for (unsigned frame = 0; frame < 60; frame++, known = true) {
        change(below(4));
        if (frame % 20 == 19) { /* the shell has used the window */
            memset(window, 0x77, sizeof window);
            shown_forget(&shown);
            known = false;
        }
        (void)send(rows, known);
    }
    CHECK_EQ(send(rows, true), 0);
    canvas.pixels[width * height - 1] ^= 1;
    CHECK_EQ(send(rows, true), 1);
}

TEST(strips_are_sent_when_they_change)
{
    try(64, 60, 6);
    try(61, 59, 12);
    try(1, 1, 6);
    try(7, 30, 30);
    shown_free(&shown);
}

/* Kitty's pictures and symbols keep nothing: whoever asks is told to send. */
TEST(without_memory_all_is_sent)
{
    CHECK_EQ(canvas_resize(&canvas, 8, 12), TIA_OK);
    for (int i = 0; i < 3; i++)
        CHECK(shown_update(&shown, &canvas, (struct strip){6, 6}));
    shown_forget(&shown);
    shown_free(&shown);
    canvas_free(&canvas);
}

int main(void)
{
    RUN(strips_are_sent_when_they_change);
    RUN(without_memory_all_is_sent);
    return check_status();
}
