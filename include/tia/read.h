/* read.h - scene files: from text to a scene, without floating point and without heap.
 *
 * Decimals become fixed point directly, rounded to nearest, ties away from zero. The whole text is in
 * memory; what it refers to - material libraries, images - the caller fetches by name.
 */
#ifndef TIA_READ_H
#define TIA_READ_H

#include <tia/motion.h>
#include <tia/scene.h>

enum tia_format {
    TIA_FORMAT_TIA, /* tia-scene(5) */
    TIA_FORMAT_NFF, /* the Standard Procedural Databases' neutral file format */
    TIA_FORMAT_OBJ  /* Wavefront, with .mtl */
};

#define TIA_NAME_MAX 255 /* bytes of a file's or thing's name */

/* Where reading stopped, "FILE:LINE:COLUMN: what is wrong, what was expected". */
struct tia_read_error {
    char file[TIA_NAME_MAX + 1]; /* the referred file that is at fault; "" for the scene's own text */
    uint32_t line, column;       /* from 1; 0 when the fault is of no single place */
    char text[200];
};

struct tia_reader {
    enum tia_format format;
    const char *text;
    size_t length; /* any bytes; nothing is taken for granted about them */

    /* Fetch what the text names, or return a negative status and *why, a static string. The memory stays
     * the caller's and must outlast the scene. NULL: the scene's format may not refer to such files. The
     * same library may be asked for more than once and must not change; an image is asked for once for
     * each texture that shows it, and not before the memory is known to suffice. */
    int (*library)(void *ctx, const char *name, const char **text, size_t *length, const char **why);
    int (*image)(void *ctx, const char *name, struct tia_texture *texture, const char **why);
    void *ctx;

    struct tia_read_error error; /* after TIA_ERR_RANGE */
};

/* Reads the scene into `memory`, aligned for uint64_t, at most `size` bytes; *scene points into it, and is
 * such that tia_scene_check accepts it. *need is how many bytes it takes: with too few the status is
 * TIA_ERR_MEMORY and *need enough for a second call. TIA_ERR_RANGE when the text is no scene: reader->error
 * says where and why. */
int tia_read(struct tia_reader *reader, struct tia_scene *scene, void *memory, size_t size, size_t *need);

#endif
