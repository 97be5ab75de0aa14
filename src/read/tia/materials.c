/* materials.c - materials and textures. */
#include "math/integer.h"
#include "parse_state.h"
#include "read/text/nearest.h"

struct material_line {
    struct tia_material material;
    struct tia_word texture, opacity, bump;
    struct tia_emission emission;
};

#define COLOUR(name)                                                                                                   \
    {                                                                                                                  \
        .word = #name, .kind = TIA_COLOUR, .offset = offsetof(struct material_line, material.name)                     \
    }
#define NUMBER(name)                                                                                                   \
    {                                                                                                                  \
        .word = #name, .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct material_line, material.name)        \
    }

enum {
    COLOUR_FIELD,
    TEXTURE_FIELD,
    OPACITY_FIELD,
    BUMP_FIELD,
    SPECULAR_FIELD,
    EXPONENT_FIELD,
    REFRACTION_FIELD,
    INDEX_FIELD
};
static const struct tia_field material_fields[] = {
    COLOUR(colour),
    {.word = "texture", .kind = TIA_NAME_FIELD, .offset = offsetof(struct material_line, texture)},
    {.word = "opacity", .kind = TIA_NAME_FIELD, .offset = offsetof(struct material_line, opacity)},
    {.word = "bump", .kind = TIA_NAME_FIELD, .offset = offsetof(struct material_line, bump)},
    COLOUR(specular),
    NUMBER(exponent),
    COLOUR(refraction),
    NUMBER(index),
    COLOUR(mirror),
    {.word = "fresnel", .kind = TIA_FLAG, .offset = offsetof(struct material_line, material.fresnel)},
    COLOUR(transmission),
    {.word = "emission", .kind = TIA_EMISSION, .max = 1, .offset = offsetof(struct material_line, emission)},
    COLOUR(facing),
};

static bool has(uint32_t given, unsigned field)
{
    return given >> field & 1;
}

static int find_texture(struct tia_parse *job, const struct tia_word *name, uint32_t *number)
{
    int status = tia_parse_find(job, TIA_NAMED_TEXTURE, name, "the name of a texture", number);

    ++*number;
    return status;
}

static int find_bump(struct tia_parse *job, const struct tia_word *name, uint16_t *number)
{
    uint32_t found = 0;
    int status = find_texture(job, name, &found);

    if (!status && found > UINT16_MAX)
        return tia_text_error(&job->text, name, "is defined too late", "one of the first 65535 textures");
    *number = (uint16_t)found;
    return status;
}

/* Reads and defines a material's name; in the last pass, reports it to the caller's callback. */
static int define(struct tia_parse *job)
{
    const struct tia_reader *reader = job->reader;
    uint32_t index = tia_parse_count(job, TIA_OF_MATERIALS);
    char copy[TIA_NAME_MAX + 1];
    struct tia_word name;
    int status = tia_text_name(&job->text, &name, "a name");

    if (status)
        return status;
    tia_parse_name(job, TIA_NAMED_MATERIAL, &name, index);
    if (job->pass == TIA_FILLING && reader->material) {
        tia_word_copy(copy, &name);
        reader->material(reader->ctx, index, copy);
    }
    return TIA_OK;
}

int tia_line_material(struct tia_parse *job)
{
    struct material_line line = {.texture = {NULL, 0, 0, 0}, .opacity = {NULL, 0, 0, 0}, .bump = {NULL, 0, 0, 0}};
    struct tia_material *material = &line.material;
    uint32_t given = 0;
    int status = define(job);

    status = status
                 ? status
                 : tia_fields(&job->text, "a material", material_fields, TIA_COUNT_OF(material_fields), &line, &given);
    if (!status && has(given, TEXTURE_FIELD))
        status = find_texture(job, &line.texture, &material->texture);
    if (!status && has(given, OPACITY_FIELD))
        status = find_texture(job, &line.opacity, &material->opacity);
    if (!status && has(given, BUMP_FIELD))
        status = find_bump(job, &line.bump, &material->bump);
    if (has(given, SPECULAR_FIELD) && !has(given, EXPONENT_FIELD))
        material->exponent = TIA_Q16(32);
    if (has(given, REFRACTION_FIELD) && !has(given, INDEX_FIELD))
        material->index = TIA_Q16(1.5);
    material->emission = line.emission.rgb;
    material->emission_bits = line.emission.bits;
    if (!status)
        (void)tia_parse_add(job, TIA_OF_MATERIALS, material);
    return status;
}

