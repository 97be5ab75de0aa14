/* motion.c - keyframes:  animate ball at smooth 0: 0 0 0  2: 0 3 0    animate gold colour 0: 1 0.8 0  1: 0.5 */
#include "parse_state.h"
#include "read/text/nearest.h"

enum moving { CAMERA, LIGHT, SHAPE, MATERIAL };

static const struct property {
    enum moving of;
    const char *word;
    enum tia_target target;
} properties[] = {
    {CAMERA, "eye", TIA_MOVES_EYE},
    {CAMERA, "look", TIA_MOVES_REFERENCE},
    {LIGHT, "at", TIA_MOVES_LIGHT},
    {LIGHT, "direction", TIA_ROTATES_LIGHT},
    {SHAPE, "at", TIA_MOVES_TRANSFORM},
    {SHAPE, "rotate", TIA_ROTATES_TRANSFORM},
    {SHAPE, "scale", TIA_SCALES_TRANSFORM},
    {MATERIAL, "colour", TIA_SETS_COLOUR},
    {MATERIAL, "transmission", TIA_SETS_TRANSMISSION},
    {MATERIAL, "emission", TIA_SETS_EMISSION},
    {MATERIAL, "specular", TIA_SETS_SPECULAR},
    {MATERIAL, "mirror", TIA_SETS_MIRROR},
    {MATERIAL, "refraction", TIA_SETS_REFRACTION},
    {MATERIAL, "facing", TIA_SETS_FACING},
};

#define OF_MATERIALS "colour, transmission, emission, specular, mirror, refraction or facing, of a material"

static const char *const expected[] = {"eye or look, of the camera", "at or direction, of a light",
                                       "at, rotate or scale, of a shape", OF_MATERIALS};

static const struct property *find_property(enum moving of, const struct tia_word *name)
{
    const struct tia_word british = tia_word_british(name), *word = &british;

    for (unsigned i = 0; i < TIA_COUNT_OF(properties); i++)
        if (properties[i].of == of && tia_word_is(word, properties[i].word))
            return &properties[i];
    return NULL;
}

/* Refuses a word that is no property; of shapes, also those of materials may have been meant. */
static int refuse(struct tia_text *t, enum moving of, const struct tia_word *word)
{
    struct tia_nearest nearest = {.word = word};

    for (unsigned i = 0; i < TIA_COUNT_OF(properties); i++)
        if (properties[i].of == of || (of == SHAPE && properties[i].of == MATERIAL))
            tia_nearest_try(&nearest, properties[i].word);
    (void)tia_text_error(t, word, "cannot be animated", nearest.candidate.length ? "" : expected[of]);
    tia_say_plain(t->error, &nearest.candidate);
    return TIA_ERR_RANGE;
}

/* Reads the name of the animated object. Before the last pass, names of lights and of shapes are not distinguished. */
static int read_target(struct tia_parse *job, enum moving *of, struct tia_track *track)
{
    struct tia_word word, property;
    int status = tia_text_name(&job->text, &word, "a name, or camera");

    (void)tia_text_peek(&job->text, &property);
    *of = find_property(MATERIAL, &property) ? MATERIAL : tia_word_is(&word, "camera") ? CAMERA : SHAPE;
    if (status || *of == CAMERA)
        return status;
    if (*of == MATERIAL)
        return tia_parse_find(job, TIA_NAMED_MATERIAL, &word, "the name of a material", &track->index);
    tia_parse_animate(job, &word);
    const struct tia_name *name = tia_parse_mover(job, &word);
    if (job->pass != TIA_FILLING)
        return TIA_OK;
    if (!name && tia_parse_has(job, TIA_NAMED_MATERIAL, &word)) {
        *of = MATERIAL; /* which has no such property */
        return TIA_OK;
    }
    if (!name)
        return tia_parse_undefined(job, TIA_NAMED_MOVER, &word, "the name of a shape or light, or camera");
    track->index = (uint32_t)(name - (const struct tia_name *)tia_parse_at(job, TIA_OF_NAMES, 0));
    *of = name->index % 2 ? LIGHT : SHAPE;
    return TIA_OK;
}

static int take_property(struct tia_parse *job, struct tia_track *track)
{
    struct tia_word word;
    enum moving of;
    int status = read_target(job, &of, track);

    if (status)
        return status;
    (void)tia_text_word(&job->text, &word);
    const struct property *property = find_property(of, &word);
    if (!property && job->pass != TIA_FILLING)
        property = find_property(LIGHT, &word);
    if (!property)
        return refuse(&job->text, of, &word);
    track->target = property->target;
    job->hides |= track->target >= TIA_SETS_SPECULAR;
    return TIA_OK;
}

/* Reads a time, which must be later than `before`, and a colon. */
static int read_time(struct tia_text *t, tia_q16 before, tia_q16 *time)
{
    struct tia_word word, number;
    int64_t value = 0;

    (void)tia_text_word(t, &word);
    number = word;
    if (number.length)
        number.length--;
    if (!number.length || word.at[number.length] != ':' || tia_decimal(&value, &number, 16) == TIA_DECIMAL_NONE)
        return tia_text_error(t, &word, "is not a time", "seconds and a colon, as in 2.5:");
    if (tia_decimal(&value, &number, 16) == TIA_DECIMAL_RANGE || value < 0 || value > INT32_MAX)
        return tia_text_error(t, &word, "is out of range", "0 to below 32768 seconds");
    if (value <= before)
        return tia_text_error(t, &word, "is not after the time before it", "rising times");
    *time = (tia_q16)value;
    return TIA_OK;
}

static int take_keyframe(struct tia_text *t, enum tia_target target, struct tia_keyframe *key)
{
    int status = read_time(t, key->time, &key->time);

    if (status)
        return status;
    if (target >= TIA_SETS_COLOUR) {
        struct tia_rgb colour = {0, 0, 0};
        status = tia_colour(t, &colour);
        key->value = (struct tia_vec3){colour.r, colour.g, colour.b};
        return status;
    }
    if (target == TIA_SCALES_TRANSFORM)
        return tia_spread(t, &key->value.x, 3);
    if (target == TIA_ROTATES_TRANSFORM || target == TIA_ROTATES_LIGHT)
        return tia_text_vec3(t, &key->value);
    return tia_text_place(t, &key->value);
}

int tia_line_animate(struct tia_parse *job)
{
    struct tia_text *t = &job->text;
    uint32_t first = tia_parse_count(job, TIA_OF_KEYS);
    struct tia_track track = {.smooth = false};
    struct tia_keyframe key = {.time = -1};
    struct tia_span span;
    struct tia_word word;
    int status = take_property(job, &track);

    tia_span_begin(&span);
    (void)tia_text_peek(t, &word);
    if (!status && (tia_word_is(&word, "smooth") || tia_word_is(&word, "linear"))) {
        track.smooth = tia_word_is(&word, "smooth");
        (void)tia_text_word(t, &word);
    }
    do {
        status = status ? status : take_keyframe(t, track.target, &key);
        if (status)
            return status;
        tia_span_cover(&span, key.value, 0);
        (void)tia_parse_add(job, TIA_OF_KEYS, &key);
    } while (tia_text_peek(t, &word));
    if (job->pass == TIA_COUNTING)
        tia_reach_keys(&job->reach, &track, span);
    track.keys = tia_parse_at(job, TIA_OF_KEYS, first);
    track.key_count = tia_parse_count(job, TIA_OF_KEYS) - first;
    (void)tia_parse_add(job, TIA_OF_TRACKS, &track);
    return TIA_OK;
}
