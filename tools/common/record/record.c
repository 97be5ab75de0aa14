#include "record.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

unsigned record_frame_groups(const struct image_film *film)
{
    return (film->rows + RECORD_GROUP - 1) / RECORD_GROUP;
}

bool record_make_groups(struct record *r)
{
    unsigned each = record_frame_groups(&r->film);
    uint64_t groups = (uint64_t)each * r->film.frames;

    if (groups > RECORD_MOST / SHA256_TEXT)
        return false;
    size_t count = (size_t)groups;
    r->groups = calloc(count + 1, sizeof *r->groups);
    r->frames = calloc((size_t)r->film.frames + 1, sizeof *r->frames);
    if (!r->groups || !r->frames)
        return false;
    r->group_count = count;
    for (size_t i = 0; i < count; i++) {
        struct record_group *group = &r->groups[i];
        unsigned first = (unsigned)(i % each) * RECORD_GROUP, left = r->film.rows - first;
        group->frame = r->film.first_frame + (uint32_t)(i / each);
        group->first = r->film.first_row + first;
        group->count = left < RECORD_GROUP ? left : RECORD_GROUP;
    }
    return true;
}

/* Makes room for one more item in an array of `count`, which doubles at each power of two. */
static void *grow(void *array, size_t count, size_t size)
{
    if (count >= RECORD_ITEMS)
        return NULL;
    return count & (count - 1) ? array : realloc(array, (count ? 2 * count : 1) * size);
}

struct record_file *record_add_file(struct record *r)
{
    struct record_file *files = grow(r->files, r->file_count, sizeof *files);

    if (!files)
        return NULL;
    r->files = files;
    files[r->file_count] = (struct record_file){.size = 0};
    return &files[r->file_count++];
}

char *record_add_option(struct record *r)
{
    char(*options)[RECORD_NAME + 1] = grow(r->options, r->option_count, sizeof *options);

    if (!options)
        return NULL;
    r->options = options;
    options[r->option_count][0] = '\0';
    return options[r->option_count++];
}

bool record_name_stays(const char *name)
{
    for (const char *at = name; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            return false;
    for (const char *part = name;; part++) {
        size_t length = strcspn(part, "/");
        if (length == 0 || (length <= 2 && strspn(part, ".") >= length))
            return false;
        part += length;
        if (*part == '\0')
            return true;
    }
}

const char *record_name_in(const char *folder, const char *path)
{
    size_t length = strlen(folder);

    if (length == 1)
        return path + 1;
    return strncmp(path, folder, length) == 0 && path[length] == '/' ? path + length + 1 : NULL;
}

static const unsigned char *leaf_of(const void *leaves, size_t index)
{
    return ((const struct record_group *)leaves)[index].hash;
}

unsigned record_path(const struct record *r, size_t index, unsigned char root[SHA256_BYTES],
                     struct merkle_step path[MERKLE_DEEPEST])
{
    return merkle_path(root, path, leaf_of, r->groups, r->group_count, index);
}

bool record_set_root(struct record *r)
{
    struct merkle_step path[MERKLE_DEEPEST];

    if (!r->group_count)
        return false;
    (void)record_path(r, SIZE_MAX, r->root, path);
    return true;
}

void record_free(struct record *r)
{
    free(r->files);
    free(r->options);
    free(r->groups);
    free(r->frames);
    *r = (struct record){.format = IMAGE_UNKNOWN};
}

/* ---- writing ---- */

static void print_groups(FILE *out, const struct record *r)
{
    char hash[SHA256_TEXT];
    unsigned each = record_frame_groups(&r->film);

    for (size_t i = 0; i < r->group_count; i++) {
        const struct record_group *group = &r->groups[i];
        sha256_print(hash, group->hash);
        (void)fprintf(out, "rows %u %u %u %08x %s\n", (unsigned)group->frame, group->first, group->count,
                      (unsigned)group->crc, hash);
        if (i % each == each - 1)
            (void)fprintf(out, "frame %u %08x\n", (unsigned)group->frame, (unsigned)r->frames[i / each]);
    }
}

static void print_head(FILE *out, const struct record *r)
{
    const struct image_film *film = &r->film;
    char hash[SHA256_TEXT];

    (void)fprintf(out, "TIARECORD %u\ntia %s\ndefinition %u\npicture %s %s\n", (unsigned)RECORD_FORMAT, r->tia,
                  (unsigned)r->definition, image_format_name(r->format), r->picture);
    (void)fprintf(out, "film W%u H%u R%u+%u N%u+%u/%u F%u:%u D%u\n", film->width, film->height, film->first_row,
                  film->rows, (unsigned)film->first_frame, (unsigned)film->frames, (unsigned)film->all_frames,
                  (unsigned)film->rate[0], (unsigned)film->rate[1], film->depth);
    for (size_t i = 0; i < r->file_count; i++) {
        sha256_print(hash, r->files[i].hash);
        (void)fprintf(out, "file %s %" PRIu64 " %s\n", hash, r->files[i].size, r->files[i].name);
    }
    for (size_t i = 0; i < r->option_count; i++)
        (void)fprintf(out, "option %s\n", r->options[i]);
}

char *record_print(const struct record *r, size_t *length)
{
    char *text = NULL, hash[SHA256_TEXT];
    unsigned char sum[SHA256_BYTES];
    struct sha256 sha;
    FILE *out = open_memstream(&text, length);

    if (!out)
        return NULL;
    print_head(out, r);
    print_groups(out, r);
    sha256_print(hash, r->root);
    (void)fprintf(out, "root %s\n", hash);
    if (fflush(out) == 0) {
        sha256_begin(&sha);
        sha256_add(&sha, text, *length);
        sha256_end(&sha, sum);
        sha256_print(hash, sum);
        (void)fprintf(out, "end %s\n", hash);
    }
    bool failed = ferror(out) != 0;
    if (fclose(out) != 0 || failed) {
        free(text);
        return NULL;
    }
    return text;
}
