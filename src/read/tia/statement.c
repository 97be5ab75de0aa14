/* statement.c - the statements of a .tia file. */
#include "parse_state.h"
#include "read/text/nearest.h"
#include "scene/shapes/description.h"

#define ONCE 1u     /* at most one in a scene */
#define UNMOVED 2u  /* not allowed in groups, which would not move it */
#define REPEATED 4u /* allowed in repeat blocks */
#define MEMBER 8u   /* allowed in solids */
#define OPENS 16u   /* opens a group, which an end closes */
#define DEFINES 32u /* a name follows, which the statement defines */

/* All statements but those of shapes: a shape's word is in its description. */
static const struct statement {
    const char *word;
    int (*read)(struct tia_parse *job);
    unsigned flags;
} statements[] = {
    {"instance", tia_line_instance, REPEATED},
    {"mesh", tia_line_mesh, DEFINES},
    {"grid", tia_line_grid, DEFINES},
    {"material", tia_line_material, DEFINES},
    {"texture", tia_line_texture, DEFINES},
    {"light", tia_line_light, UNMOVED},
    {"key", tia_line_key, UNMOVED},
    {"animate", tia_line_animate, 0},
    {"fall", tia_line_fall, 0},
    {"gravity", tia_line_gravity, ONCE},
    {"union", tia_line_union, REPEATED | MEMBER | OPENS},
    {"intersection", tia_line_intersection, REPEATED | MEMBER | OPENS},
    {"difference", tia_line_difference, REPEATED | MEMBER | OPENS},
    {"group", tia_line_group, REPEATED | MEMBER | OPENS},
    {"repeat", tia_line_repeat, REPEATED | MEMBER | OPENS},
    {"end", tia_line_end, REPEATED | MEMBER},
    {"include", tia_line_include, 0},
    {"define", tia_line_define, DEFINES},
    {"camera", tia_line_camera, ONCE | UNMOVED},
    {"background", tia_line_background, ONCE},
    {"samples", tia_line_samples, ONCE},
    {"depth", tia_line_depth, ONCE},
    {"fog", tia_line_fog, ONCE | UNMOVED},
    {"lens", tia_line_lens, ONCE | UNMOVED},
    {"shadows", tia_line_shadows, ONCE},
    {"integrator", tia_line_integrator, ONCE},
    {"spp", tia_line_spp, ONCE},
    {"filter", tia_line_filter, ONCE},
    {"tone", tia_line_tone, ONCE},
    {"exposure", tia_line_exposure, ONCE},
};
#define STATEMENTS TIA_COUNT_OF(statements)

/* Refuses a word that is no statement; *meant receives the one that was probably meant, or an empty word. */
static void refuse(struct tia_parse *job, const struct tia_word *word, struct tia_word *meant)
{
    struct tia_nearest nearest = {.word = word};
    const struct shape_description *shape;

    for (unsigned kind = 0; (shape = tia_shape_description((enum tia_shape_kind)kind)); kind++)
        if (shape->word)
            tia_nearest_try(&nearest, shape->word);
    for (unsigned i = 0; i < STATEMENTS; i++)
        tia_nearest_try(&nearest, statements[i].word);
    *meant = nearest.candidate;
    (void)tia_text_error(&job->text, word, "is not a statement",
                         meant->length ? "" : "a shape, material, light, camera or the like");
    tia_say_plain(job->text.error, meant);
}

/* Finds the kind of shape whose statement begins with the word. */
static bool find_shape(const struct tia_word *word, enum tia_shape_kind *kind)
{
    const struct shape_description *shape;

    for (unsigned i = TIA_SPHERE; (shape = tia_shape_description((enum tia_shape_kind)i)); i++)
        if (shape->word && tia_word_is(word, shape->word)) {
            *kind = (enum tia_shape_kind)i;
            return true;
        }
    return false;
}

/* Returns the statement, other than those of shapes, with that word; NULL if there is none. */
static const struct statement *find_statement(const struct tia_word *word)
{
    for (unsigned i = 0; i < STATEMENTS; i++)
        if (tia_word_is(word, statements[i].word))
            return &statements[i];
    return NULL;
}

static bool is_statement(const struct tia_word *word)
{
    const struct tia_word british = tia_word_british(word);
    enum tia_shape_kind kind;

    return find_shape(&british, &kind) || find_statement(&british);
}

/* Checks that the statement is allowed where it is. */
static int check_place(struct tia_parse *job, const struct statement *statement)
{
    const struct tia_word *word = &job->first;

    if (statement->flags & ONCE && job->once >> (statement - statements) & 1)
        return tia_text_error(&job->text, word, "is given twice", "once");
    if (job->solid_groups && !(statement->flags & MEMBER))
        return tia_text_error(&job->text, word, "is not a part of a solid", "members, operations, groups or end");
    if (statement->flags & UNMOVED && job->group_count)
        return tia_text_error(&job->text, word, "is not moved by groups", "it outside of them");
    if (!(statement->flags & REPEATED) && job->repeat_count)
        return tia_text_error(&job->text, word, "is not repeated", "it outside of repeat blocks");
    return TIA_OK;
}

static int read_other(struct tia_parse *job, const struct statement *statement)
{
    job->opens = statement->flags & OPENS;
    job->names = statement->flags & DEFINES;
    if (job->opens && job->mistakes && tia_mistake_unclosed(job))
        return TIA_ERR_RANGE;
    if (check_place(job, statement) && !tia_text_goes_on(&job->text))
        return TIA_ERR_RANGE;
    job->once |= UINT32_C(1) << (statement - statements);
    job->statement = statement->word;
    int status = statement->read(job);
    return status ? status : tia_text_end(&job->text);
}

int tia_statement_read(struct tia_parse *job)
{
    struct tia_word word = tia_word_british(&job->first);
    enum tia_shape_kind kind = TIA_SPHERE;

    job->rest = job->text;
    job->is_statement = is_statement;
    job->opens = job->names = false;
    if (job->mistakes)
        job->mistakes->groups = job->group_count;
    if (job->repeat_count && ++job->repeated_lines > TIA_REPEATED_LINES)
        return tia_text_error(&job->text, &job->first, "is a line too many", "at most 16777216 in repeat blocks");
    if (!is_statement(&word)) {
        job->names = true; /* whatever it is, it may define a name */
        refuse(job, &job->first, &word);
        if (!word.length || !tia_text_goes_on(&job->text))
            return TIA_ERR_RANGE;
        job->names = false;
    }
    const struct statement *statement = find_statement(&word);
    if (statement)
        return read_other(job, statement);
    (void)find_shape(&word, &kind);
    job->statement = tia_shape_description(kind)->word;
    return tia_line_shape(job, kind);
}
