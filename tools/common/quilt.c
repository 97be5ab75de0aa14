#include "quilt.h"

#include <ctype.h>
#include <string.h>

#include <tia/render.h>

#include "parse.h"

enum { VIEW_HEIGHT = 480, ASPECT_MAX = 100000 };

/* Returns the thousandths in a number like "1.777", rounded down; the dot of a file's extension may follow it. Returns
 * 0 if the text is not a number. */
static uint32_t thousandths(const char *text)
{
    const char *rest;
    uint32_t whole, part = 0, digit = 100;

    if (!parse_number(text, &rest, 0, ASPECT_MAX / 1000, &whole))
        return 0;
    if (*rest == '.' && isdigit((unsigned char)rest[1]))
        for (rest++; isdigit((unsigned char)*rest); rest++, digit /= 10)
            part += (uint32_t)(*rest - '0') * digit;
    return *rest == '.' || *rest == '\0' ? whole * 1000 + part : 0;
}

/* Returns the last "_qs" in the file's name; NULL if there is none. */
static const char *find_mark(const char *path)
{
    const char *slash = strrchr(path, '/'), *mark = NULL;

    for (const char *at = slash ? slash : path; (at = strstr(at, "_qs")) != NULL; at++)
        mark = at;
    return mark;
}

bool quilt_named(const char *path, struct tia_quilt *quilt, uint32_t *aspect)
{
    const char *mark = find_mark(path), *rest;
    uint32_t columns, rows;

    if (!mark || !parse_number(mark + 3, &rest, 1, TIA_QUILT_MAX, &columns) || *rest != 'x' ||
        !parse_number(rest + 1, &rest, 1, TIA_QUILT_MAX, &rows) || *rest != 'a')
        return false;
    *quilt = (struct tia_quilt){(uint16_t)columns, (uint16_t)rows};
    *aspect = thousandths(rest + 1);
    return *aspect != 0;
}

void quilt_size(const struct tia_quilt *quilt, uint32_t aspect, uint16_t *width, uint16_t *height)
{
    uint32_t most = (uint32_t)TIA_SIZE_MAX / quilt->columns;
    uint32_t high = (uint32_t)TIA_SIZE_MAX / quilt->rows;
    high = high < VIEW_HEIGHT ? high : VIEW_HEIGHT;
    uint32_t wide = (high * aspect + 500) / 1000;

    if (wide > most) {
        wide = most;
        high = (wide * 1000 + aspect / 2) / aspect;
    }
    *width = (uint16_t)((wide ? wide : 1) * quilt->columns);
    *height = (uint16_t)((high ? high : 1) * quilt->rows);
}