/* A texture's line; numbers are Q31.32. */
struct texture_line {
    struct tia_texture texture;
    int64_t repeat[2], scale[2], offset[2];
    uint16_t octaves;
};

/* Indices of fields that every texture has; they come first. */
enum { REPEAT_FIELD, SCALE_FIELD };
#define OCTAVES_DEFAULT 4
#define LYING                                                                                                          \
    {.word = "repeat", .kind = TIA_LONGS, .count = 2, .max = 1, .offset = offsetof(struct texture_line, repeat)},      \
        {.word = "scale", .kind = TIA_LONGS, .count = 2, .max = 1, .offset = offsetof(struct texture_line, scale)},    \
        {.word = "offset", .kind = TIA_LONGS, .count = 2, .offset = offsetof(struct texture_line, offset)},            \
    {                                                                                                                  \
        .word = "depth", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct texture_line, texture.depth)       \
    }

static const struct tia_field checker_fields[] = {
    LYING,
    {.word = "even", .kind = TIA_COLOUR, .offset = offsetof(struct texture_line, texture.cells[0])},
    {.word = "odd", .kind = TIA_COLOUR, .offset = offsetof(struct texture_line, texture.cells[1])},
};

static const struct tia_field noise_fields[] = {
    LYING,
    {.word = "low", .kind = TIA_COLOUR, .offset = offsetof(struct texture_line, texture.cells[0])},
    {.word = "high", .kind = TIA_COLOUR, .offset = offsetof(struct texture_line, texture.cells[1])},
    {.word = "octaves",
     .kind = TIA_WHOLE,
     .count = 1,
     .max = TIA_OCTAVES_MAX,
     .offset = offsetof(struct texture_line, octaves)},
};

static const struct tia_field image_fields[] = {
    LYING,
    {.word = "bilinear", .kind = TIA_FLAG, .offset = offsetof(struct texture_line, texture.bilinear)},
};

/* Returns 2^64/x, rounded to nearest, for x in 2..2^63. */
static uint64_t inverse(uint64_t x)
{
    uint64_t quotient = UINT64_MAX / x, rest = UINT64_MAX % x + 1;

    return quotient + (rest >= x - x / 2);
}

#define NUMBERS_MOST ((INT64_C(1) << 55) - (INT64_C(1) << 23)) /* Q31.32: the limit with TIA_TEXTURE_BITS_MIN */

static bool is_exact(const int64_t numbers[2])
{
    return !((numbers[0] | numbers[1]) & 0xffff);
}

/* Converts both numbers to Q16.16 times 2^-bits. `bits` is 0 if that is exact, otherwise as large as possible. Returns
 * false if the numbers are too large even for the smallest `bits`. */
static bool set_numbers(const int64_t numbers[2], tia_q16 out[2], int8_t *bits)
{
    int64_t a = numbers[0] < 0 ? -numbers[0] : numbers[0], b = numbers[1] < 0 ? -numbers[1] : numbers[1];
    int64_t most = a > b ? a : b;
    int n = is_exact(numbers) ? 0 : TIA_TEXTURE_BITS_MAX;

    if (most >= NUMBERS_MOST)
        return false;
    while (tia_round_shift(most, (unsigned)(16 - n)) > INT32_MAX)
        n--;
    for (int i = 0; i < 2; i++)
        out[i] = (tia_q16)tia_round_shift(numbers[i], (unsigned)(16 - n));
    *bits = (int8_t)n;
    return true;
}

/* Range of repeats, Q31.32: 2^-20 to 2^20. A repeat of 1/1024 to 1024 stays in this range if the unit of length becomes
 * up to 1024 times smaller or larger. */
#define REPEAT_LEAST (INT64_C(1) << 12)
#define REPEAT_MOST (INT64_C(1) << 52)

/* Sets the texture's repeat, from `repeat` or as 1/`scale`, and its offset. */
static int set_pattern(struct tia_parse *job, struct texture_line *line, uint32_t given)
{
    bool scaled = has(given, SCALE_FIELD);
    struct tia_texture *texture = &line->texture;

    if (scaled && has(given, REPEAT_FIELD))
        return tia_text_error(&job->text, &job->first, "has a repeat and a scale", "one of them");
    for (int i = 0; i < 2; i++) {
        int64_t *number = scaled ? &line->scale[i] : &line->repeat[i];
        if (*number < REPEAT_LEAST || *number > REPEAT_MOST)
            return tia_text_error(&job->text, &job->first,
                                  scaled ? "has a scale out of range" : "has a repeat out of range",
                                  "1/1048576 to 1048576");
        line->repeat[i] = scaled ? (int64_t)inverse((uint64_t)*number) : *number;
    }
    (void)set_numbers(line->repeat, texture->repeat, &texture->repeat_bits);
    if (!set_numbers(line->offset, texture->offset, &texture->offset_bits))
        return tia_text_error(&job->text, &job->first, "has an offset out of range", "less than 8388608");
    return TIA_OK;
}

