/* read.c - tia_read: reads a scene file of any format, then checks the scene. */
#include "math/align.h"
#include "readers.h"

static int read_format(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    if (reader->format == TIA_FORMAT_TIA) {
        int status = tia_read_tia(reader, scene, arena);
        size_t used = arena->used;
        if (status)
            tia_tell_tia(reader, scene, arena);
        arena->used = arena->used > used ? arena->used : used;
        return status;
    }
    return reader->format == TIA_FORMAT_NFF ? tia_read_nff(reader, scene, arena)
                                            : tia_read_model(reader, scene, arena, NULL);
}

static bool is_model(const struct tia_reader *reader)
{
    return reader->format != TIA_FORMAT_TIA && reader->format != TIA_FORMAT_NFF;
}

/* Returns the rest of the string behind `start`, or NULL if it does not begin with `start`. */
static const char *after(const char *string, const char *start)
{
    while (*start && *string == *start)
        string++, start++;
    return *start ? NULL : string;
}

/* Finds the statement at fault. A camera that the caller has changed has none. */
static void locate(struct tia_reader *reader, struct tia_fault *fault, struct tia_arena *arena)
{
    if (reader->camera && after(fault->thing, "camera"))
        return;
    if (reader->format == TIA_FORMAT_TIA)
        tia_locate_tia(reader, fault, arena);
    else if (reader->format == TIA_FORMAT_NFF)
        tia_locate_nff(reader, fault);
}

/* Appends the violated rule. If its limit is the smallest length (2^-10 in the scene) or the largest distance, converts
 * the limit to the file's unit. */
static void say_rule(struct tia_read_error *error, const char *rule, int scale_bits)
{
    static const char *const starts[] = {"must be at least 2^", "must be 0 or at least 2^"};
    const char *far = after(rule, "every point must be nearer to the eye than 32768");

    for (unsigned i = 0; i < 2; i++) {
        const char *number = after(rule, starts[i]), *rest = number ? after(number, "-10") : NULL;
        if (!rest)
            continue;
        tia_say(error, starts[i]);
        tia_say_number(error, -10 - (int64_t)scale_bits);
        tia_say(error, rest);
        return;
    }
    if (!far || scale_bits >= 0) {
        tia_say(error, rule);
        return;
    }
    tia_say(error, "every point must be nearer to the eye than ");
    tia_say_number(error, INT64_C(32768) << -scale_bits);
}

static void say_fault(struct tia_reader *reader, const struct tia_scene *scene, struct tia_fault *fault,
                      struct tia_arena *arena)
{
    struct tia_read_error *error = &reader->error;

    *error = (struct tia_read_error){.line = 0};
    locate(reader, fault, arena);
    tia_say(error, fault->thing);
    if (!error->line) { /* without a line, the index identifies the object */
        tia_say(error, " ");
        tia_say_number(error, fault->index);
    }
    if (*fault->field) {
        tia_say(error, ": ");
        tia_say(error, fault->field);
    }
    tia_say(error, ": ");
    say_rule(error, fault->rule, scene->scale_bits);
}

/* Runs tia_scene_check and turns its fault into the reader's error, or into a warning. */
static int check(struct tia_reader *reader, const struct tia_scene *scene, struct tia_arena *arena)
{
    struct tia_fault fault;
    int status = tia_scene_check(scene, &fault);

    if (!status && !fault.thing)
        return TIA_OK;
    say_fault(reader, scene, &fault, arena);
    if (status || reader->strict)
        return TIA_ERR_RANGE;
    if (reader->warnings)
        reader->warnings[TIA_WARN_DARK] = (struct tia_read_warning){1, reader->error};
    reader->error = (struct tia_read_error){.line = 0};
    return TIA_OK;
}

/* Tells the error, if it has not been told. */
static int told(struct tia_reader *reader, int status)
{
    if (status != TIA_ERR_RANGE || reader->mistakes)
        return status;
    reader->mistakes = 1;
    if (reader->mistake)
        reader->mistake(reader->ctx, &reader->error);
    return status;
}

int tia_read(struct tia_reader *reader, struct tia_scene *scene, void *memory, size_t size, size_t *need)
{
    struct tia_arena arena = {memory, memory ? size : 0, 0};

    if (!reader || !scene || !need || (!reader->text && reader->length) || (memory && !memory_is_usable(memory)))
        return TIA_ERR_ARGUMENT;
    *need = 0;
    *scene = (struct tia_scene){.bvh = NULL};
    reader->placement = (struct tia_placement){.bits = 0};
    reader->error = (struct tia_read_error){.line = 0};
    reader->mistakes = 0;
    for (unsigned i = 0; reader->warnings && i < TIA_WARNINGS; i++)
        reader->warnings[i].count = 0;
    if (tia_text_is_too_long(reader->length)) {
        tia_say(&reader->error, "the text is too long, expected less than 4 GiB");
        return told(reader, TIA_ERR_RANGE);
    }
    int status = read_format(reader, scene, &arena);
    *need = arena.used;
    if (status)
        return told(reader, status);
    if (!is_model(reader))
        reader->placement.bits = scene->scale_bits;
    return tia_arena_fits(&arena) ? told(reader, check(reader, scene, &arena)) : TIA_ERR_MEMORY;
}
