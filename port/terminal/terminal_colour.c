/* terminal_colour.c - 24-bit colours, the 256 or 16 of terminals that have no more, and letters where there are none.
 */
#include "terminal_colour.h"

#include <string.h>

/* Colours of xterm's palette: from 16 a cube of 6 x 6 x 6 colours, from 232 the greys 8, 18, ... 238. */
#define CUBE 16
#define GREYS 232
#define GREY_COUNT 24
static const uint8_t cube_levels[6] = {0, 95, 135, 175, 215, 255};

struct rgb8 colour_expand(tia_rgb565 pixel)
{
    unsigned r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;

    return (struct rgb8){(uint8_t)(r << 3 | r >> 2), (uint8_t)(g << 2 | g >> 4), (uint8_t)(b << 3 | b >> 2)};
}

static unsigned square(int difference)
{
    return (unsigned)(difference * difference);
}

/* Returns the nearest level of the cube for one channel: the sum of squared differences is least if each square is. */
static unsigned nearest_level(uint8_t value)
{
    unsigned best = 0;

    for (unsigned i = 1; i < 6; i++)
        if (square(cube_levels[i] - value) < square(cube_levels[best] - value))
            best = i;
    return best;
}

/* Returns the nearest grey. Over the channels c, the sum of (c - g)^2 is 3 (g - mean)^2 plus a term without g. So the
 * nearest grey 8 + 10 k is the one nearest to the mean, sum/3: k is (sum - 24)/30, rounded to nearest. Adding 14 rounds
 * a half down. */
static unsigned nearest_grey(struct rgb8 c)
{
    unsigned sum = (unsigned)c.r + c.g + c.b;
    unsigned k = sum < 24 ? 0 : (sum - 24 + 14) / 30;

    return k < GREY_COUNT ? k : GREY_COUNT - 1;
}

static unsigned distance(struct rgb8 c, unsigned r, unsigned g, unsigned b)
{
    return square(c.r - (int)r) + square(c.g - (int)g) + square(c.b - (int)b);
}

uint8_t colour_nearest(struct rgb8 c)
{
    unsigned r = nearest_level(c.r), g = nearest_level(c.g), b = nearest_level(c.b);
    unsigned grey = nearest_grey(c), level = 8 + 10 * grey;

    if (distance(c, level, level, level) < distance(c, cube_levels[r], cube_levels[g], cube_levels[b]))
        return (uint8_t)(GREYS + grey);
    return (uint8_t)(CUBE + 36 * r + 6 * g + b);
}

static bool ends_with(const char *text, const char *end)
{
    size_t n = strlen(text), m = strlen(end);

    return n >= m && strcmp(text + n - m, end) == 0;
}

/* True if COLORTERM reports 24-bit colours, as it does on most terminals, or if the terminal's name does: ssh and sudo
 * drop COLORTERM. */
bool colour_is_direct(const char *term, const char *colorterm)
{
    static const char *const known[] = {"alacritty", "foot", "wezterm", "xterm-ghostty", "xterm-kitty"};

    if (colorterm && (strcmp(colorterm, "truecolor") == 0 || strcmp(colorterm, "24bit") == 0))
        return true;
    if (!term)
        return false;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(term, known[i]) == 0)
            return true;
    return ends_with(term, "-direct");
}

/* True for terminals that are known to have 16 colours; others have 256, or show the nearest of theirs. */
static bool has_sixteen(const char *term)
{
    return strcmp(term, "ansi") == 0 || strcmp(term, "cygwin") == 0 || ends_with(term, "-16color");
}

bool terminal_is_dumb(const char *term)
{
    return !term || !*term || strcmp(term, "dumb") == 0;
}

bool terminal_is_dec(const char *term)
{
    return strncmp(term, "vt", 2) == 0 && term[2] >= '1' && term[2] <= '4';
}

/* True for terminals that terminfo has without colours: DEC's up to the VT420, monochrome variants, and those that are
 * not known. */
static bool has_none(const char *term)
{
    return terminal_is_dumb(term) || terminal_is_dec(term) || ends_with(term, "-m") || ends_with(term, "-mono");
}

enum colours colours_of(const char *term, const char *colorterm)
{
    if (colour_is_direct(term, colorterm))
        return COLOURS_DIRECT;
    if (has_none(term))
        return COLOURS_NONE;
    if (strcmp(term, "linux") == 0)
        return COLOURS_CONSOLE;
    return has_sixteen(term) ? COLOURS_16 : COLOURS_256;
}

/* Returns 10,000 times the luma of a pixel, whose channels are 0..255. */
static unsigned luma(tia_rgb565 pixel)
{
    struct rgb8 c = colour_expand(pixel);

    return 2126u * c.r + 7152u * c.g + 722u * c.b;
}

char colour_letter(tia_rgb565 upper, tia_rgb565 lower)
{
    static const char letters[] = " .:-=+*#%@"; /* the more ink the later */

    return letters[(luma(upper) + luma(lower)) * (sizeof letters - 1) / (2u * 10000u * 256u)];
}

/* Returns one of the 16: bits 0 to 2 are red, green and blue, bit 3 is bright. */
static struct rgb8 first_colour(enum colours colours, unsigned index)
{
    static const struct rgb8 xterm[] = {{0, 0, 0},       {205, 0, 0},   {0, 205, 0},   {205, 205, 0},
                                        {0, 0, 238},     {205, 0, 205}, {0, 205, 205}, {229, 229, 229},
                                        {127, 127, 127}, {255, 0, 0},   {0, 255, 0},   {255, 255, 0},
                                        {92, 92, 255},   {255, 0, 255}, {0, 255, 255}, {255, 255, 255}};
    unsigned low = index & 8 ? 85 : 0, high = low + 170;

    if (colours == COLOURS_16)
        return xterm[index];
    if (index == 3)
        return (struct rgb8){170, 85, 0}; /* brown */
    return (struct rgb8){(uint8_t)(index & 1 ? high : low), (uint8_t)(index & 2 ? high : low),
                         (uint8_t)(index & 4 ? high : low)};
}

unsigned colour_code(unsigned index, bool background)
{
    return (background ? 40 : 30) + (index < 8 ? index : 60 + index - 8);
}

struct rgb8 colour_indexed(enum colours colours, unsigned index)
{
    unsigned grey = 8 + 10 * (index - GREYS), cube = index - CUBE;

    if (colours != COLOURS_256)
        return first_colour(colours, index & 15);
    if (index >= GREYS)
        return (struct rgb8){(uint8_t)grey, (uint8_t)grey, (uint8_t)grey};
    return (struct rgb8){cube_levels[cube / 36], cube_levels[cube / 6 % 6], cube_levels[cube % 6]};
}
