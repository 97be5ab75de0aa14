/* fields.c - reads a line of fields by a table. */
#include "fields.h"

#include "length.h"
#include "math/integer.h"
#include "nearest.h"

int tia_colour(struct tia_text *t, struct tia_rgb *out)
{
    struct tia_text before = *t;
    int status = tia_text_unit(t, &out->r);

    out->g = out->b = out->r;
    if (status || !tia_text_has_number(t))
        return status;
    *t = before;
    return tia_text_rgb(t, out, false);
}

/* Returns a channel divided by 2^bits, to nearest, at most `most`. */
static tia_q30 scaled_channel(int64_t channel, unsigned bits, tia_q30 most)
{
    int64_t scaled = (channel + ((INT64_C(1) << bits) >> 1)) >> bits;

    return scaled < most ? (tia_q30)scaled : most;
}

int tia_emission(struct tia_text *t, struct tia_emission *out, tia_q30 most)
{
    int64_t rgb[3] = {0, 0, 0}, largest = 0;
    int status = tia_text_radiance(t, most, &rgb[0]);

    rgb[1] = rgb[2] = rgb[0];
    for (int c = 1; c < 3 && !status && (c == 2 || tia_text_has_number(t)); c++)
        status = tia_text_radiance(t, most, &rgb[c]);
    if (status)
        return status;
    for (int c = 0; c < 3; c++)
        largest = rgb[c] > largest ? rgb[c] : largest;
    for (out->bits = 0; out->bits < TIA_EMISSION_BITS_MAX; out->bits++)
        if ((largest + ((INT64_C(1) << out->bits) >> 1)) >> out->bits <= most)
            break;
    out->rgb = (struct tia_rgb){scaled_channel(rgb[0], out->bits, most), scaled_channel(rgb[1], out->bits, most),
                                scaled_channel(rgb[2], out->bits, most)};
    return TIA_OK;
}

#define FADING_MORE 5                                   /* extra bits; 0 if Q16.16 holds a number exactly */
#define FADING_LEAST (INT64_C(1) << (10 + FADING_MORE)) /* 2^-6: the relative rounding error is at most 2^-11 */
#define FADING_MOST (INT64_C(32767) << (16 + FADING_MORE))

/* Reads the linear and the quadratic number for a unit of length of 2^unit units of the file, with FADING_MORE extra
 * bits. */
static int read_fading(struct tia_text *t, int unit, int64_t out[2])
{
    int status = tia_text_long(t, &out[0], (unsigned)(16 + FADING_MORE + unit));

    return status ? status : tia_text_long(t, &out[1], (unsigned)(16 + FADING_MORE + 2 * unit));
}

/* True if Q16.16 holds each number exactly or with enough bits. */
static bool keeps_digits(const int64_t numbers[2])
{
    bool keeps = true;

    for (int i = 0; i < 2; i++)
        keeps = keeps &&
                (numbers[i] >= FADING_LEAST || numbers[i] <= -FADING_LEAST || !(numbers[i] & ((1 << FADING_MORE) - 1)));
    return keeps;
}

static bool fits(const int64_t numbers[2])
{
    return numbers[0] <= FADING_MOST && numbers[1] <= FADING_MOST && numbers[0] >= -FADING_MOST &&
           numbers[1] >= -FADING_MOST;
}

#define FADING_UNITS 16 /* log2 of the largest unit: tia_decimal has at most 53 fractional bits */

