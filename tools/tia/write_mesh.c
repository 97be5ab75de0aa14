/* write_mesh.c - numbers and meshes in .tia. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "write.h"

/* Ten digits behind the point are read again exactly: they differ from a multiple of 2^-32 by less than half of it. */
#define DIGITS 10

static void write_number(struct text *text, double number, int decimals)
{
    char digits[128];
    int length = snprintf(digits, sizeof digits, "%.*f", decimals, number);

    while (decimals > 0 && digits[length - 1] == '0')
        length--;
    length -= decimals > 0 && digits[length - 1] == '.';
    text_print(text, " %.*s", length, digits);
}

void write_numbers(struct text *text, const char *word, const int32_t *numbers, unsigned count, unsigned bits)
{
    text_print(text, "%s", word);
    for (unsigned i = 0; i < count; i++)
        write_number(text, ldexp(numbers[i], -(int)bits), DIGITS);
}

void write_exactly(struct text *text, double number)
{
    write_number(text, number, 60);
}

/* Returns the fewest decimals from which a number of Q2.30 is read again. */
static int decimals_for(int32_t number)
{
    int decimals = 0;

    for (; decimals < DIGITS; decimals++) {
        double unit = pow(10, decimals), shown = round(ldexp(number, -30) * unit) / unit;
        if (round(ldexp(shown, 30)) == number)
            break;
    }
    return decimals;
}

void write_rgb(struct text *text, const char *word, struct tia_rgb colour, unsigned bits)
{
    const int32_t channels[] = {colour.r, colour.g, colour.b};

    text_print(text, "%s", word);
    for (int i = 0; i < (colour.r == colour.g && colour.g == colour.b ? 1 : 3); i++)
        write_number(text, ldexp(channels[i], (int)bits - 30), bits ? DIGITS : decimals_for(channels[i]));
}

static void write_corner(struct text *text, const struct tia_corner *corner)
{
    text_print(text, " %u", corner->vertex + 1);
    if (corner->uv != TIA_NO_INDEX)
        text_print(text, "/%u", corner->uv + 1);
    if (corner->normal != TIA_NO_INDEX)
        text_print(text, corner->uv != TIA_NO_INDEX ? "/%u" : "//%u", corner->normal + 1);
}

void write_mesh(struct text *text, const struct tia_mesh *m)
{
    for (uint32_t i = 0; i < m->vertex_count; i++) {
        write_numbers(text, "vertex", &m->vertices[i].x, 3, 16);
        text_print(text, "\n");
    }
    for (uint32_t i = 0; i < m->normal_count; i++) {
        write_numbers(text, "normal", &m->normals[i].x, 3, 30);
        text_print(text, "\n");
    }
    for (uint32_t i = 0; i < m->uv_count; i++) {
        write_numbers(text, "uv", &m->uvs[i].u, 2, 16);
        text_print(text, "\n");
    }
    for (uint32_t i = 0; i < m->face_count; i++) {
        if (m->groups && (i == 0 || m->groups[i] != m->groups[i - 1]))
            text_print(text, "group %u\n", m->groups[i]);
        text_print(text, "face");
        for (int k = 0; k < 3; k++)
            write_corner(text, &m->faces[i].corner[k]);
        text_print(text, "\n");
    }
}
