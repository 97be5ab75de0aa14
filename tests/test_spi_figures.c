/* test_spi_figures.c - the bytes that keys and arrows of the built-in scene take on an SPI panel: with --table, the
 * rows of the table in docs/boards.md, which tools/generate/counted.py writes. */
#include "spi_picture.h"

enum { KEYS = 4, COLUMNS = KEYS + 1 };

/* Strips, and pixels that are compared at once; 0: the whole frame is sent. */
static const struct way {
    unsigned columns, rows, block;
} ways[] = {{W, 4, 0}, {64, 8, 64}, {160, 4, 32}, {160, 4, 16}, {W, 4, 1}, {160, 4, 1}};

enum { WAYS = sizeof ways / sizeof *ways };

/* The least and the most that is sent. */
struct range {
    size_t least, most;
};

static void widen(struct range *range, size_t bytes)
{
    range->least = !range->most || bytes < range->least ? bytes : range->least;
    range->most = bytes > range->most ? bytes : range->most;
}

/* Sends the picture, which the panel does not show yet, and compares the bytes with those computed. */
static size_t press(struct tia_spi_panel *panel, const struct way *way)
{
    size_t want = bytes_of_change(way->columns, way->rows, way->block), sent = bytes_sent(panel);

    CHECK_MSG(sent == want, "%zu bytes, not %zu", sent, want);
    return sent;
}

/* Fills in the bytes of each key, when another key's light or none is shown, and those of an arrow after any key. */
static void measure(const struct way *way, struct range ranges[COLUMNS])
{
    struct tia_spi_panel panel = make_changing(way->columns, way->rows, way->block);
    struct tia_mode mode;

    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_OK);
    for (unsigned from = 0; from <= KEYS; from++)
        for (unsigned to = 0; to < KEYS + 2; to++) {
            bool arrow = to >= KEYS;
            if (from == to || (from == KEYS && arrow))
                continue;
            if (from < KEYS)
                show_key(from, 0);
            else
                draw_picture(NULL);
            (void)bytes_sent(&panel);
            show_key(arrow ? from : to, to == KEYS ? -1 : to > KEYS);
            widen(&ranges[arrow ? KEYS : to], press(&panel, way));
        }
    CHECK_EQ(model.disturbed, 0);
    tia_spi_panel_changes.close(&panel);
}

/* All of it, with eleven bytes for the place of each strip. */
static size_t whole(const struct way *way)
{
    return 2 * (size_t)PIXELS + 11 * (size_t)(W / way->columns * (H / way->rows));
}

static void print_row(const struct way *way)
{
    struct range ranges[COLUMNS] = {{0, 0}};

    if (way->block)
        measure(way, ranges);
    else
        for (int i = 0; i < COLUMNS; i++)
            widen(&ranges[i], whole(way));
    (void)printf("| %ux%u | ", way->columns, way->rows);
    if (way->block)
        (void)printf("%u | %zu |", way->block, tia_damage_size(W, H, way->block));
    else
        (void)printf("all is sent | 0 |");
    for (int i = 0; i < COLUMNS; i++)
        if (ranges[i].least == ranges[i].most)
            (void)printf(" %zu |", ranges[i].least);
        else
            (void)printf(" %zu to %zu |", ranges[i].least, ranges[i].most);
    (void)printf("\n");
}

TEST(less_than_a_frame)
{
    for (int n = 1; n < WAYS; n++) {
        struct range ranges[COLUMNS] = {{0, 0}};
        measure(&ways[n], ranges);
        for (int i = 0; i < COLUMNS; i++)
            CHECK(ranges[i].least > 0 && ranges[i].most < whole(&ways[n]) * 3 / 5);
    }
}

int main(int argc, char **argv)
{
    if (argc > 1 && !strcmp(argv[1], "--table")) {
        for (int n = 0; n < WAYS; n++)
            print_row(&ways[n]);
        return check_status();
    }
    RUN(less_than_a_frame);
    return check_status();
}