/* Loads an image, only once. Waits for the last pass, since the earlier passes find most errors. */
static int fetch_image(struct tia_parse *job, const struct tia_word *file, struct tia_texture *texture)
{
    struct tia_reader *reader = job->reader;
    bool is_image = texture->kind == TIA_IMAGE;
    struct tia_texture image = {.kind = texture->kind, .footprint = texture->footprint};
    char path[TIA_NAME_MAX + 1];
    const char *why = "cannot be read";

    if (is_image ? !reader->image : !reader->opacity)
        return tia_text_error(&job->text, file, "cannot be fetched here", "a scene without images");
    int status = tia_include_path(job, file, path);
    if (status || job->pass != TIA_FILLING || job->seeking)
        return status;
    if (tia_parse_count(job, TIA_OF_TEXTURES) < job->images) { /* the last pass is repeated */
        const struct tia_texture *loaded = tia_parse_at(job, TIA_OF_TEXTURES, tia_parse_count(job, TIA_OF_TEXTURES));
        texture->width = loaded->width;
        texture->height = loaded->height;
        texture->texels = loaded->texels;
        texture->mip_levels = loaded->mip_levels;
        return TIA_OK;
    }
    if (is_image ? reader->image(reader->ctx, path, &image, &why)
                 : reader->opacity(reader->ctx, path, TIA_CHANNEL_OPACITY, &image, &why))
        return tia_parse_missing(job, file, why, "a picture");
    job->images = tia_parse_count(job, TIA_OF_TEXTURES) + 1;
    texture->width = image.width;
    texture->height = image.height;
    texture->texels = image.texels;
    texture->mip_levels = image.mip_levels;
    return TIA_OK;
}

static int read_image(struct tia_parse *job, struct texture_line *line, enum tia_texture_kind kind)
{
    uint32_t given = 0;
    struct tia_word file;
    int status = tia_text_file(&job->text, &file, "an image's file");

    line->texture.kind = kind;
    if (!status)
        status = tia_fields(&job->text, "an image", image_fields, TIA_COUNT_OF(image_fields), line, &given);
    status = status ? status : set_pattern(job, line, given);
    return status ? status : fetch_image(job, &file, &line->texture);
}

static const struct tia_rgb white = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};

static int read_checker(struct tia_parse *job, struct texture_line *line)
{
    uint32_t given = 0;

    line->texture.cells[0] = white;
    int status = tia_fields(&job->text, "a checker", checker_fields, TIA_COUNT_OF(checker_fields), line, &given);
    return status ? status : set_pattern(job, line, given);
}

static int read_noise(struct tia_parse *job, struct texture_line *line)
{
    uint32_t given = 0;

    line->texture.kind = TIA_NOISE;
    line->texture.cells[1] = white;
    line->octaves = OCTAVES_DEFAULT;
    int status = tia_fields(&job->text, "a noise", noise_fields, TIA_COUNT_OF(noise_fields), line, &given);
    line->texture.octaves = (uint8_t)line->octaves;
    return status ? status : set_pattern(job, line, given);
}

int tia_line_texture(struct tia_parse *job)
{
    struct texture_line line = {.repeat = {INT64_C(1) << 32, INT64_C(1) << 32}};
    struct tia_word kind;
    int status = tia_parse_define(job, TIA_NAMED_TEXTURE, tia_parse_count(job, TIA_OF_TEXTURES));

    if (status)
        return status;
    line.texture.footprint = job->footprints;
    (void)tia_text_word(&job->text, &kind);
    if (tia_word_is(&kind, "checker"))
        status = read_checker(job, &line);
    else if (tia_word_is(&kind, "image"))
        status = read_image(job, &line, TIA_IMAGE);
    else if (tia_word_is(&kind, "opacity"))
        status = read_image(job, &line, TIA_OPACITY);
    else if (tia_word_is(&kind, "noise"))
        status = read_noise(job, &line);
    else
        return tia_text_error_of(&job->text, &kind, "is not a kind of texture", "checker, image, opacity or noise",
                                 NULL);
    if (!status)
        (void)tia_parse_add(job, TIA_OF_TEXTURES, &line.texture);
    return status;
}
