/* fault.c - finds the line and the word of a .tia file that tia_scene_check refuses.
 *
 * The text is read again up to the statement that creates the faulty object.
 */
#include "parse_state.h"
#include "read/readers.h"

static struct tia_word word_of(const char *string)
{
    struct tia_word word = {string, 0, 0, 0};

    while (string[word.length])
        word.length++;
    return word;
}

/* Sets the object or the statement that the job searches for. */
static void seek(struct tia_parse *job, const struct tia_fault *fault)
{
    static const struct {
        const char *thing;
        enum tia_parse_array array;
    } things[] = {{"material", TIA_OF_MATERIALS}, {"texture", TIA_OF_TEXTURES}, {"sphere", TIA_OF_SPHERES},
                  {"shape", TIA_OF_SHAPES},       {"mesh", TIA_OF_MESHES},      {"transform", TIA_OF_TRANSFORMS},
                  {"grid", TIA_OF_GRIDS},         {"solid", TIA_OF_SOLIDS},     {"light", TIA_OF_LIGHTS},
                  {"key", TIA_OF_BINDINGS},       {"track", TIA_OF_TRACKS},     {"fall", TIA_OF_FALLS},
                  {"fog", TIA_OF_FOGS},           {"lens", TIA_OF_LENSES}};
    struct tia_word thing = word_of(fault->thing), field = word_of(fault->field);

    job->seeking = true;
    job->seeking_in = TIA_FILLING;
    job->sought = TIA_ARRAYS;
    job->sought_index = fault->index;
    for (unsigned i = 0; i < TIA_COUNT_OF(things); i++)
        if (tia_word_is(&thing, things[i].thing))
            job->sought = things[i].array;
    /* in a file, most fields of the scene, and the camera's `samples`, are statements of their own, named like the
     * field */
    if (tia_word_is(&thing, "camera") && !tia_word_is(&field, "samples"))
        job->sought_statement = fault->thing;
    else if (job->sought == TIA_ARRAYS)
        job->sought_statement = fault->field;
}

/* Returns the file's word for a field of the scene, which may differ from the field's name, or "" if the line as a
 * whole is at fault. */
static const char *keyword(const struct tia_fault *fault)
{
    static const struct {
        const char *thing, *field, *word;
    } names[] = {
        {"camera", "reference", "look"},
        {"camera", "window", "window"},
        {"light", "centre", "at"},
        {"key", "centre", "at"},
        {"light", "side", "sides"},
        {"key", "side", "sides"},
        {"shape", "base_radius", "radii"},
        {"shape", "top_radius", "radii"},
        {"shape", "transform", "scale"},
        {"shape", "place", ""},
        {"solid", "place", ""},
        {"shape", "corners", ""},
        {"transform", "position", "at"},
        {"track", "value", ""},
        {"track", "time", ""},
        {"track", "target", ""},
        {"fall", "shape", ""},
        {"scene", "fall", ""},
        {"scene", "gravity", ""},
    };
    struct tia_word thing = word_of(fault->thing), field = word_of(fault->field);

    for (unsigned i = 0; i < TIA_COUNT_OF(names); i++)
        if (tia_word_is(&thing, names[i].thing) && tia_word_is(&field, names[i].field))
            return names[i].word;
    return fault->field;
}

/* True if a name follows the statement's word. Such a name may look like a keyword. */
static bool is_named(const char *statement)
{
    static const char *const named[] = {"material", "texture", "mesh", "grid", "instance", "animate", "fall"};
    struct tia_word word = word_of(statement);

    for (unsigned i = 0; i < TIA_COUNT_OF(named); i++)
        if (tia_word_is(&word, named[i]))
            return true;
    return false;
}

/* Finds the fault's place by reading the text again. The arrays overwrite the refused scene in the arena: it is not
 * needed any more. */
void tia_locate_tia(struct tia_reader *reader, struct tia_fault *fault, struct tia_arena *arena)
{
    struct tia_scene scene;
    struct tia_parse job = {.reader = reader, .scene = &scene};
    const char *word = keyword(fault);

    seek(&job, fault);
    arena->used = 0;
    (void)tia_parse_read(&job, arena);
    if (!reader->error.line)
        return;
    (void)tia_text_locate(job.rest, is_named(job.statement), word, &reader->error);
    fault->thing = job.statement;
    fault->field = word;
}
