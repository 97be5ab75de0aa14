/* view_settings.c - the statements camera, samples, background, depth, shadows, and those of integrators. */
#include "parse_state.h"

#include "math/integer.h"
#include "read/text/nearest.h"

#define EYE                                                                                                            \
    {.word = "eye", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_camera, eye)},                      \
        {.word = "look", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_camera, reference)},           \
    {                                                                                                                  \
        .word = "up", .kind = TIA_VECTOR, .offset = offsetof(struct tia_camera, up)                                    \
    }
#define LOOK_GIVEN 2u
#define UP_GIVEN 4u
/* a window: left, right, bottom, top */
#define WINDOW                                                                                                         \
    {                                                                                                                  \
        .word = "window", .kind = TIA_LENGTHS, .count = 4, .offset = offsetof(struct tia_camera, window),              \
        .needed = true                                                                                                 \
    }
_Static_assert(offsetof(struct tia_window, top) == 3 * sizeof(tia_q16), "a window is four numbers");

static const struct tia_field perspective[] = {
    EYE,
    {.word = "fov", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct tia_camera, fov)},
};

static const struct tia_field frustum[] = {
    EYE,
    WINDOW,
    {.word = "near",
     .kind = TIA_LENGTHS,
     .count = 1,
     .offset = offsetof(struct tia_camera, window.near),
     .needed = true},
};

static const struct tia_field orthographic[] = {EYE, WINDOW};

static const struct tia_form projections[] = {
    {"perspective", "a camera", TIA_PERSPECTIVE, perspective, TIA_COUNT_OF(perspective)},
    {"frustum", "a frustum camera", TIA_FRUSTUM, frustum, TIA_COUNT_OF(frustum)},
    {"orthographic", "an orthographic camera", TIA_ORTHOGRAPHIC, orthographic, TIA_COUNT_OF(orthographic)},
};

int tia_line_camera(struct tia_parse *job)
{
    struct tia_camera *camera = &job->scene->camera;
    struct tia_word word;
    uint32_t given = 0;

    (void)tia_text_peek(&job->text, &word);
    if (tia_word_is(&word, "lightfield"))
        return tia_light_field_line(job);
    const struct tia_form *form;
    int status = tia_form(&job->text, projections, TIA_COUNT_OF(projections), &form);

    camera->projection = (enum tia_projection)form->kind;
    status = status ? status : tia_fields(&job->text, form->what, form->fields, form->count, camera, &given);
    if (status)
        return status;
    (void)tia_text_peek(&job->text, &word);
    if ((given & UP_GIVEN) && !(given & LOOK_GIVEN))
        return tia_text_error(&job->text, &word, "", "look, as there is up");
    if ((given & LOOK_GIVEN) && !(given & UP_GIVEN))
        camera->up.y = TIA_Q16_ONE;
    return TIA_OK;
}

int tia_line_samples(struct tia_parse *job)
{
    struct tia_word word;

    (void)tia_text_word(&job->text, &word);
    for (uint32_t n = 1; n <= TIA_SAMPLES_MAX; n *= 4)
        if (tia_word_is(&word, n == 1 ? "1" : n == 4 ? "4" : "16")) {
            job->scene->camera.samples = n;
            return TIA_OK;
        }
    return tia_text_error(&job->text, &word, "is not a number of samples", "1, 4 or 16");
}

int tia_line_background(struct tia_parse *job)
{
    return tia_colour(&job->text, &job->scene->background);
}

int tia_line_depth(struct tia_parse *job)
{
    int64_t depth = 0;
    int status = tia_text_integer(&job->text, &depth, 1, TIA_DEPTH_MAX);

    job->scene->depth = (uint32_t)depth;
    return status;
}

static const struct tia_field fog_fields[] = {
    {.word = "colour", .kind = TIA_COLOUR, .offset = offsetof(struct tia_fog, colour), .needed = true},
    {.word = "distance", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_fog, distance), .needed = true},
    {.word = "height", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_fog, height)},
    {.word = "level", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_fog, level)},
};

