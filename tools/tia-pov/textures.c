#include "pov.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool pov_textured(const struct pov *pov, uint32_t material)
{
    const struct tia_material *m = &pov->scene->materials[material];

    return m->texture != 0 && !pov_black(m->colour);
}

static const struct tia_texture *texture_of(const struct pov *pov, uint32_t material)
{
    return &pov->scene->textures[pov->scene->materials[material].texture - 1];
}

/* Writes the picture for a material: the texels times its colour, 16 bits per channel. */
static int write_texels(struct text *text, const struct tia_texture *t, struct point colour)
{
    const double factor[3] = {colour.x * 257, colour.y * 257, colour.z * 257};

    text_print(text, "P6\n%d %d\n65535\n", t->width, t->height);
    for (size_t i = 0; i < (size_t)3 * t->width * t->height; i++) {
        unsigned value = (unsigned)(t->texels[i] * factor[i % 3] + 0.5);
        const unsigned char bytes[2] = {(unsigned char)(value >> 8), (unsigned char)value};
        (void)sink_write(&text->sink, bytes, sizeof bytes);
    }
    return text_close(text);
}

/* FILE-N.ppm for FILE.pov. */
static char *picture_path(const struct pov *pov, uint32_t material)
{
    size_t length = strlen(pov->path);
    char *path = malloc(length + 16);

    if (length > 4 && strcmp(pov->path + length - 4, ".pov") == 0)
        length -= 4;
    if (path)
        (void)snprintf(path, length + 16, "%.*s-%u.ppm", (int)length, pov->path, material);
    return path;
}

/* Writes a string literal of POV-Ray, with backslashes before backslashes and quotes. */
static void write_string(struct text *text, const char *string)
{
    text_print(text, "\"");
    for (; *string != '\0'; string++)
        text_print(text, *string == '"' || *string == '\\' ? "\\%c" : "%c", *string);
    text_print(text, "\"");
}

static void write_image(struct pov *pov, uint32_t material, double transmit)
{
    const struct tia_texture *t = texture_of(pov, material);
    char *path = picture_path(pov, material);
    struct text picture;

    if (!path || text_open(&picture, path, pov->why) ||
        write_texels(&picture, t, pov_rgb(pov->scene->materials[material].colour))) {
        pov->failed = true;
    } else {
        const char *slash = strrchr(path, '/');
        text_word(&pov->text, "image_map { ppm ");
        write_string(&pov->text, slash ? slash + 1 : path);
        text_word(&pov->text, "gamma 1.0 %s transmit all %.10g }", t->bilinear ? "interpolate 2" : "", transmit);
    }
    free(path);
}

static void write_checker(struct pov *pov, uint32_t material, double transmit)
{
    const struct tia_texture *t = texture_of(pov, material);
    struct point colour = pov_rgb(pov->scene->materials[material].colour);

    for (int i = 0; i < 2; i++) {
        struct point cell = pov_rgb(t->cells[i]);
        cell = (struct point){cell.x * colour.x, cell.y * colour.y, cell.z * colour.z};
        pov_triple(pov, i == 0 ? "checker rgb" : ", rgb", cell);
        text_word(&pov->text, "transmit %.10g", transmit);
    }
    /* POV-Ray's checkers are cubes: put the surface in the middle of a layer. */
    text_word(&pov->text, "translate <0, 0, -0.5>");
}

bool pov_texture(struct pov *pov, uint32_t material, double transmit)
{
    const struct tia_texture *t = texture_of(pov, material);

    if (t->kind == TIA_IMAGE && strcmp(pov->path, "-") == 0) {
        pov_note(pov, "material %u: no texture here: a picture needs a file beside the scene's", material);
        return false;
    }
    text_word(&pov->text, "pigment {");
    if (t->kind == TIA_IMAGE)
        write_image(pov, material, transmit);
    else
        write_checker(pov, material, transmit);
    text_word(&pov->text, "scale <%.10g, %.10g, 1>", 1 / pov_q16(t->repeat[0]), 1 / pov_q16(t->repeat[1]));
    if (t->offset[0] != 0 || t->offset[1] != 0)
        pov_triple(pov, "translate", (struct point){pov_q16(t->offset[0]), pov_q16(t->offset[1]), 0});
    text_word(&pov->text, "}");
    return true;
}

bool pov_closes(const struct pov *pov, uint32_t material)
{
    const struct tia_texture *t = texture_of(pov, material);
    int32_t period = t->kind == TIA_CHECKER ? 2 * TIA_Q16_ONE : TIA_Q16_ONE;

    return t->repeat[0] % period == 0;
}
