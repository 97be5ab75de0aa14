/* The strips in which pictures are sent to terminals. */
#include "check.h"
#include "terminal/pictures.h"

#ifdef TIA_HAVE_CHAFA
/* Checks that strips cover a picture, that none is large, and that each begins at a row of cells and, for sixels, of
 * bands. */
static void check_strips(enum pictures pictures, struct cell size, unsigned width, unsigned height)
{
    unsigned end = 0, count = 0;

    while (end < height) {
        struct strip strip = pictures_strip(pictures, &size, end, width, height);
        CHECK_EQ(strip.first, end);
        CHECK(strip.rows > 0 && end + strip.rows <= height);
        end += strip.rows;
        CHECK(end == height || (end % size.height == 0 && (pictures != PICTURES_SIXEL || strip.rows % 6 == 0)));
        CHECK(strip.rows * width <= 600000 || strip.rows <= 6 * size.height);
        count++;
    }
    CHECK_EQ(end, height);
    CHECK_MSG(count > 1 || width * height <= 600000, "one strip of %ux%u", width, height);
}

TEST(strips)
{
    for (enum pictures p = PICTURES_SYMBOLS; p <= PICTURES_KITTY; p++)
        for (unsigned high = 6; high < 40; high++) {
            check_strips(p, (struct cell){high / 2, high}, 3840, 2160);
            check_strips(p, (struct cell){high / 2, high}, 800, 480);
            check_strips(p, (struct cell){high / 2, high}, 7, 37);
            check_strips(p, (struct cell){high / 2, high}, 1, 6);
        }
}
#else
TEST(strips)
{
    SKIP("built without libchafa (libchafa-dev)");
}
#endif

int main(void)
{
    RUN(strips);
    return check_status();
}
