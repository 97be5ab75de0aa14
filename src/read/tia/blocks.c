/* blocks.c - blocks of lines, from their statement to the line "end": where they end, and mistakes in them. */
#include "parse_state.h"

#define SCANS_MOST 16 /* most lines of a pass for which the rest of the text is scanned, so that its time is linear */

static bool is_of_block(const struct tia_word *word)
{
    static const char *const lines[] = {"vertex", "normal", "uv", "face", "group", "row", "end"};

    for (unsigned i = 0; i < TIA_COUNT_OF(lines); i++)
        if (tia_word_is(word, lines[i]))
            return true;
    return false;
}

/* True if the line is a statement and not of a block. After the word "group", `rest` decides. */
static bool is_statement(const struct tia_parse *job, const struct tia_word *word, const struct tia_text *rest)
{
    struct tia_word next;

    if (!job->is_statement(word))
        return false;
    if (!tia_word_is(word, "group"))
        return !is_of_block(word);
    return !tia_text_peek(rest, &next) || (*next.at >= 'a' && *next.at <= 'z');
}

/* Returns 1 for a line that opens a block, -1 for one that ends a block, else 0. */
static int depth_of(const struct tia_parse *job, const struct tia_word *word, const struct tia_text *rest)
{
    static const char *const openers[] = {"repeat", "union", "intersection", "difference", "grid"};
    struct tia_text text = *rest;
    struct tia_word next;

    if (tia_word_is(word, "end"))
        return -1;
    for (unsigned i = 0; i < TIA_COUNT_OF(openers); i++)
        if (tia_word_is(word, openers[i]))
            return 1;
    if (tia_word_is(word, "group"))
        return is_statement(job, word, rest);
    (void)tia_text_word(&text, &next);
    return tia_word_is(word, "mesh") && !(tia_text_word(&text, &next) && tia_word_is(&next, "file"));
}

/* True if the rest of the text has an end for the block, besides those of groups and of later blocks. */
static bool has_end(struct tia_parse *job)
{
    struct tia_includes *includes = &job->includes;
    int64_t surplus = (int64_t)(includes->depth ? includes->outer[includes->depth - 1].groups : 0) - job->group_count;
    struct tia_text rest = job->text;
    struct tia_word word;

    if (job->mistakes && ++job->mistakes->scans > SCANS_MOST)
        return false;
    while (tia_text_line(&rest)) {
        (void)tia_text_word(&rest, &word);
        surplus -= depth_of(job, &word, &rest);
        tia_text_abandon(&rest);
    }
    return surplus > 0;
}

enum tia_block_line tia_block_take(struct tia_parse *job, struct tia_word *word)
{
    struct tia_text *t = &job->text, before = *t;

    if (tia_text_line(t)) {
        struct tia_text line = *t;
        (void)tia_text_word(t, word);
        if (tia_word_is(word, "end"))
            return TIA_BLOCK_END;
        if (!is_statement(job, word, t))
            return TIA_BLOCK_LINE;
        *t = line;
        if (has_end(job)) {
            (void)tia_text_word(t, word);
            return TIA_BLOCK_LINE;
        }
    }
    *t = before;
    return TIA_BLOCK_UNCLOSED;
}

int tia_block_refuse(struct tia_parse *job)
{
    (void)tia_block_has_no_end(&job->text, &job->first);
    return tia_text_goes_on(&job->text) ? TIA_OK : TIA_ERR_RANGE;
}

int tia_block_go_on(struct tia_parse *job)
{
    if (!tia_text_goes_on(&job->text))
        return TIA_ERR_RANGE;
    tia_text_abandon(&job->text);
    return TIA_OK;
}

int tia_block_skip(struct tia_parse *job)
{
    struct tia_word word;
    enum tia_block_line line;

    if (tia_block_go_on(job))
        return TIA_ERR_RANGE;
    while ((line = tia_block_take(job, &word)) == TIA_BLOCK_LINE)
        tia_text_abandon(&job->text);
    return TIA_OK;
}
