/* file.h - a scene, and the files that were loaded for it. */
#ifndef TOOLS_SCENE_FILE_H
#define TOOLS_SCENE_FILE_H

#include <tia/tia.h>

#define SCENE_WHY 1024
#define SCENE_TEXT_MOST ((size_t)256 << 20)  /* largest size of the scene's own text, bytes */
#define SCENE_NAMED_MOST ((size_t)512 << 20) /* largest total size of its libraries, images and their texels, bytes */

struct scene_part; /* a file that the scene refers to */

/* Optional settings for reading a scene. */
struct scene_wish {
    tia_q16 reach;                          /* see tia/read.h */
    const struct tia_camera_change *camera; /* likewise; keyframes of what it sets are left out */
    unsigned threads;                       /* number of threads that read and build a large scene; 0 means 1 */
    bool hashed;                            /* set `crc`: 6 ms a megabyte */
    void (*material)(void *ctx, uint32_t index, const char *name);
    void *ctx;
    /* NULL, or called with each file before it is opened; returns false to refuse it */
    bool (*opens)(void *ctx, const char *path);
    void *opens_ctx;
};

#define SCENE_REFUSED "not read: the record does not name it"

struct scene_file {
    struct tia_scene scene;
    struct tia_placement placement;
    uint32_t crc;        /* CRC of the text and all files that it refers to; equal for equal scenes; 0 unless
                          * `hashed` */
    char why[SCENE_WHY]; /* after a failure: one line, "FILE:LINE:COLUMN: WHAT" or "FILE: WHAT" */
    char *report;        /* after a failure: all mistakes of the text, see scene_report.h; NULL: none are known */
    struct tia_read_warning warnings[TIA_WARNINGS];

    /* Private. */
    const struct scene_wish *wish;
    const char *path;
    void *memory, *boxes;
    struct scene_part *parts;
    size_t named_bytes;
    void *map, *tables; /* of a model, see model.h */
    size_t map_bytes;
};

/* True if the file may be opened. */
static inline bool scene_opens(const struct scene_file *file, const char *path)
{
    return !file->wish->opens || file->wish->opens(file->wish->opens_ctx, path);
}

#endif
