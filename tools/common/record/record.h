/* record.h - the record of a picture: what it takes to draw it again, and hashes of its rows; docs/verify.md has the
 * format. */
#ifndef TOOLS_RECORD_RECORD_H
#define TOOLS_RECORD_RECORD_H

#include "common/image/image.h"
#include "merkle.h"

#define RECORD_FORMAT 1
#define RECORD_DEFINITION 1 /* the version in the title of docs/definition.md */
#define RECORD_WHY 512
#define RECORD_GROUP 16                /* rows of a group */
#define RECORD_SUMS 64                 /* depth of a part of sums */
#define RECORD_MOST ((size_t)64 << 20) /* largest size of a record, bytes */
#define RECORD_NAME 512                /* longest name or option, bytes */
#define RECORD_ITEMS 1024              /* most files, and most options */

/* A file that was read. */
struct record_file {
    char name[RECORD_NAME + 1]; /* relative to the record's folder */
    uint64_t size;
    unsigned char hash[SHA256_BYTES];
};

/* Up to RECORD_GROUP rows of a frame. */
struct record_group {
    uint32_t frame, crc;
    unsigned first, count;
    unsigned char hash[SHA256_BYTES]; /* the leaf of the tree */
};

struct record {
    char tia[32]; /* version of tia */
    uint32_t definition;
    enum image_format format;
    char picture[RECORD_NAME + 1];    /* name of the picture, without folder */
    struct image_film film;           /* depth: see struct image_film, or RECORD_SUMS */
    struct record_file *files;        /* the first is the scene; none: the built-in one */
    char (*options)[RECORD_NAME + 1]; /* "samples=4", "dither" */
    struct record_group *groups;      /* in the order of frames and rows */
    uint32_t *frames;                 /* CRC-32 of each frame */
    size_t file_count, option_count, group_count;
    unsigned char root[SHA256_BYTES];
};

/* Returns the number of groups of a frame. */
unsigned record_frame_groups(const struct image_film *film);

/* Allocates the groups and frames for record->film, and sets the places of the groups. False: no memory. */
bool record_make_groups(struct record *record);

/* Adds a file or an option, which the caller fills in. NULL: too many, or no memory. */
struct record_file *record_add_file(struct record *record);
char *record_add_option(struct record *record);

/* True if the name is relative and stays in its folder: no "/" at the begin, no empty part, no "." or "..", and no
 * control characters. */
bool record_name_stays(const char *name);

/* Returns the name of a resolved path in a resolved folder; NULL: it is outside. */
const char *record_name_in(const char *folder, const char *path);

/* Computes the root from the hashes of the groups. False: there are none. */
bool record_set_root(struct record *record);

/* Computes the root, and the path of group `index` to it, from the group upwards. Returns the length of the path. There
 * is at least one group. */
unsigned record_path(const struct record *record, size_t index, unsigned char root[SHA256_BYTES],
                     struct merkle_step path[MERKLE_DEEPEST]);

/* Parses a record and verifies its hashes of itself. Only the spelling of record_print is accepted. False, with one
 * line in why[RECORD_WHY], "LINE: WHAT" or "WHAT": not valid. record_free is to be called in any case. */
bool record_parse(struct record *record, const char *text, size_t length, char *why);

/* Returns the text of a record, to be freed by free(), and its length; NULL: no memory. */
char *record_print(const struct record *record, size_t *length);

void record_free(struct record *record);

#endif