int tia_fading(struct tia_text *t, struct tia_fading *out)
{
    int status = tia_text_q16(t, &out->constant), scale_bits = t->lengths->filling ? t->lengths->scale_bits : 0;
    int unit = scale_bits < 0 ? -scale_bits : 0;
    const struct tia_text start = *t;
    int64_t numbers[2] = {0, 0}, more[2];

    status = status ? status : tia_text_q16(t, &out->linear);
    status = status ? status : tia_text_q16(t, &out->quadratic);
    struct tia_text again = start;
    status = status ? status : read_fading(&again, unit, numbers);
    while (!status && !keeps_digits(numbers) && unit < FADING_UNITS) {
        again = start;
        if (read_fading(&again, unit + 1, more) || !fits(more))
            break;
        numbers[0] = more[0];
        numbers[1] = more[1];
        unit++;
    }
    for (int i = 0; i < 2; i++)
        numbers[i] = numbers[i] < -FADING_MOST ? -FADING_MOST : numbers[i] > FADING_MOST ? FADING_MOST : numbers[i];
    out->linear = (tia_q16)tia_round_shift(numbers[0], FADING_MORE);
    out->quadratic = (tia_q16)tia_round_shift(numbers[1], FADING_MORE);
    out->unit_bits = (int8_t)unit;
    return status;
}

static int read_all(struct tia_text *t, int (*read)(struct tia_text *, tia_q16 *), tia_q16 *out, unsigned count)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < count && !status; i++)
        status = read(t, &out[i]);
    return status;
}

int tia_spread(struct tia_text *t, tia_q16 *out, unsigned count)
{
    int status = tia_text_q16(t, out);

    if (!status && tia_text_has_number(t))
        return read_all(t, tia_text_q16, out + 1, count - 1);
    for (unsigned i = 1; i < count; i++)
        out[i] = out[0];
    return status;
}

static int read_longs(struct tia_text *t, int64_t *out, const struct tia_field *field)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < field->count && !status; i++)
        if (i && field->max && !tia_text_has_number(t))
            out[i] = out[0];
        else
            status = tia_text_long(t, &out[i], 32);
    return status;
}

static int read_wholes(struct tia_text *t, uint16_t *out, const struct tia_field *field)
{
    int64_t value = 0;
    int status = TIA_OK;

    for (unsigned i = 0; i < field->count && !status; i++) {
        status = tia_text_integer(t, &value, 1, field->max);
        out[i] = (uint16_t)value;
    }
    return status;
}

static int read_values(struct tia_text *t, const struct tia_field *field, void *out)
{
    switch ((enum tia_field_kind)field->kind) {
    case TIA_NUMBERS:
        return read_all(t, tia_text_q16, out, field->count);
    case TIA_LENGTHS:
        return read_all(t, tia_text_length, out, field->count);
    case TIA_VECTOR:
        return tia_text_vector(t, out);
    case TIA_SPREAD:
        return tia_spread(t, out, field->count);
    case TIA_LONGS:
        return read_longs(t, out, field);
    case TIA_COLOUR:
        return tia_colour(t, out);
    case TIA_EMISSION:
        return tia_emission(t, out, field->max ? TIA_Q30_ONE : INT32_MAX);
    case TIA_FADING:
        return tia_fading(t, out);
    case TIA_DIRECTION:
        return tia_text_dir3(t, out);
    case TIA_WHOLE:
        return read_wholes(t, out, field);
    case TIA_FLAG:
        *(bool *)out = true;
        return TIA_OK;
    case TIA_NAME_FIELD:
        return tia_text_name(t, out, "a name");
    case TIA_FILE_FIELD:
        return tia_text_file(t, out, "a file's name");
    }
    return TIA_ERR_ARGUMENT;
}

/* Appends the fields' words; of a long list only some, those that every such line needs first. */
static void list(struct tia_read_error *error, const struct tia_field *fields, unsigned count)
{
    bool all = count <= TIA_LIST_MOST;
    unsigned most = all ? count : TIA_LIST_START, shown = 0;

    for (unsigned i = 0; i < 2 * count && shown < most; i++) {
        const struct tia_field *field = &fields[i % count];
        if (all ? i >= count : field->needed != (i < count))
            continue;
        tia_say(error, shown == 0 ? "" : shown + 1 < count ? ", " : " or ");
        tia_say(error, field->word);
        shown++;
    }
    tia_say(error, all ? "" : " or the like");
}

/* Returns the index of the field called `word`, or `count` if there is none. */
static unsigned index_of(const struct tia_word *word, const struct tia_field *fields, unsigned count)
{
    unsigned i = 0;

    while (i < count && !tia_word_is(word, fields[i].word))
        i++;
    return i;
}

