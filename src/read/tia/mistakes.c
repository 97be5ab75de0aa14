/* mistakes.c - all mistakes of a .tia file, after the first one has been found.
 *
 * The text is read again, with all passes. After a mistake the reader goes on with what was probably meant or with the
 * next line, and the last pass tells the mistakes in the order of the text. Consequences of mistakes are not told:
 *
 * - A line with a mistake still opens its block and defines its names, as TIA_NAMED_FAULTY. Where such a name is used,
 *   nothing is told.
 * - The counting pass finds the blocks without an end: those that are open at the end of their file. If an end has not
 *   the indentation of its block but that of a block around it, the end of the inner one is missing. The first lines of
 *   such blocks are the mistakes, and the following passes do not open the blocks.
 */
#include "parse_state.h"

/* Returns the word at the error's place, without a minus. */
static struct tia_word word_at(const struct tia_read_error *error)
{
    struct tia_word word = {NULL, 0, error->line, error->column};

    if (!error->source)
        return word;
    word.at = error->source + (error->column - 1);
    word.length = error->length;
    if (word.length > 1 && *word.at == '-') {
        word.at++;
        word.length--;
    }
    return word;
}

/* True if the name of a number was used whose definition has a mistake or is in a file that was not read. */
static bool uses_faulty_number(const struct tia_parse *job, const struct tia_word *word)
{
    const struct tia_constant *constant;

    if (!word->length || !tia_constant_named(word->at))
        return false;
    constant = tia_constant_find(&job->constants, word->at, word->length);
    return constant ? !constant->end : job->mistakes->lost;
}

/* True if a mistake was told at this place; otherwise stores the place. */
static bool was_told(struct tia_mistakes *mistakes, uint32_t count, const char *place)
{
    for (uint32_t i = 0; i < count && place; i++)
        if (mistakes->places[i] == place)
            return true;
    if (count < TIA_MISTAKES_MAX)
        mistakes->places[count] = place;
    return false;
}

void tia_mistake_tell(void *ctx)
{
    struct tia_parse *job = ctx;
    struct tia_mistakes *mistakes = job->mistakes;
    struct tia_reader *reader = job->reader;
    struct tia_word word = word_at(&reader->error);
    bool follows = mistakes->follows || uses_faulty_number(job, &word);

    mistakes->follows = false;
    if (!mistakes->tells || follows || reader->mistakes > TIA_MISTAKES_MAX ||
        was_told(mistakes, reader->mistakes, word.at))
        return;
    if (!reader->mistakes)
        mistakes->first = reader->error;
    if (reader->mistakes++ < TIA_MISTAKES_MAX && reader->mistake)
        reader->mistake(reader->ctx, &reader->error);
}

static void add_faulty(struct tia_parse *job, const struct tia_word *name)
{
    if (name->length)
        tia_parse_name(job, TIA_NAMED_FAULTY, name, 0);
}

/* Adds the names that the line defines, wherever its mistake is. */
static void add_names(struct tia_parse *job)
{
    struct tia_text rest = job->rest;
    struct tia_word word;
    bool second = job->names, named = false;

    while (tia_text_word(&rest, &word)) {
        if (second || named)
            add_faulty(job, &word);
        named = tia_word_is(&word, "name");
        second = false;
    }
}

/* Opens a group that leaves its contents in place, for a line that should have opened one. */
static void open_group(struct tia_parse *job)
{
    if (job->group_count == TIA_GROUP_DEPTH) {
        job->mistakes->deep++;
        return;
    }
    struct tia_group *group = &job->groups[job->group_count];
    *group = (struct tia_group){.first = job->first};
    for (int i = 0; i < 3; i++) {
        group->place.axes[i][i] = INT64_C(1) << 62;
        group->place.scale[i] = INT64_C(1) << 32;
    }
    group->place.as_written = true;
    if (job->group_count)
        group->place = job->groups[job->group_count - 1].place;
    job->group_count++;
}

/* Counts a member whose line has a mistake: its solid is not empty. */
static void note_member(struct tia_parse *job)
{
    for (unsigned i = job->group_count; job->solid_groups && i-- > 0;)
        if (job->groups[i].operation) {
            job->groups[i].operands += !job->groups[i].operands;
            return;
        }
}

int tia_mistake_recover(struct tia_parse *job)
{
    tia_mistake_tell(job);
    add_names(job);
    tia_text_abandon(&job->text);
    if (job->opens && job->group_count == job->mistakes->groups)
        open_group(job);
    else
        note_member(job);
    return job->reader->mistakes > TIA_MISTAKES_MAX ? TIA_ERR_RANGE : TIA_OK;
}

/* ---- blocks ---- */

int tia_block_has_no_end(struct tia_text *t, const struct tia_word *first)
{
    (void)tia_text_error_at(t, first);
    tia_say_plain(t->error, first);
    tia_say(t->error, " of line ");
    tia_say_number(t->error, first->line);
    tia_say(t->error, " has no end");
    return TIA_ERR_RANGE;
}

bool tia_mistake_unclosed(struct tia_parse *job)
{
    struct tia_mistakes *mistakes = job->mistakes;

    for (uint32_t i = 0; i < mistakes->unclosed_count; i++)
        if (mistakes->unclosed[i] == job->first.at) {
            job->opens = false;
            (void)tia_block_has_no_end(&job->text, &job->first);
            return true;
        }
    return false;
}

void tia_mistake_closed(struct tia_parse *job, const struct tia_word *end)
{
    const struct tia_word *first = &job->groups[job->group_count - 1].first;
    bool other = first->column != end->column, outer = false;

    for (unsigned i = 0; i + 1 < job->group_count; i++)
        outer |= job->groups[i].first.column == end->column;
    if (other && outer && !job->mistakes->suspect.length)
        job->mistakes->suspect = *first;
}

static void add_unclosed(struct tia_mistakes *mistakes, const struct tia_word *first)
{
    if (mistakes->unclosed_count < TIA_GROUP_DEPTH)
        mistakes->unclosed[mistakes->unclosed_count++] = first->at;
}

void tia_mistake_close(struct tia_parse *job, unsigned base)
{
    struct tia_mistakes *mistakes = job->mistakes;

    while (job->group_count > base) {
        const struct tia_group *group = &job->groups[--job->group_count];
        add_unclosed(mistakes, mistakes->suspect.length ? &mistakes->suspect : &group->first);
        mistakes->suspect.length = 0;
        job->repeat_count -= group->repeats;
        if (job->solid_groups > job->group_count)
            job->solid_groups = 0;
    }
    mistakes->deep = 0;
}

bool tia_mistake_blocks(struct tia_parse *job)
{
    struct tia_mistakes *mistakes = job->mistakes;

    if (!mistakes || mistakes->unclosed_count == mistakes->unclosed_seen)
        return false;
    mistakes->unclosed_seen = mistakes->unclosed_count;
    mistakes->suspect.length = 0;
    mistakes->deep = 0;
    return true;
}

void tia_mistake_pass(struct tia_parse *job)
{
    job->mistakes->tells = true;
    job->mistakes->deep = 0;
    job->bits = job->most = job->room; /* everything fits */
}