int tia_line_fog(struct tia_parse *job)
{
    struct tia_fog fog = {.distance = 0};
    int status = tia_fields(&job->text, "fog", fog_fields, TIA_COUNT_OF(fog_fields), &fog, NULL);

    if (!status)
        (void)tia_parse_add(job, TIA_OF_FOGS, &fog);
    return status;
}

static const struct tia_field lens_fields[] = {
    {.word = "radius", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_lens, radius), .needed = true},
    {.word = "focus", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_lens, focus), .needed = true},
};

int tia_line_lens(struct tia_parse *job)
{
    struct tia_lens lens = {0, 0};
    int status = tia_fields(&job->text, "a lens", lens_fields, TIA_COUNT_OF(lens_fields), &lens, NULL);

    if (!status)
        (void)tia_parse_add(job, TIA_OF_LENSES, &lens);
    return status;
}

/* Reads a name, and sets *number to the number, not below `first`, for which `name_of` returns that name. */
static int named(struct tia_text *t, const char *(*name_of)(unsigned), unsigned first, const char *what,
                 const char *expected, unsigned *number)
{
    struct tia_word word;
    const char *name;

    (void)tia_text_word(t, &word);
    for (*number = first; (name = name_of(*number)) != NULL; ++*number)
        if (tia_word_is(&word, name))
            return TIA_OK;
    return tia_text_error_of(t, &word, what, expected, NULL);
}

static int map_size(struct tia_text *t, struct tia_shadow_map *map)
{
    struct tia_word word;
    int64_t size = 0;

    (void)tia_text_peek(t, &word);
    int status = tia_text_integer(t, &size, TIA_MAP_SIZE_MIN, TIA_MAP_SIZE_MAX);
    if (!status && (size & (size - 1)))
        status = tia_text_error(t, &word, "is not a size of a map", "64, 128, 256, 512, 1024, 2048 or 4096");
    map->size = (uint16_t)size;
    return status;
}

/* Reads an amount with more digits than Q16.16 has: in a file with a large unit, a length has few digits there. */
static int amount_digits(struct tia_text *t, struct tia_shadow_map *map)
{
    int64_t amount;
    int status = tia_text_long(t, &amount, 32);
    unsigned bits = 0;

    while (!status && bits < TIA_AMOUNT_BITS_MAX && amount & ((INT64_C(1) << (16 - bits)) - 1) &&
           amount < INT64_C(1) << (32 - bits))
        bits++;
    map->amount = status ? 0 : (tia_q16)tia_round_shift(amount, 16 - bits);
    map->amount_bits = (uint8_t)bits;
    return status;
}

/* Reads a number that must not be negative. */
static int not_negative(struct tia_text *t, int (*read)(struct tia_text *, tia_q16 *), tia_q16 *out)
{
    struct tia_word word;

    (void)tia_text_peek(t, &word);
    int status = read(t, out);
    return !status && *out < 0 ? tia_text_error(t, &word, "is below 0", "0 or more") : status;
}

static int map_bias(struct tia_text *t, struct tia_shadow_map *map)
{
    unsigned bias;
    int status =
        named(t, tia_bias_name, TIA_BIAS_NONE, "is not a bias", "none, constant, slope, normal or plane", &bias);

    map->bias = (enum tia_bias)bias;
    if (status || bias == TIA_BIAS_NONE)
        return status;
    struct tia_text again = *t;
    status = not_negative(t, tia_text_q16, &map->amount);
    map->amount_bits = 0;
    if (!status && bias == TIA_BIAS_CONSTANT)
        status = amount_digits(&again, map);
    return status;
}

static int map_filter(struct tia_text *t, struct tia_shadow_map *map)
{
    unsigned filter;
    int status = named(t, tia_filter_name, TIA_FILTER_NONE, "is not a filter",
                       "none, bilinear, 3x3, 5x5, 7x7, poisson or pcss", &filter);

    map->filter = (enum tia_filter)filter;
    return status;
}