static unsigned find(const struct tia_word *word, const struct tia_field *fields, unsigned count)
{
    unsigned i = index_of(word, fields, count);

    if (i < count)
        return i;
    const struct tia_word british = tia_word_british(word);
    return index_of(&british, fields, count);
}

/* Refuses a word that is no field. Returns the index of the field that was probably meant, or `count`. */
static unsigned refuse(struct tia_text *t, const struct tia_word *word, const char *what,
                       const struct tia_field *fields, unsigned count)
{
    struct tia_nearest nearest = {.word = word};

    for (unsigned i = 0; i < count; i++)
        tia_nearest_try(&nearest, fields[i].word);
    (void)tia_text_error_at(t, word);
    tia_say_word(t->error, word);
    tia_say(t->error, " is not a field of ");
    tia_say(t->error, what);
    tia_say(t->error, ", expected ");
    tia_say_plain(t->error, &nearest.candidate);
    if (!nearest.candidate.length)
        list(t->error, fields, count);
    return nearest.candidate.length ? index_of(&nearest.candidate, fields, count) : count;
}

/* Finds the field that the word names, or probably means if the reader goes on after mistakes. Returns `count` if there
 * is none, or if it has been seen. */
static unsigned choose(struct tia_text *t, const struct tia_word *word, const char *what,
                       const struct tia_field *fields, unsigned count, uint32_t seen)
{
    unsigned i = find(word, fields, count);

    if (i == count) {
        i = refuse(t, word, what, fields, count);
        if (i == count || !tia_text_goes_on(t))
            return count;
    } else if (seen >> i & 1) {
        (void)tia_text_error(t, word, "is given twice", "once");
        if (!tia_text_goes_on(t))
            return count;
    }
    return i;
}

int tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
               uint32_t *given)
{
    struct tia_word word;
    uint32_t seen = 0;

    while (tia_text_word(t, &word)) {
        unsigned i = choose(t, &word, what, fields, count, seen);
        if (i == count)
            return TIA_ERR_RANGE;
        seen |= UINT32_C(1) << i;
        int status = read_values(t, &fields[i], (unsigned char *)out + fields[i].offset);
        if (status)
            return status;
    }
    for (unsigned i = 0; i < count; i++)
        if (fields[i].needed && !(seen >> i & 1))
            return tia_text_error(t, &word, "", fields[i].word);
    if (given)
        *given = seen;
    return TIA_OK;
}

/* Returns the form called `word`; NULL if there is none. */
static const struct tia_form *form_called(const struct tia_word *word, const struct tia_form *forms, unsigned count)
{
    const struct tia_word british = tia_word_british(word);

    while (count-- > 0)
        if (tia_word_is(&british, forms[count].word))
            return &forms[count];
    return NULL;
}

/* Returns the form that a word probably means which is neither a form nor a field of the first form; NULL if there is
 * none. Sets the error then. */
static const struct tia_form *guess(struct tia_text *t, const struct tia_word *word, const struct tia_form *forms,
                                    unsigned count)
{
    struct tia_nearest nearest = {.word = word};

    if (find(word, forms->fields, forms->count) < forms->count)
        return NULL;
    for (unsigned i = 0; i < count; i++)
        tia_nearest_try(&nearest, forms[i].word);
    if (!nearest.candidate.length)
        return NULL;
    (void)tia_text_error(t, word, "is not a kind of this statement", "");
    tia_say_plain(t->error, &nearest.candidate);
    return form_called(&nearest.candidate, forms, count);
}

int tia_form(struct tia_text *t, const struct tia_form *forms, unsigned count, const struct tia_form **form)
{
    struct tia_word word;

    (void)tia_text_peek(t, &word);
    *form = form_called(&word, forms, count);
    if (!*form) {
        const struct tia_form *meant = guess(t, &word, forms, count);
        *form = meant ? meant : forms;
        if (!meant)
            return TIA_OK;
        if (!tia_text_goes_on(t))
            return TIA_ERR_RANGE;
    }
    (void)tia_text_word(t, &word);
    return TIA_OK;
}
