#include "record_file.h"

#include <errno.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/message.h"
#include "common/regular.h"
#include "common/scene/whole_file.h"
#include "tia/checking.h"
#include "tia/fail.h"

bool record_file_is(const char *path)
{
    static const char magic[] = "TIARECORD ";
    char text[sizeof magic - 1];
    struct stat status;
    int fd = regular_open(path, &status);
    bool is = fd >= 0 && !regular_read(fd, text, sizeof text, 0) && !memcmp(text, magic, sizeof text);

    if (fd >= 0)
        (void)close(fd);
    return is;
}

static int find_folder(struct record_place *place)
{
    char *copy = strdup(place->path);

    place->given = copy ? strdup(dirname(copy)) : NULL;
    place->folder = place->given ? realpath(place->given, NULL) : NULL;
    free(copy);
    return place->folder ? CHECK_SAME : fail(CHECK_FAILED, "%.300s: %s", place->path, strerror(errno));
}

int record_file_open(struct record_place *place, const char *path)
{
    char why[RECORD_WHY];
    const char *reason;
    struct whole text;

    *place = (struct record_place){.path = path};
    int status = whole_read(&text, path, RECORD_MOST, &reason);
    if (status == TIA_ERR_RANGE)
        return fail(CHECK_FAILED, "%.300s: larger than %zu MiB", path, RECORD_MOST >> 20);
    if (status)
        return fail(CHECK_FAILED, "%.300s: %s", path, reason);
    bool fine = record_parse(&place->record, text.bytes, text.length, why);
    free(text.bytes);
    if (!fine)
        return fail(CHECK_FAILED, "%.300s:%s%s", path, why[0] >= '0' && why[0] <= '9' ? "" : " ", why);
    if (place->record.definition != RECORD_DEFINITION)
        return fail(CHECK_FAILED, "%.300s:3: drawn by definition %u; this tia draws definition %u", path,
                    (unsigned)place->record.definition, (unsigned)RECORD_DEFINITION);
    return find_folder(place);
}

void record_file_close(struct record_place *place)
{
    for (size_t i = 0; place->real && i < place->record.file_count; i++)
        free(place->real[i]);
    free(place->real);
    free(place->given);
    free(place->folder);
    record_free(&place->record);
}

/* ---- the files that it names ---- */

/* Resolves the path of a file, which may be a link within the folder. */
static int resolve(struct record_place *place, size_t number)
{
    const struct record_file *file = &place->record.files[number];
    char *path = NULL;

    if (asprintf(&path, "%s/%s", place->folder, file->name) < 0)
        return fail(CHECK_FAILED, "memory: exhausted");
    char *real = place->real[number] = realpath(path, NULL);
    free(path);
    if (!real)
        return fail(CHECK_FAILED, "%.300s: %.300s: %s", place->path, file->name, strerror(errno));
    if (!record_name_in(place->folder, real))
        return fail(CHECK_FAILED, "%.300s: %.300s: a link that leaves the record's folder", place->path, file->name);
    return CHECK_SAME;
}

static int check_input(struct record_place *place, size_t number)
{
    const struct record_file *file = &place->record.files[number];
    unsigned char hash[SHA256_BYTES];
    char line[RECORD_WHY + RECORD_NAME];
    uint64_t size;

    if (sha256_file(place->real[number], hash, &size))
        return fail(CHECK_FAILED, "%.300s: %.300s: %s", place->path, file->name, strerror(errno));
    if (size == file->size && !memcmp(hash, file->hash, sizeof hash))
        return CHECK_SAME;
    (void)snprintf(line, sizeof line, "%.300s: %s is not the file that was drawn: its SHA-256 is another", place->path,
                   file->name);
    message_clean(line);
    (void)puts(line);
    return CHECK_DIFFERS;
}

int record_file_inputs(struct record_place *place)
{
    int result = CHECK_SAME;

    place->real = calloc(place->record.file_count + 1, sizeof *place->real);
    if (!place->real)
        return fail(CHECK_FAILED, "memory: exhausted");
    for (size_t i = 0; i < place->record.file_count && !result; i++)
        result = resolve(place, i);
    for (size_t i = 0; i < place->record.file_count && !result; i++)
        result = check_input(place, i);
    return result;
}

bool record_file_allows(void *ctx, const char *path)
{
    const struct record_place *place = ctx;
    char *real = realpath(path, NULL);
    bool allowed = !real;

    for (size_t i = 0; i < place->record.file_count && !allowed; i++)
        allowed = strcmp(place->real[i], real) == 0;
    free(real);
    return allowed;
}
