/* include.c - scenes in several files.
 *
 * The caller loads a file by its path relative to the scene's folder. A name in a file is relative to that file's
 * folder: leg.tia in models/chair.tia means models/leg.tia. The stack of open files stores only the words that name
 * them: paths are computed from these words.
 */
#include "parse_state.h"

bool tia_path_follow(char path[TIA_NAME_MAX + 1], const struct tia_word *name)
{
    size_t folder = 0;

    for (size_t i = 0; path[i] && *name->at != '/'; i++)
        folder = path[i] == '/' ? i + 1 : folder;
    if (folder + name->length > TIA_NAME_MAX)
        return false;
    for (uint32_t i = 0; i < name->length; i++)
        path[folder + i] = name->at[i];
    path[folder + name->length] = 0;
    return true;
}

/* Writes the path of the file at a depth: "" at depth 0, the scene itself. */
static void path_at(const struct tia_includes *includes, unsigned depth, char path[TIA_NAME_MAX + 1])
{
    path[0] = 0;
    for (unsigned i = 0; i < depth; i++)
        (void)tia_path_follow(path, &includes->names[i]);
}

int tia_include_path(struct tia_parse *job, const struct tia_word *name, char path[TIA_NAME_MAX + 1])
{
    path_at(&job->includes, job->includes.depth, path);
    if (!tia_path_follow(path, name))
        return tia_text_error(&job->text, name, "has too long a path", "a path of at most 255 bytes from the scene");
    return TIA_OK;
}

int tia_parse_missing(struct tia_parse *job, const struct tia_word *file, const char *why, const char *expected)
{
    (void)tia_text_error_at(&job->text, file);
    tia_say_word(job->text.error, file);
    tia_say(job->text.error, ": ");
    tia_say(job->text.error, why);
    tia_say(job->text.error, ", expected ");
    tia_say(job->text.error, expected);
    return TIA_ERR_RANGE;
}

static bool is_same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

static int includes_itself(struct tia_parse *job, const struct tia_word *name)
{
    return tia_text_error(&job->text, name, "is already being read", "a file that does not include itself");
}

static int check(struct tia_parse *job, const struct tia_word *name, const char *path)
{
    const struct tia_includes *includes = &job->includes;
    char other[TIA_NAME_MAX + 1];

    for (unsigned i = 1; i <= includes->depth; i++) {
        path_at(includes, i, other);
        if (is_same(path, other))
            return includes_itself(job, name);
    }
    if (includes->depth == TIA_INCLUDE_DEPTH)
        return tia_text_error(&job->text, name, "is one file too deep", "at most 8 within each other");
    if (includes->count == TIA_INCLUDES_MAX)
        return tia_text_error(&job->text, name, "is one file too many", "at most 64 includes");
    if (!job->reader->library)
        return tia_text_error(&job->text, name, "cannot be fetched here", "a scene of one file");
    return TIA_OK;
}

/* True if the file is the scene, whose own name is not known, or a copy in the same folder, which includes itself as
 * well. */
static bool is_scene(const struct tia_reader *reader, const char *path, const char *text, size_t length)
{
    size_t same = 0;

    for (; *path; path++)
        if (*path == '/')
            return false;
    if (length != reader->length)
        return false;
    while (same < length && text[same] == reader->text[same])
        same++;
    return same == length;
}

static int read_include(struct tia_parse *job)
{
    struct tia_reader *reader = job->reader;
    char path[TIA_NAME_MAX + 1];
    const char *text = NULL, *why = "cannot be read";
    struct tia_word name;
    size_t length = 0;
    int status = tia_text_file(&job->text, &name, "a file's name");

    status = status ? status : tia_include_path(job, &name, path);
    status = status ? status : check(job, &name, path);
    if (status)
        return status;
    if (reader->library(reader->ctx, path, &text, &length, &why))
        return tia_parse_missing(job, &name, why, "a scene's file");
    if (tia_text_is_too_long(length))
        return tia_text_error(&job->text, &name, "is too long", "less than 4 GiB");
    if (is_scene(reader, path, text, length))
        return includes_itself(job, &name);
    job->includes.next = tia_text_begin(text ? text : "", text ? length : 0, job->includes.file, job->text.error);
    job->includes.next.constants = &job->constants;
    job->includes.next.tolerance = job->text.tolerance;
    job->includes.next.lengths = &job->reach.lengths;
    job->includes.names[job->includes.depth] = name;
    return TIA_OK;
}

int tia_line_include(struct tia_parse *job)
{
    int status = read_include(job);

    if (status && job->mistakes)
        job->mistakes->lost = true;
    return status;
}

void tia_include_begin(struct tia_parse *job)
{
    struct tia_includes *includes = &job->includes;

    includes->outer[includes->depth].text = job->text;
    includes->outer[includes->depth].groups = job->group_count;
    includes->depth++;
    includes->count++;
    path_at(includes, includes->depth, includes->file);
    job->text = includes->next;
    includes->next.next = NULL;
}

int tia_include_end(struct tia_parse *job)
{
    struct tia_includes *includes = &job->includes;
    unsigned base = includes->depth ? includes->outer[includes->depth - 1].groups : 0;

    if (job->mistakes)
        tia_mistake_close(job, base);
    if (job->group_count > base)
        return tia_block_has_no_end(&job->text, &job->groups[job->group_count - 1].first);
    if (!includes->depth)
        return TIA_OK;
    includes->depth--;
    job->text = includes->outer[includes->depth].text;
    path_at(includes, includes->depth, includes->file);
    return TIA_OK;
}
