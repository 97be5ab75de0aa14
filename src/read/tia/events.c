/* events.c - events of a playing scene:  sphere ... appears 2 vanishes 5    fall ball velocity 1 0 0 */
#include "math/integer.h"
#include "parse_state.h"

#define END_DEFAULT TIA_Q16(10)

static void add_key(struct tia_parse *job, tia_q16 time, bool there)
{
    struct tia_keyframe key = {time, {there, 0, 0}};
    (void)tia_parse_add(job, TIA_OF_KEYS, &key);
}

int tia_parse_show(struct tia_parse *job, enum tia_target target, uint32_t index, const tia_q16 *appears,
                   const tia_q16 *vanishes)
{
    struct tia_track track = {.target = target, .index = index};
    uint32_t first = tia_parse_count(job, TIA_OF_KEYS);
    tia_q16 from = appears ? *appears : 0;

    if (!appears && !vanishes)
        return TIA_OK;
    if (from < 0)
        return tia_text_error(&job->text, &job->first, "appears too early", "a time of 0 or more");
    if (vanishes && *vanishes <= from)
        return tia_text_error(&job->text, &job->first, "vanishes before it appears", "a later time");
    if (from > 0)
        add_key(job, 0, false);
    add_key(job, from, true);
    if (vanishes)
        add_key(job, *vanishes, false);
    job->hides |= target == TIA_SHOWS_SHAPE;
    track.keys = tia_parse_at(job, TIA_OF_KEYS, first);
    track.key_count = tia_parse_count(job, TIA_OF_KEYS) - first;
    (void)tia_parse_add(job, TIA_OF_TRACKS, &track);
    return TIA_OK;
}

static const struct tia_field gravity_fields[] = {
    {.word = "until", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct tia_falling, end)},
};

/* Converts a velocity or acceleration to the scene's unit, which is not smaller than the file's in scenes with falling
 * balls. */
static void rescale(const struct tia_parse *job, struct tia_vec3 *v)
{
    int bits = job->reach.lengths.scale_bits;
    unsigned down = (unsigned)(bits < 0 ? -bits : 0);

    if (job->pass == TIA_FILLING)
        *v = (struct tia_vec3){(tia_q16)tia_round_shift(v->x, down), (tia_q16)tia_round_shift(v->y, down),
                               (tia_q16)tia_round_shift(v->z, down)};
}

int tia_line_gravity(struct tia_parse *job)
{
    int status = tia_text_vec3(&job->text, &job->falling.gravity);

    rescale(job, &job->falling.gravity);

    return status
               ? status
               : tia_fields(&job->text, "gravity", gravity_fields, TIA_COUNT_OF(gravity_fields), &job->falling, NULL);
}

static const struct tia_field fall_fields[] = {
    {.word = "velocity", .kind = TIA_NUMBERS, .count = 3, .offset = offsetof(struct tia_fall, velocity)},
    {.word = "restitution", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct tia_fall, restitution)},
    {.word = "mass", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct tia_fall, mass)},
};

/* Adds a falling ball. Until tia_events_resolve, its `shape` is the index of its name. */
int tia_line_fall(struct tia_parse *job)
{
    struct tia_fall fall = {.restitution = TIA_Q16_ONE, .mass = TIA_Q16_ONE};
    struct tia_word word;
    int status = tia_text_name(&job->text, &word, "the name of a sphere");

    if (status)
        return status;
    tia_parse_animate(job, &word);
    const struct tia_name *name = tia_parse_mover(job, &word);
    if (job->pass == TIA_FILLING && !name)
        return tia_parse_undefined(job, TIA_NAMED_MOVER, &word, "the name of a sphere");
    if (job->pass == TIA_FILLING && name->index % 2)
        return tia_text_error(&job->text, &word, "is a light", "the name of a sphere");
    if (name)
        fall.shape = (uint32_t)(name - (const struct tia_name *)tia_parse_at(job, TIA_OF_NAMES, 0));
    status = tia_fields(&job->text, "a ball that falls", fall_fields, TIA_COUNT_OF(fall_fields), &fall, NULL);
    job->reach.falls = job->hides = true;
    rescale(job, &fall.velocity);
    if (!status)
        (void)tia_parse_add(job, TIA_OF_FALLS, &fall);
    return status;
}

void tia_events_begin(struct tia_parse *job)
{
    job->falling = (struct tia_falling){.end = END_DEFAULT};
    job->hides = false;
}

void tia_events_end(struct tia_parse *job)
{
    const struct tia_mesh nothing = {0};

    if (job->hides)
        (void)tia_parse_add(job, TIA_OF_MESHES, &nothing);
    job->falling.balls = tia_parse_at(job, TIA_OF_FALLS, 0);
    job->falling.count = tia_parse_count(job, TIA_OF_FALLS);
    if (job->falling.count)
        (void)tia_parse_add(job, TIA_OF_FALLING, &job->falling);
}

/* Returns the index of the shape that has the transform. */
static uint32_t shape_of(const struct tia_parse *job, uint32_t transform)
{
    const struct tia_shape *shapes = tia_parse_at(job, TIA_OF_SHAPES, 0);
    uint32_t count = tia_parse_count(job, TIA_OF_SHAPES), i = 0;

    while (i < count && shapes[i].transform != transform + 1)
        i++;
    return i;
}

void tia_events_resolve(struct tia_parse *job)
{
    struct tia_fall *falls = (struct tia_fall *)(void *)job->arrays[TIA_OF_FALLS].items;
    const struct tia_name *names = tia_parse_at(job, TIA_OF_NAMES, 0);

    for (uint32_t i = 0; i < tia_parse_count(job, TIA_OF_FALLS); i++)
        falls[i].shape = shape_of(job, names[falls[i].shape].index / 2);
}
