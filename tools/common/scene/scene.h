/* scene.h - loads a scene file: reads the text, loads the files that it refers to, builds the hierarchy. */
#ifndef PORT_SCENE_H
#define PORT_SCENE_H

#include <tia/tia.h>

#define SCENE_WHY 1024
#define SCENE_TEXT_MOST ((size_t)256 << 20)  /* bytes of the scene's own text */
#define SCENE_NAMED_MOST ((size_t)512 << 20) /* of all that it refers to: libraries, and texels of images */
#define SCENE_UNKNOWN (-1)

struct scene_part; /* a file that the scene refers to */

struct scene_file {
    struct tia_scene scene;
    uint32_t crc;        /* of the text and all files that it refers to; equal for equal scenes */
    char why[SCENE_WHY]; /* after a failure: one line, "FILE:LINE:COLUMN: WHAT" or "FILE: WHAT" */

    /* Private. */
    const char *path;
    void *memory, *boxes;
    struct scene_part *parts;
    size_t named_bytes;
};

/* The format called `name` ("tia"), or that of a file by its extension; SCENE_UNKNOWN for others. */
int scene_format_called(const char *name);
int scene_format_of(const char *path);

/* Reads the scene `path` ("-": standard input) of `format` (enum tia_format). Files that it refers to are relative to
 * its directory. TIA_ERR_MEMORY; TIA_ERR_DEVICE when a file cannot be read; TIA_ERR_RANGE when it is not a valid scene.
 * After an error file->why has the reason, and nothing needs to be closed. `path` must outlive the file. */
int scene_open(struct scene_file *file, const char *path, int format);
void scene_close(struct scene_file *file);

/* CRC-32 of bytes; start with 0 and pass the result on. */
uint32_t scene_crc(uint32_t crc, const void *bytes, size_t length);

#endif
