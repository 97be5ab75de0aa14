#include "label.h"

#include <string.h>

/* Squares from one letter to the next, and of the label from top to bottom. */
enum { LETTER_COLUMNS = 4, LABEL_ROWS = 7 };

/* Five rows of three squares, from the top, in octal. */
static const uint16_t letters[26] = {025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227,
                                     011152, 055655, 044447, 057755, 065555, 025552, 065644, 025573, 065655,
                                     034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247};
static const uint16_t digits[10] = {075557, 026227, 061247, 061216, 055711, 074616, 074757, 071122, 075757, 075717};

static unsigned glyph(char c)
{
    if (c >= 'a' && c <= 'z')
        return letters[c - 'a'];
    if (c >= '0' && c <= '9')
        return digits[c - '0'];
    return c == '.' ? 000002 : c == '-' ? 000700 : 0;
}

/* Pixels of a square's side: a label is legible, and at most a 22nd of the picture's height unless that is small. */
static unsigned square(unsigned height)
{
    return height / 160 > 1 ? height / 160 : 1;
}

static uint16_t cut_off(size_t value, unsigned limit)
{
    return (uint16_t)(value < limit ? value : limit);
}

struct tia_tile label_area(const char *text, unsigned width, unsigned height)
{
    size_t side = square(height);

    return (struct tia_tile){0, 0, cut_off((LETTER_COLUMNS * strlen(text) + 1) * side, width),
                             cut_off(LABEL_ROWS * side, height)};
}

bool label_is_ink(const char *text, unsigned height, unsigned x, unsigned y)
{
    unsigned column = x / square(height), row = y / square(height);
    size_t letter = (column - 1) / LETTER_COLUMNS;
    unsigned inside = (column - 1) % LETTER_COLUMNS;

    if (column == 0 || row == 0 || row > 5 || inside == LETTER_COLUMNS - 1 || letter >= strlen(text))
        return false;
    return glyph(text[letter]) >> (3 * (5 - row) + 2 - inside) & 1;
}
