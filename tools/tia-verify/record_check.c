#include "record_check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/image/series.h"
#include "common/image/stored.h"
#include "common/record/row_hashes.h"
#include "common/verify/report.h"
#include "record_file.h"
#include "replay.h"
#include "tia/checking.h"
#include "tia/fail.h"

enum { LINES_MOST = 10 };

struct check {
    struct record_place place;
    const struct record_wish *wish;
    struct choice choice; /* of groups: a key has the first row */
    struct row_hashes hashes;
    struct report report;
};

/* ---- groups ---- */

static void place_of(const void *rows, uint64_t index, uint32_t *frame, unsigned *y)
{
    const struct record_group *group = &((const struct check *)rows)->place.record.groups[index];

    *frame = group->frame;
    *y = group->first;
}

/* Returns the first row of the group of row `y`; a row that is in no group as it is. */
static unsigned group_row(const struct check *c, unsigned y)
{
    unsigned first = c->place.record.film.first_row, rows = c->place.record.film.rows;

    return y < first || y - first >= rows ? y : first + (y - first) / RECORD_GROUP * RECORD_GROUP;
}

static int choose(struct check *c)
{
    struct choice_wish wish = c->wish->choice;

    wish.all = wish.all || (!wish.share && !wish.count && !wish.has_rows);
    if (wish.has_rows)
        wish.first_row = group_row(c, wish.first_row);
    if (choice_make(&c->choice, &wish, c->place.record.group_count, place_of, c))
        return fail(CHECK_FAILED, "memory: exhausted");
    if (c->choice.count)
        return CHECK_SAME;
    return fail(CHECK_FAILED, "--rows %u-%u: none of them is in %.200s", (unsigned)c->wish->choice.first_row,
                (unsigned)wish.last_row, c->place.path);
}

static bool wants(void *ctx, uint32_t frame, unsigned y)
{
    const struct check *c = ctx;

    return choice_has(&c->choice, frame, group_row(c, y));
}

static void add_row(void *ctx, uint32_t frame, unsigned y, const unsigned char *bytes, size_t length)
{
    row_hashes_add(&((struct check *)ctx)->hashes, frame, y, bytes, length);
}

/* ---- what is printed ---- */

static void print_hash(FILE *out, const char *what, const unsigned char *hash)
{
    char text[SHA256_TEXT];

    sha256_print(text, hash);
    (void)fprintf(out, "  %-5s %s\n", what, text);
}

static void print_group(const struct check *c, const struct record_group *group)
{
    report_name(&c->report);
    if (c->report.film)
        (void)fprintf(c->report.out, "frame %u, ", (unsigned)group->frame);
    (void)fprintf(c->report.out, "rows %u-%u: ", group->first, group->first + group->count - 1);
}

/* Prints the hashes that lead from a group to the root. */
static void print_path(const struct check *c, size_t index)
{
    const struct record *r = &c->place.record;
    struct merkle_step path[MERKLE_DEEPEST];
    unsigned char root[SHA256_BYTES];
    unsigned length = record_path(r, index, root, path);

    print_group(c, &r->groups[index]);
    (void)fprintf(c->report.out, "its path to the root\n");
    print_hash(c->report.out, "leaf", r->groups[index].hash);
    for (unsigned i = 0; i < length; i++)
        print_hash(c->report.out, path[i].left ? "left" : "right", path[i].hash);
    print_hash(c->report.out, "root", root);
}

static void compare_group(struct check *c, size_t index)
{
    const struct record_group *group = &c->place.record.groups[index];
    struct record_group found = *group;
    bool complete = row_hashes_group(&c->hashes, &found);

    c->report.seen++;
    if (complete && found.crc == group->crc && !memcmp(found.hash, group->hash, sizeof found.hash)) {
        if (c->wish->choice.has_rows)
            print_path(c, index);
        return;
    }
    if (++c->report.wrong > LINES_MOST)
        return;
    print_group(c, group);
    if (complete)
        (void)fprintf(c->report.out, "CRC-32 %08x in the record, %08x %s\n", (unsigned)group->crc, (unsigned)found.crc,
                      c->report.done);
    else
        (void)fprintf(c->report.out, "not all of them can be had\n");
}

/* Compares the CRC-32 of frames of which all groups were seen. */
static void compare_frames(struct check *c)
{
    const struct record *r = &c->place.record;

    for (uint32_t i = 0; i < r->film.frames && c->choice.count == c->choice.total && !c->report.wrong; i++)
        if (row_hashes_frame(&c->hashes, r, i) != r->frames[i]) {
            report_name(&c->report);
            (void)fprintf(c->report.out, "frame %u: its CRC-32 in the record is not that of its rows\n",
                          (unsigned)(r->film.first_frame + i));
            c->report.wrong++;
        }
}

