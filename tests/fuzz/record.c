/* The records of pictures (common/record/record.h): raw bytes, and records as tia writes them with some bytes changed
 * and their hashes made right again. What is accepted is printed as the same bytes, and its names stay in their folder.
 */
#include <stdio.h>
#include <string.h>

#include "bytes.h"
#include "common/record/record.h"

static const char *const names[] = {"a.tia", "b/c.png", "../x", "/etc/passwd", "a//b", "./a", "a/..", "...", "a b", ""};

/* Fills a record with a film, files and options of any kind. */
static void take_record(struct bytes *b, struct record *r)
{
    uint8_t kind = take_byte(b), files = take_byte(b), options = take_byte(b);

    *r = (struct record){.definition = kind / 8 + 1u, .format = (enum image_format)(kind % 7 + 1)};
    (void)snprintf(r->tia, sizeof r->tia, "0.%u.0", kind);
    (void)snprintf(r->picture, sizeof r->picture, "%s", names[files / 16 % 10]);
    r->film = (struct image_film){.width = take_byte(b) + 1u, .height = take_byte(b) % 40 + 1u, .rate = {25, 1}};
    r->film.rows = 1 + take_byte(b) % r->film.height;
    r->film.first_row = r->film.height - r->film.rows;
    r->film.frames = 1 + take_byte(b) % 3u;
    r->film.all_frames = r->film.frames + kind % 2;
    r->film.depth = (unsigned)(int[]){0, 8, 16, 32, RECORD_SUMS, 7}[kind % 6];
    for (unsigned i = 0; i < files % 4u; i++) {
        struct record_file *file = record_add_file(r);
        MUST(file);
        file->size = take_word(b);
        (void)snprintf(file->name, sizeof file->name, "%s", names[take_byte(b) % 10]);
    }
    for (unsigned i = 0; i < options % 4u; i++) {
        char *option = record_add_option(r);
        MUST(option);
        (void)snprintf(option, RECORD_NAME, "samples=%u", (unsigned)take_byte(b));
    }
    MUST(record_make_groups(r));
    for (size_t i = 0; i < r->group_count; i++)
        r->groups[i].hash[i % SHA256_BYTES] = take_byte(b);
    MUST(record_set_root(r));
}

/* Changes some bytes, or cuts the text, and then makes the hash of its last line right, so that the change is seen by
 * the other checks. */
static size_t damage(struct bytes *b, char *text, size_t length)
{
    uint8_t changes = take_byte(b);
    unsigned char sum[SHA256_BYTES];
    char hash[SHA256_TEXT];
    struct sha256 sha;

    for (unsigned i = 0; i < changes % 4u; i++)
        text[take_word(b) % length] = (char)take_byte(b);
    if (changes & 4)
        length = take_word(b) % length;
    if (changes & 8 || length < SHA256_TEXT + 4)
        return length;
    size_t before = length - (SHA256_TEXT + 4);
    sha256_begin(&sha);
    sha256_add(&sha, text, before);
    sha256_end(&sha, sum);
    sha256_print(hash, sum);
    memcpy(text + before + 4, hash, SHA256_TEXT - 1);
    return length;
}

static void must_stay(const struct record *r)
{
    MUST(record_name_stays(r->picture) && !strchr(r->picture, '/'));
    for (size_t i = 0; i < r->file_count; i++)
        MUST(record_name_stays(r->files[i].name) && r->files[i].name[0] != '/' && !strstr(r->files[i].name, "../"));
}

static bool must_parse_well(const char *text, size_t length)
{
    struct record r;
    char why[RECORD_WHY];
    bool accepted = record_parse(&r, text, length, why);

    if (accepted) {
        size_t count;
        char *again = record_print(&r, &count);
        MUST(again && count == length && !memcmp(again, text, length));
        free(again);
        must_stay(&r);
    } else {
        MUST(*why && memchr(why, '\0', sizeof why) && !strchr(why, '\n'));
    }
    record_free(&r);
    return accepted;
}

/* Copies the bytes, so that reading beyond them is noticed. */
static void parse_raw(const uint8_t *data, size_t size)
{
    char *text = malloc(size + !size);

    MUST(text);
    memcpy(text, data, size);
    (void)must_parse_well(text, size);
    free(text);
}

static void parse_made(struct bytes *b)
{
    struct record r;
    size_t length;

    take_record(b, &r);
    char *text = record_print(&r, &length);
    MUST(text);
    length = damage(b, text, length);
    parse_raw((const uint8_t *)text, length);
    free(text);
    record_free(&r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes bytes = {data, size};

    if (size && data[0] == 'T') {
        parse_raw(data, size);
        return 0;
    }
    (void)take_byte(&bytes);
    parse_made(&bytes);
    return 0;
}
