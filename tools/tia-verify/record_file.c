#include "record_file.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/message.h"
#include "tia/checking.h"
#include "tia/fail.h"

/* Opens a regular file; others could block. */
static int open_regular(const char *path, uint64_t *size)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    struct stat status;

    if (fd < 0)
        return -1;
    if (fstat(fd, &status) == 0 && S_ISREG(status.st_mode)) {
        *size = (uint64_t)status.st_size;
        return fd;
    }
    (void)close(fd);
    errno = EINVAL;
    return -1;
}

static bool read_bytes(int fd, char *text, size_t count)
{
    for (size_t done = 0; done < count;) {
        ssize_t got = read(fd, text + done, count - done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        done += (size_t)got;
    }
    return true;
}

bool record_file_is(const char *path)
{
    static const char magic[] = "TIARECORD ";
    char text[sizeof magic - 1];
    uint64_t size;
    int fd = open_regular(path, &size);
    bool is = fd >= 0 && size >= sizeof text && read_bytes(fd, text, sizeof text) && !memcmp(text, magic, sizeof text);

    if (fd >= 0)
        (void)close(fd);
    return is;
}

/* Returns the text of the file, or NULL after a message. */
static char *read_text(const char *path, size_t *length)
{
    uint64_t size = 0;
    int fd = open_regular(path, &size);
    char *text = fd >= 0 && size <= RECORD_MOST ? malloc((size_t)size + 1) : NULL;

    if (fd >= 0 && size > RECORD_MOST)
        (void)fail(0, "%.300s: larger than %zu MiB", path, RECORD_MOST >> 20);
    else if (fd < 0 || !text)
        (void)fail(0, "%.300s: %s", path, fd < 0 ? strerror(errno) : "no memory for it");
    else if (!read_bytes(fd, text, (size_t)size)) {
        (void)fail(0, "%.300s: cannot be read", path);
        free(text);
        text = NULL;
    }
    if (fd >= 0)
        (void)close(fd);
    *length = (size_t)size;
    return text;
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
    size_t length;

    *place = (struct record_place){.path = path};
    char *text = read_text(path, &length);
    if (!text)
        return CHECK_FAILED;
    bool fine = record_parse(&place->record, text, length, why);
    free(text);
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
    size_t length = strlen(place->folder);
    char *path = NULL;

    if (asprintf(&path, "%s/%s", place->folder, file->name) < 0)
        return fail(CHECK_FAILED, "memory: exhausted");
    char *real = place->real[number] = realpath(path, NULL);
    free(path);
    if (!real)
        return fail(CHECK_FAILED, "%.300s: %.300s: %s", place->path, file->name, strerror(errno));
    if (strncmp(real, place->folder, length) != 0 || (length > 1 && real[length] != '/'))
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
