/* test_changes.c - pages that receive only what they lack of a canvas always show it, in whatever order they are drawn;
 * and a frame in which little has changed takes few copies. */
#include "check.h"
#include "pixels/changes.h"
#include "random.h"

enum { MOST = 90 * 70 };

static tia_rgb565 pages[CHANGES_PAGES][MOST];
static struct canvas canvas;
static struct changes changes;
static size_t copied;

static unsigned below(unsigned n)
{
    return (unsigned)(random_bits() % n);
}

static void change(unsigned rectangles)
{
    for (; rectangles > 0; rectangles--) {
        unsigned x0 = below(canvas.width), y0 = below(canvas.height), colour = below(3);
        unsigned x1 = x0 + 1 + below(canvas.width - x0), y1 = y0 + 1 + below(canvas.height - y0);
        for (unsigned y = y0; y < y1; y++)
            for (unsigned x = x0; x < x1; x++)
                canvas.pixels[y * canvas.width + x] = (tia_rgb565)colour;
    }
}

/* Brings a page up to date. Returns the number of pixels that are wrong then. */
static unsigned show(unsigned page)
{
    struct tia_tile area;
    unsigned wrong = 0;

    copied = 0;
    for (unsigned band = 0; band < changes.bands; band++) {
        if (!changes_take(&changes, page, band, &area))
            continue;
        CHECK(tile_inside(area, canvas.width, canvas.height));
        copied += (size_t)area.width * area.height;
        for (unsigned y = area.y; y < (unsigned)area.y + area.height; y++)
            memcpy(pages[page] + y * canvas.width + area.x, canvas.pixels + y * canvas.width + area.x,
                   area.width * sizeof **pages);
    }
    for (unsigned i = 0; i < (unsigned)canvas.width * canvas.height; i++)
        wrong += pages[page][i] != canvas.pixels[i];
    return wrong;
}

static void begin(uint16_t width, uint16_t height)
{
    CHECK_EQ(canvas_resize(&canvas, width, height), TIA_OK);
    CHECK_EQ(changes_resize(&changes, &canvas), TIA_OK);
    memset(pages, 0x77, sizeof pages);
}

static void end(void)
{
    changes_free(&changes);
    canvas_free(&canvas);
    CHECK(!changes.shown && !changes.lacks && changes.bands == 0);
}

TEST(pages_show_the_canvas)
{
    static const uint16_t sizes[][2] = {{1, 1}, {90, 70}, {33, 16}, {16, 17}, {2, 3000}};

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        begin(sizes[i][0], sizes[i][1]);
        CHECK(changes.bands <= CHANGES_BANDS && changes.bands * changes.rows >= sizes[i][1]);
        for (unsigned frame = 0; frame < 100; frame++) {
            unsigned page = frame < 40 ? frame & 1 : frame < 60 ? 0 : below(2);
            change(below(3));
            if (frame % 17 == 16) { /* another program has drawn over both */
                memset(pages, 0x77, sizeof pages);
                changes_forget(&changes);
            }
            changes_find(&changes, &canvas);
            CHECK_MSG(show(page) == 0, "%ux%u, frame %u", canvas.width, canvas.height, frame);
        }
        end();
    }
}

TEST(little_is_copied)
{
    begin(90, 70);
    for (unsigned page = 0; page < CHANGES_PAGES; page++) {
        changes_find(&changes, &canvas);
        CHECK_EQ(show(page), 0);
        CHECK_EQ(copied, 90 * 70);
    }
    canvas.pixels[40 * 90 + 7] ^= 1;
    changes_find(&changes, &canvas);
    CHECK_EQ(show(0), 0);
    CHECK_EQ(copied, 1);
    canvas.pixels[44 * 90 + 10] ^= 1; /* of the same band: page 1 lacks both, and what is between them */
    changes_find(&changes, &canvas);
    CHECK_EQ(show(1), 0);
    CHECK_EQ(copied, 5 * 4);
    CHECK_EQ(show(0), 0);
    CHECK_EQ(copied, 1);
    changes_find(&changes, &canvas);
    CHECK_EQ(show(0), 0);
    CHECK_EQ(copied, 0);
    end();
}

int main(void)
{
    RUN(pages_show_the_canvas);
    RUN(little_is_copied);
    return check_status();
}
