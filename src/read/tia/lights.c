/* lights.c - lights, and keys that set them. */
#include "parse_state.h"
#include "read/text/nearest.h"
#include <tia/port.h>

struct light_line {
    struct tia_word name;
    tia_q16 appears, vanishes;
    struct tia_emission emission;
    struct tia_fading fading;
    struct tia_light light;
};

#define NUMBERS(field, n, part, need) VALUES(TIA_NUMBERS, field, n, part, need)
#define LENGTHS(field, n, part, need) VALUES(TIA_LENGTHS, field, n, part, need)
#define VALUES(type, field, n, part, need)                                                                             \
    {                                                                                                                  \
        .word = field, .kind = type, .count = n, .offset = offsetof(struct light_line, light.part), .needed = need     \
    }
/* The number of fields that only lights have. They come first, so that keys can skip them. */
#define OWN 3
#define NAME                                                                                                           \
    {.word = "name", .kind = TIA_NAME_FIELD, .offset = offsetof(struct light_line, name)},                             \
        {.word = "appears", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct light_line, appears)},          \
    {                                                                                                                  \
        .word = "vanishes", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct light_line, vanishes)           \
    }
#define NAMED 1u
#define APPEARS 2u
#define VANISHES 4u
#define EMISSION                                                                                                       \
    {                                                                                                                  \
        .word = "emission", .kind = TIA_EMISSION, .offset = offsetof(struct light_line, emission)                      \
    }
#define PLACED                                                                                                         \
    NAME, EMISSION, LENGTHS("at", 3, centre, true),                                                                    \
    {                                                                                                                  \
        .word = "attenuation", .kind = TIA_FADING, .offset = offsetof(struct light_line, fading)                       \
    }
#define DIRECTION                                                                                                      \
    {                                                                                                                  \
        .word = "direction", .kind = TIA_DIRECTION, .offset = offsetof(struct light_line, light.direction),            \
        .needed = true                                                                                                 \
    }
#define SAMPLES                                                                                                        \
    {                                                                                                                  \
        .word = "samples", .kind = TIA_WHOLE, .count = 1, .max = TIA_LIGHT_SAMPLES_MAX,                                \
        .offset = offsetof(struct light_line, light.samples)                                                           \
    }

static const struct tia_field point_fields[] = {PLACED, LENGTHS("radius", 1, radius, false)};
static const struct tia_field directional_fields[] = {NAME, EMISSION, DIRECTION};
static const struct tia_field ambient_fields[] = {NAME, EMISSION, LENGTHS("occlusion", 1, radius, false), SAMPLES};
static const struct tia_field spot_fields[] = {PLACED, DIRECTION, NUMBERS("inner", 1, inner, false),
                                               NUMBERS("outer", 1, outer, true)};
static const struct tia_field rectangle_fields[] = {PLACED, LENGTHS("sides", 6, side, true), SAMPLES};
static const struct tia_field disc_fields[] = {PLACED, DIRECTION, LENGTHS("radius", 1, radius, true), SAMPLES};
static const struct tia_field sphere_fields[] = {PLACED, LENGTHS("radius", 1, radius, true), SAMPLES};

#define FORM(KIND, name, what, traits) {#name, what, KIND, name##_fields, TIA_COUNT_OF(name##_fields)},
static const struct tia_form kinds[] = {TIA_LIGHTS(FORM)};
#undef FORM

static int read_light(struct tia_parse *job, struct light_line *line, bool nameable, uint32_t *given)
{
    const struct tia_form *kind;
    int status = tia_form(&job->text, kinds, TIA_COUNT_OF(kinds), &kind);
    unsigned skip = nameable ? 0 : OWN;

    line->light = (struct tia_light){.kind = (enum tia_light_kind)kind->kind};
    line->fading = (struct tia_fading){.constant = 0};
    line->emission = (struct tia_emission){{TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE}, 0};
    if (!status)
        status = tia_fields(&job->text, kind->what, kind->fields + skip, kind->count - skip, line, given);
    line->light.emission = line->emission.rgb;
    line->light.emission_bits = line->emission.bits;
    line->light.constant = line->fading.constant;
    line->light.linear = line->fading.linear;
    line->light.quadratic = line->fading.quadratic;
    line->light.unit_bits = line->fading.unit_bits;
    if (!status && !tia_light_has(line->light.kind, TIA_LIGHT_PLACELESS) && job->pass == TIA_COUNTING)
        tia_reach_light(&job->reach, &line->light);
    return status;
}

int tia_line_light(struct tia_parse *job)
{
    struct light_line line;
    uint32_t given = 0;
    int status = read_light(job, &line, true, &given);

    if (!status && (given & NAMED) && tia_word_is(&line.name, "camera"))
        status = tia_text_error(&job->text, &line.name, "is the camera's name", "another");
    if (status)
        return status;
    uint32_t index = tia_parse_add(job, TIA_OF_LIGHTS, &line.light);
    if (given & NAMED)
        tia_parse_name(job, TIA_NAMED_MOVER, &line.name, 2 * index + 1);
    return tia_parse_show(job, TIA_SHOWS_LIGHT, index, given & APPEARS ? &line.appears : NULL,
                          given & VANISHES ? &line.vanishes : NULL);
}

static const struct {
    const char *word;
    enum tia_key key;
} keys[] = {{"left", TIA_KEY_LEFT}, {"right", TIA_KEY_RIGHT},     {"up", TIA_KEY_UP},
            {"down", TIA_KEY_DOWN}, {"page-up", TIA_KEY_PAGE_UP}, {"page-down", TIA_KEY_PAGE_DOWN}};

static int take_key(struct tia_text *t, uint16_t *key)
{
    struct tia_word word;

    (void)tia_text_word(t, &word);
    *key = word.length == 1 ? (unsigned char)*word.at : 0;
    if ((*key >= 'a' && *key <= 'z') || (*key >= '0' && *key <= '9'))
        return TIA_OK;
    for (unsigned i = 0; i < TIA_COUNT_OF(keys); i++)
        if (tia_word_is(&word, keys[i].word)) {
            *key = (uint16_t)keys[i].key;
            return TIA_OK;
        }
    return tia_text_error_of(t, &word, "is not a key",
                             "a small letter, a digit, left, right, up, down, page-up or page-down", NULL);
}

int tia_line_key(struct tia_parse *job)
{
    struct tia_binding binding = {.key = 0};
    struct light_line line;
    struct tia_word word;
    int64_t light = 0;
    int status = take_key(&job->text, &binding.key);

    if (status)
        return status;
    if (!tia_text_word(&job->text, &word) || !tia_word_is(&word, "light"))
        return tia_text_error(&job->text, &word, "cannot be moved by a key", "light");
    status = tia_text_integer(&job->text, &light, 1, INT32_C(1) + UINT16_MAX);
    status = status ? status : read_light(job, &line, false, NULL);
    if (status)
        return status;
    binding.light = (uint16_t)(light - 1);
    binding.state = line.light;
    (void)tia_parse_add(job, TIA_OF_BINDINGS, &binding);
    return TIA_OK;
}
