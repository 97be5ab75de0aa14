/* materials.c - materials and textures. */
#include "job.h"

struct material_line {
    struct tia_material material;
    struct tia_word texture;
};

#define COLOUR(name)                                                                                                   \
    {                                                                                                                  \
        .word = #name, .kind = TIA_COLOUR, .offset = offsetof(struct material_line, material.name)                     \
    }
#define NUMBER(name)                                                                                                   \
    {                                                                                                                  \
        .word = #name, .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct material_line, material.name)        \
    }

enum { COLOUR_FIELD, TEXTURE_FIELD, SPECULAR_FIELD, EXPONENT_FIELD, REFRACTION_FIELD, INDEX_FIELD };
static const struct tia_field material_fields[] = {
    COLOUR(colour),
    {.word = "texture", .kind = TIA_NAME_FIELD, .offset = offsetof(struct material_line, texture)},
    COLOUR(specular),
    NUMBER(exponent),
    COLOUR(refraction),
    NUMBER(index),
    COLOUR(mirror),
    {.word = "fresnel", .kind = TIA_FLAG, .offset = offsetof(struct material_line, material.fresnel)},
    COLOUR(transmission),
    COLOUR(emission),
    COLOUR(facing),
};

static bool has(uint32_t given, unsigned field)
{
    return given >> field & 1;
}

int tia_line_material(struct tia_job *job)
{
    struct material_line line = {.texture = {NULL, 0, 0, 0}};
    struct tia_material *material = &line.material;
    uint32_t given = 0;
    int status = tia_job_define(job, TIA_NAMED_MATERIAL, tia_job_count(job, TIA_OF_MATERIALS));

    status = status
                 ? status
                 : tia_fields(&job->text, "a material", material_fields, TIA_COUNT_OF(material_fields), &line, &given);
    if (!status && has(given, TEXTURE_FIELD)) {
        status = tia_job_find(job, TIA_NAMED_TEXTURE, &line.texture, "the name of a texture", &material->texture);
        material->texture++;
    }
    if (has(given, SPECULAR_FIELD) && !has(given, EXPONENT_FIELD))
        material->exponent = TIA_Q16(32);
    if (has(given, REFRACTION_FIELD) && !has(given, INDEX_FIELD))
        material->index = TIA_Q16(1.5);
    if (!status)
        (void)tia_job_add(job, TIA_OF_MATERIALS, material);
    return status;
}

static const struct tia_field checker_fields[] = {
    {.word = "even", .kind = TIA_COLOUR, .offset = offsetof(struct tia_texture, cells[0])},
    {.word = "odd", .kind = TIA_COLOUR, .offset = offsetof(struct tia_texture, cells[1])},
    {.word = "repeat", .kind = TIA_SPREAD, .count = 2, .offset = offsetof(struct tia_texture, repeat)},
};

static const struct tia_field image_fields[] = {
    {.word = "bilinear", .kind = TIA_FLAG, .offset = offsetof(struct tia_texture, bilinear)},
    {.word = "repeat", .kind = TIA_SPREAD, .count = 2, .offset = offsetof(struct tia_texture, repeat)},
};

/* Loads the file only once, in the last pass, when the rest of the text is known to be right. */
static int fetch_image(struct tia_job *job, const struct tia_word *file, struct tia_texture *texture)
{
    struct tia_reader *reader = job->reader;
    struct tia_texture image = {.kind = TIA_IMAGE};
    char name[TIA_NAME_MAX + 1];
    const char *why = "cannot be read";

    if (!reader->image)
        return tia_text_error(&job->text, file, "cannot be fetched here", "a scene without images");
    if (job->pass != TIA_FILLING || job->seeking)
        return TIA_OK;
    tia_word_copy(name, file);
    if (reader->image(reader->ctx, name, &image, &why) != TIA_OK) {
        (void)tia_text_error_at(&job->text, file);
        tia_say_word(job->text.error, file);
        tia_say(job->text.error, ": ");
        tia_say(job->text.error, why);
        tia_say(job->text.error, ", expected a picture");
        return TIA_ERR_RANGE;
    }
    texture->width = image.width;
    texture->height = image.height;
    texture->texels = image.texels;
    return TIA_OK;
}

static int read_image(struct tia_job *job, struct tia_texture *texture)
{
    struct tia_word file;
    int status = tia_text_file(&job->text, &file, "an image's file");

    texture->kind = TIA_IMAGE;
    if (!status)
        status = tia_fields(&job->text, "an image", image_fields, TIA_COUNT_OF(image_fields), texture, NULL);
    return status ? status : fetch_image(job, &file, texture);
}

int tia_line_texture(struct tia_job *job)
{
    struct tia_texture texture = {.repeat = {TIA_Q16_ONE, TIA_Q16_ONE}};
    struct tia_word kind;
    int status = tia_job_define(job, TIA_NAMED_TEXTURE, tia_job_count(job, TIA_OF_TEXTURES));

    if (status)
        return status;
    (void)tia_text_word(&job->text, &kind);
    if (tia_word_is(&kind, "checker")) {
        texture.cells[0] = (struct tia_rgb){TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};
        status = tia_fields(&job->text, "a checker", checker_fields, TIA_COUNT_OF(checker_fields), &texture, NULL);
    } else if (tia_word_is(&kind, "image")) {
        status = read_image(job, &texture);
    } else {
        return tia_text_error(&job->text, &kind, "is no kind of texture", "checker or image");
    }
    if (!status)
        (void)tia_job_add(job, TIA_OF_TEXTURES, &texture);
    return status;
}
