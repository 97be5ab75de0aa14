/* scene.h - a scene file as a scene: the text read, what it names fetched, the boxes of its objects built. */
#ifndef PORT_SCENE_H
#define PORT_SCENE_H

#include <tia/tia.h>

#define SCENE_WHY 1024
#define SCENE_TEXT_MOST ((size_t)256 << 20)  /* bytes of the scene's own text */
#define SCENE_NAMED_MOST ((size_t)512 << 20) /* of all that it names: libraries, and the texels of images */
#define SCENE_UNKNOWN (-1)

struct scene_part; /* a file that the scene names */

struct scene_file {
    struct tia_scene scene;
    uint32_t crc;        /* of the text and of all that it names: the same files, the same scene */
    char why[SCENE_WHY]; /* after a failure: one line, "FILE:LINE:COLUMN: WHAT" or "FILE: WHAT" */

    /* Its own. */
    const char *path;
    void *memory, *boxes;
    struct scene_part *parts;
    size_t named_bytes;
};

/* The format called `name` ("tia"), or the one that a file's name ends in; SCENE_UNKNOWN for others. */
int scene_format_called(const char *name);
int scene_format_of(const char *path);

/* Reads the scene `path`, "-" for standard input, which is of `format` (enum tia_format). What it names is
 * looked for beside it. TIA_ERR_MEMORY; TIA_ERR_DEVICE when a file cannot be read; TIA_ERR_RANGE when it is no
 * scene: then *file->why says why, and nothing needs to be closed. `path` must last as long as the file. */
int scene_open(struct scene_file *file, const char *path, int format);
void scene_close(struct scene_file *file);

/* CRC-32 of bytes, to be continued: start with 0. */
uint32_t scene_crc(uint32_t crc, const void *bytes, size_t length);

#endif