/* Reads a field of the statement `shadows`; `seen` has a bit for each field that was read. */
static int shadow_field(struct tia_text *t, const struct tia_word *word, struct tia_scene *scene, unsigned *seen)
{
    static const char *const fields[] = {"tessellated", "size", "bias", "filter"}; /* the fields of maps last */
    bool map = scene->shadows == TIA_SHADOWS_MAP;
    unsigned i = 0, count = map ? TIA_COUNT_OF(fields) : 1;

    while (i < count && !tia_word_is(word, fields[i]))
        i++;
    if (i == count)
        return tia_text_error_of(t, word, "is not a field of this technique",
                                 map ? "size, bias, filter or tessellated" : "tessellated", NULL);
    if (*seen >> i & 1)
        return tia_text_error(t, word, "is given twice", "once");
    *seen |= 1U << i;
    if (i == 0)
        return not_negative(t, tia_text_length, &scene->tessellated);
    return i == 1   ? map_size(t, &scene->shadow_map)
           : i == 2 ? map_bias(t, &scene->shadow_map)
                    : map_filter(t, &scene->shadow_map);
}

int tia_line_shadows(struct tia_parse *job)
{
    struct tia_scene *scene = job->scene;
    struct tia_word word;
    unsigned technique, seen = 0;
    int status = named(&job->text, tia_shadows_name, TIA_SHADOWS_TRACED, "is not a technique",
                       "traced, rays, zpass, zfail, map, map-exact or zpass-plain", &technique);

    scene->shadows = (enum tia_shadows)technique;
    scene->shadow_map = (struct tia_shadow_map){.size = 0};
    scene->tessellated = 0;
    while (!status && technique != TIA_SHADOWS_TRACED && tia_text_word(&job->text, &word))
        status = shadow_field(&job->text, &word, scene, &seen);
    return status;
}

/* Reads the statement integrator: a name, and for ao a distance. */
int tia_line_integrator(struct tia_parse *job)
{
    struct tia_integration *how = &job->scene->integration;
    struct tia_word word;
    unsigned integrator;
    int status =
        named(&job->text, tia_integrator_name, TIA_WHITTED, "is not an integrator", "whitted, ao or path", &integrator);

    how->integrator = (enum tia_integrator)integrator;
    if (status || how->integrator != TIA_OCCLUSION || !tia_text_peek(&job->text, &word))
        return status;
    status = tia_text_length(&job->text, &how->distance);
    return status || how->distance > 0 ? status : tia_text_error(&job->text, &word, "is not a distance", "more than 0");
}

int tia_line_spp(struct tia_parse *job)
{
    int64_t spp = 0;
    int status = tia_text_integer(&job->text, &spp, 1, TIA_SPP_MAX);

    job->scene->integration.spp = (uint32_t)spp;
    return status;
}

/* Reads the statement filter. It holds for all textures, also for those before it, since the first pass finds it. */
int tia_line_filter(struct tia_parse *job)
{
    struct tia_word word;

    (void)tia_text_word(&job->text, &word);
    job->footprints = tia_word_is(&word, "footprint");
    if (job->footprints || tia_word_is(&word, "none"))
        return TIA_OK;
    return tia_text_error_of(&job->text, &word, "is not a filter", "none or footprint", NULL);
}

int tia_line_tone(struct tia_parse *job)
{
    unsigned tone;
    int status = named(&job->text, tia_tone_name, TIA_TONE_LINEAR, "is not a tone", "linear or srgb", &tone);

    job->scene->integration.tone = (enum tia_tone)tone;
    return status;
}

int tia_line_exposure(struct tia_parse *job)
{
    tia_q16 *exposure = &job->scene->integration.exposure;
    struct tia_word word;

    (void)tia_text_peek(&job->text, &word);
    int status = tia_text_q16(&job->text, exposure);
    if (!status && (*exposure < -TIA_EXPOSURE_MAX || *exposure > TIA_EXPOSURE_MAX))
        status = tia_text_error(&job->text, &word, "is out of range", "-24 to 24");
    return status;
}
