#include "pov.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool pov_coloured(const struct pov *pov, uint32_t material)
{
    const struct tia_material *m = &pov->scene->materials[material];

    return m->texture != 0 && !pov_black(m->colour) && pov->scene->textures[m->texture - 1].kind != TIA_NOISE;
}

bool pov_has_opacity(const struct pov *pov, uint32_t material)
{
    return pov->scene->materials[material].opacity != 0 && strcmp(pov->path, "-") != 0;
}

bool pov_textured(const struct pov *pov, uint32_t material)
{
    return pov_coloured(pov, material) || pov_has_opacity(pov, material);
}

static const struct tia_texture *texture_of(const struct pov *pov, uint32_t material)
{
    return &pov->scene->textures[pov->scene->materials[material].texture - 1];
}

static const struct tia_texture *opacity_of(const struct pov *pov, uint32_t material)
{
    return &pov->scene->textures[pov->scene->materials[material].opacity - 1];
}

/* Writes the scale and the translation that place the unit square of a texture's pattern in (u, v). */
static void write_place(struct pov *pov, const struct tia_texture *t)
{
    const double once = ldexp(1, t->repeat_bits), offset = ldexp(1, -t->offset_bits);

    text_word(&pov->text, "scale <%.10g, %.10g, 1>", once / pov_q16(t->repeat[0]), once / pov_q16(t->repeat[1]));
    if (t->offset[0] != 0 || t->offset[1] != 0)
        pov_triple(pov, "translate", (struct point){pov_q16(t->offset[0]) * offset, pov_q16(t->offset[1]) * offset, 0});
}

/* Writes the picture for a material, 16 bits per channel: the texels times the material's colour; for an opacity, one
 * channel. */
static int write_texels(struct text *text, const struct tia_texture *t, struct point colour)
{
    const double factor[3] = {colour.x * 257, colour.y * 257, colour.z * 257};
    size_t channels = t->kind == TIA_OPACITY ? 1 : 3;

    text_print(text, "P%d\n%d %d\n65535\n", t->kind == TIA_OPACITY ? 5 : 6, t->width, t->height);
    for (size_t i = 0; i < channels * t->width * t->height; i++) {
        unsigned value = (unsigned)(t->texels[i] * factor[i % channels] + 0.5);
        const unsigned char bytes[2] = {(unsigned char)(value >> 8), (unsigned char)value};
        (void)sink_write(&text->sink, bytes, sizeof bytes);
    }
    return text_close(text);
}

/* Returns FILE-N.ppm for FILE.pov, or FILE-N.pgm for an opacity. */
static char *picture_path(const struct pov *pov, uint32_t material, const char *ending)
{
    size_t length = strlen(pov->path);
    char *path = malloc(length + 16);

    if (length > 4 && strcmp(pov->path + length - 4, ".pov") == 0)
        length -= 4;
    if (path)
        (void)snprintf(path, length + 16, "%.*s-%u.%s", (int)length, pov->path, material, ending);
    return path;
}

/* Writes a string literal of POV-Ray, with a backslash before each backslash and quote. */
static void write_string(struct text *text, const char *string)
{
    text_print(text, "\"");
    for (; *string != '\0'; string++)
        text_print(text, *string == '"' || *string == '\\' ? "\\%c" : "%c", *string);
    text_print(text, "\"");
}

/* Writes a picture file beside the scene's file, and its name into the scene. */
static void write_picture(struct pov *pov, uint32_t material, const struct tia_texture *t, struct point colour)
{
    const char *ending = t->kind == TIA_OPACITY ? "pgm" : "ppm";
    char *path = picture_path(pov, material, ending);
    struct text picture;

    if (!path || text_open(&picture, path, pov->why) || write_texels(&picture, t, colour)) {
        pov->failed = true;
    } else {
        const char *slash = strrchr(path, '/');
        text_word(&pov->text, "%s ", ending);
        write_string(&pov->text, slash ? slash + 1 : path);
        text_word(&pov->text, "gamma 1.0 %s", t->bilinear ? "interpolate 2" : "");
    }
    free(path);
}