static int report(struct check *c)
{
    const struct record *r = &c->place.record;

    for (size_t i = 0; i < r->group_count; i++)
        if (choice_has(&c->choice, r->groups[i].frame, r->groups[i].first))
            compare_group(c, i);
    compare_frames(c);
    return report_end(&c->report, &c->choice) ? CHECK_SAME : CHECK_DIFFERS;
}

/* ---- a record ---- */

static int check_root(const struct check *c)
{
    char text[SHA256_TEXT];

    sha256_print(text, c->place.record.root);
    if (!c->wish->root || strcmp(c->wish->root, text) == 0)
        return CHECK_SAME;
    report_name(&c->report);
    (void)fprintf(c->report.out, "its root is %s, not the given one\n", text);
    return CHECK_DIFFERS;
}

static int begin(struct check *c, const char *path)
{
    int result = record_file_open(&c->place, path);

    if (result)
        return result;
    c->report.film = c->place.record.film.all_frames > 1;
    result = check_root(c);
    if (!result && !row_hashes_begin(&c->hashes, &c->place.record.film))
        return fail(CHECK_FAILED, "%.300s: too many rows, or no memory", path);
    return result ? result : choose(c);
}

static void end(struct check *c)
{
    row_hashes_end(&c->hashes);
    choice_free(&c->choice);
    record_file_close(&c->place);
}

int record_check(const char *path, const struct record_wish *wish)
{
    struct check c = {.wish = wish};
    const struct row_tap tap = {wants, add_row, &c, NULL};

    c.report =
        (struct report){.name = path, .out = stdout, .unit = "groups of rows", .done = "drawn again", .from = ""};
    int result = begin(&c, path);
    result = result ? result : record_file_inputs(&c.place);
    result = result ? result : replay(&c.place, &tap, wish->threads);
    result = result ? result : report(&c);
    end(&c);
    return result;
}

/* ---- a picture and its record ---- */

/* Checks that the file can have the rows of the record. */
static int check_file(const struct check *c, struct stored *s)
{
    const struct image_film *film = &c->place.record.film;

    if (s->film.width == film->width && s->film.height == film->height && s->is_sums == (film->depth == RECORD_SUMS))
        return s->is_part || !stored_depth(s, film->depth) ? CHECK_SAME : fail(CHECK_FAILED, "%s", s->why);
    report_name(&c->report);
    (void)fprintf(c->report.out, "is of another size than the record says\n");
    return CHECK_DIFFERS;
}

static int hash_rows(struct check *c, struct stored *s, uint32_t frame)
{
    const struct image_film *film = &c->place.record.film;
    unsigned char *bytes = malloc(stored_row_bytes(s));
    int result = bytes ? CHECK_SAME : fail(CHECK_FAILED, "memory: exhausted");
    bool exact;

    for (unsigned y = film->first_row; y < film->first_row + film->rows && !result; y++) {
        if (!wants(c, frame, y))
            continue;
        if (stored_row(s, frame, y, bytes, &exact))
            result = fail(CHECK_FAILED, "%s", s->why);
        else if (exact) /* else the row is missing, and its group differs */
            row_hashes_add(&c->hashes, frame, y, bytes, stored_row_bytes(s));
    }
    free(bytes);
    return result;
}

/* Hashes the rows of some frames of a file. */
static int hash_file(struct check *c, const char *path, uint32_t first, uint32_t count)
{
    const struct image_film *film = &c->place.record.film;
    struct stored stored;
    int result = CHECK_FAILED;

    if (!path)
        return fail(CHECK_FAILED, "memory: exhausted");
    enum image_format format = image_format_of(path);
    format = format == IMAGE_UNKNOWN ? c->place.record.format : format;
    if (stored_open(&stored, path, format, film->width, film->height))
        (void)fail(0, "%s", stored.why);
    else
        result = check_file(c, &stored);
    for (uint32_t i = 0; i < count && !result; i++)
        result = hash_rows(c, &stored, first + i);
    stored_close(&stored);
    return result;
}

static int hash_picture(struct check *c, const char *picture)
{
    const struct image_film *film = &c->place.record.film;
    int result = CHECK_SAME;

    if (!series_is_pattern(picture))
        return hash_file(c, picture, film->first_frame, film->frames);
    for (uint32_t i = 0; i < film->frames && !result; i++) {
        char *path = series_path(picture, film->first_frame + i);
        result = hash_file(c, path, film->first_frame + i, 1);
        free(path);
    }
    return result;
}

int record_compare(const char *picture, const char *path, const struct record_wish *wish)
{
    struct check c = {.wish = wish};

    c.report = (struct report){.name = picture, .out = stdout, .unit = "groups of rows", .done = "read", .from = ""};
    int result = begin(&c, path);
    result = result ? result : hash_picture(&c, picture);
    result = result ? result : report(&c);
    end(&c);
    return result;
}
