/* page_record.c - the record of a picture, docs/verify.md, as `tia --record` writes it. */
#include "page.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/record/row_hashes.h"
#include "common/scene/whole_file.h"

#define EXPORT(name) __attribute__((export_name(name)))

static struct record record;

static int refuse(const char *what, const char *name)
{
    (void)snprintf(session.why, sizeof session.why, "record: %s%s%.200s", what, name[0] ? ": " : "", name);
    return 1;
}

/* Begins a record of a PNG called `name`. Returns 0, or 1 with the reason in web_why. */
EXPORT("web_record_begin") int web_record_begin(const char *name);
int web_record_begin(const char *name)
{
    record_free(&record);
    record = (struct record){.definition = RECORD_DEFINITION,
                             .format = IMAGE_PNG,
                             .film = {.width = session.settings.width,
                                      .height = session.settings.height,
                                      .rows = session.settings.height,
                                      .frames = 1,
                                      .all_frames = 1,
                                      .rate = {25, 1}}};
    (void)snprintf(record.tia, sizeof record.tia, TIA_VERSION);
    (void)snprintf(record.picture, sizeof record.picture, "%s", name);
    return record_name_stays(name) ? 0 : refuse("not a name of a file", name);
}

/* Adds a file of the page's. */
EXPORT("web_record_file") int web_record_file(const char *name);
int web_record_file(const char *name)
{
    struct record_file *file = record_add_file(&record);
    const char *why = "too many files";
    struct sha256 sha;
    struct whole whole;

    if (!file || strlen(name) >= sizeof file->name || !record_name_stays(name))
        return refuse(file ? "a file outside of the scene's folder" : why, name);
    if (whole_read(&whole, name, SIZE_MAX, &why))
        return refuse(why, name);
    (void)snprintf(file->name, sizeof file->name, "%s", name);
    file->size = whole.length;
    sha256_begin(&sha);
    sha256_add(&sha, whole.bytes, whole.length);
    sha256_end(&sha, file->hash);
    free(whole.bytes);
    return 0;
}

/* Adds an option of tia, NAME or NAME=VALUE. */
EXPORT("web_record_option") int web_record_option(const char *text);
int web_record_option(const char *text)
{
    char *option = strlen(text) <= RECORD_NAME ? record_add_option(&record) : NULL;

    if (!option)
        return refuse("too many options", text);
    memcpy(option, text, strlen(text) + 1);
    return 0;
}

/* Draws a row and gives it to the hashes, two bytes a pixel, the lower one first. */
static bool add_row(struct row_hashes *hashes, unsigned y)
{
    unsigned width = session.screen.width;
    const tia_rgb565 *pixels = session.screen.pixels + (size_t)y * width;
    unsigned char *bytes = malloc(2 * (size_t)width);

    if (!bytes || rows_draw(y, 1)) {
        free(bytes);
        return false;
    }
    for (unsigned x = 0; x < width; x++) {
        bytes[2 * x] = (unsigned char)(pixels[x] & 255);
        bytes[2 * x + 1] = (unsigned char)(pixels[x] >> 8);
    }
    row_hashes_add(hashes, 0, y, bytes, 2 * (size_t)width);
    free(bytes);
    return true;
}

static bool add_groups(struct row_hashes *hashes)
{
    for (unsigned y = 0; y < record.film.rows; y++)
        if (!add_row(hashes, y))
            return false;
    for (size_t i = 0; i < record.group_count; i++)
        if (!row_hashes_group(hashes, &record.groups[i]))
            return false;
    record.frames[0] = row_hashes_frame(hashes, &record, 0);
    return record_set_root(&record);
}

/* Draws the picture that web_rows_begin has prepared. Returns the record's text; NULL on failure, with the reason in
 * web_why. */
EXPORT("web_record_end") const char *web_record_end(void);
const char *web_record_end(void)
{
    static char *text;
    struct row_hashes hashes = {.rows = NULL};
    size_t length;

    free(text);
    text = NULL;
    if (record_make_groups(&record) && row_hashes_begin(&hashes, &record.film) && add_groups(&hashes))
        text = record_print(&record, &length);
    row_hashes_end(&hashes);
    if (!text)
        (void)refuse("the picture cannot be drawn again", "");
    return text;
}