static void write_image(struct pov *pov, uint32_t material, double transmit)
{
    text_word(&pov->text, "image_map { ");
    write_picture(pov, material, texture_of(pov, material), pov_rgb(pov->scene->materials[material].colour));
    text_word(&pov->text, "transmit all %.10g }", transmit);
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
    /* POV-Ray's checkers are cubes: the surface must be in the middle of a layer of cubes */
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
    write_place(pov, t);
    text_word(&pov->text, "}");
    return true;
}

/* Writes the size of a noise's unit in space, `times` as large. */
static void write_size(struct pov *pov, const struct tia_texture *t, double times)
{
    const double once = times * ldexp(1, t->repeat_bits), across = once / pov_q16(t->repeat[0]);

    text_word(&pov->text, "scale <%.10g, %.10g, %.10g>", across, once / pov_q16(t->repeat[1]), across);
}

/* A pattern of POV-Ray, with the values that stand for 0 and 1 of a noise and the size that stands for its unit: its
 * mean, standard deviation and correlation over distances are then those of tia's (tests/slow/povray). */
struct pattern {
    const char *name;
    double low, high, size;
};

static const struct pattern one_octave = {"bozo", 0.2, 0.82, 0.8}, several = {"granite", 0.05, 0.735, 4.7};

bool pov_noise(struct pov *pov, uint32_t material, double transmit)
{
    const struct tia_material *m = &pov->scene->materials[material];
    const struct tia_texture *t = m->texture ? texture_of(pov, material) : NULL;
    const struct point colour = pov_rgb(m->colour);

    if (!t || t->kind != TIA_NOISE || pov_black(m->colour))
        return false;
    pov_note(pov, "material %u: its noise is POV-Ray's here, with other places of light and dark", material);
    const struct pattern *like = t->octaves > 1 ? &several : &one_octave;
    text_word(&pov->text, "pigment { %s color_map {", like->name);
    for (int i = 0; i < 2; i++) {
        struct point end = pov_rgb(t->cells[i]);
        end = (struct point){end.x * colour.x, end.y * colour.y, end.z * colour.z};
        text_word(&pov->text, "[%.10g", i == 0 ? like->low : like->high);
        pov_triple(pov, "rgb", end);
        text_word(&pov->text, "transmit %.10g]", transmit);
    }
    text_word(&pov->text, "}");
    write_size(pov, t, like->size);
    text_word(&pov->text, "}");
    return true;
}

/* POV-Ray's bumps are half as steep as those of one octave, and more than twice as wide. Each octave is as steep as the
 * first, so that the slopes of n are sqrt(n) times as steep; the octave in the middle stands for all. */
void pov_bump(struct pov *pov, uint32_t material)
{
    const uint16_t bump = pov->scene->materials[material].bump;
    const struct tia_texture *t = bump ? &pov->scene->textures[bump - 1] : NULL;

    if (!t || t->kind != TIA_NOISE)
        return;
    text_word(&pov->text, "normal { bumps %.10g",
              2 * sqrt(t->octaves) * pov_q16(t->depth) * pov_q16(t->repeat[0]) * ldexp(1, -t->repeat_bits));
    write_size(pov, t, 0.4 * exp2((1 - t->octaves) / 2.0));
    text_word(&pov->text, "}");
}

static bool closes(const struct tia_texture *t)
{
    return fmod(pov_q16(t->repeat[0]) * ldexp(1, -t->repeat_bits), t->kind == TIA_CHECKER ? 2 : 1) == 0;
}

bool pov_closes(const struct pov *pov, uint32_t material)
{
    return (!pov_coloured(pov, material) || closes(texture_of(pov, material))) &&
           (!pov_has_opacity(pov, material) || closes(opacity_of(pov, material)));
}

void pov_write_opacity(struct pov *pov, uint32_t material)
{
    text_print(&pov->text, "#declare Opacity_%u =\n", material);
    text_word(&pov->text, "pigment { image_map {");
    write_picture(pov, material, opacity_of(pov, material), (struct point){1, 1, 1});
    text_word(&pov->text, "}");
    write_place(pov, opacity_of(pov, material));
    text_print(&pov->text, " }\n");
}
