/* read.h - reads scene files, without floating point and without heap.
 *
 * Decimal numbers are converted to fixed point directly, rounded to nearest, ties away from zero, so that a file gives
 * the same scene on every machine. The unit of length is chosen so that the scene makes good use of the range of
 * Q16.16, see scale_bits in scene.h. The caller holds the whole text in memory, and loads by name the files to which
 * the text refers: material libraries, included scenes, images.
 */
#ifndef TIA_READ_H
#define TIA_READ_H

#include <tia/job.h>
#include <tia/motion.h>
#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

enum tia_format {
    TIA_FORMAT_TIA, /* tia-scene(5) */
    TIA_FORMAT_NFF, /* the Standard Procedural Databases' neutral file format */
    TIA_FORMAT_OBJ, /* Wavefront, with .mtl */
    TIA_FORMAT_STL, /* stereolithography, text or binary */
    TIA_FORMAT_PLY, /* Stanford's polygons, text or binary */
    TIA_FORMAT_OFF, /* Geomview's object file format */
    TIA_FORMAT_PGM, /* a grey picture as a height field */
    TIA_FORMATS
};

/* The channel of an image that an opacity is read from. */
enum tia_channel {
    TIA_CHANNEL_OPACITY, /* alpha, or luminance where there is none */
    TIA_CHANNEL_RED,
    TIA_CHANNEL_GREEN,
    TIA_CHANNEL_BLUE,
    TIA_CHANNEL_ALPHA, /* opaque where there is none */
    TIA_CHANNEL_LUMINANCE,
    TIA_CHANNELS
};

#define TIA_MISTAKES_MAX 20 /* most mistakes that tia_read tells */

#define TIA_NAME_MAX 255 /* bytes of the name of a file, material, texture, ... */

/* An error in the text, to be printed as "FILE:LINE:COLUMN: what is wrong, what was expected", and below it the line
 * with a mark under the word. */
struct tia_read_error {
    char file[TIA_NAME_MAX + 1]; /* the included file with the error; "" for the scene's own text */
    uint32_t line, column;       /* from 1, columns in bytes; 0 when no single place is wrong */
    char text[280];              /* printable ASCII */
    uint32_t length;             /* bytes of the wrong word; 0: something is missing at that column */
    /* The line, any bytes, without its end; at most TIA_SOURCE_AFTER bytes behind the word. It is in the text that the
     * caller gave or loaded. NULL: none. */
    const char *source;
    uint32_t source_length;
};
#define TIA_SOURCE_AFTER 1024

/* Mistakes that a reader tolerates, and their remedies; all but the last occur only in models. */
enum tia_read_warning_kind {
    TIA_WARN_STATEMENT, /* an unknown or faulty statement: skipped */
    TIA_WARN_LIBRARY,   /* a material library that cannot be read: its materials are grey */
    TIA_WARN_MATERIAL,  /* an undefined material: grey */
    TIA_WARN_IMAGE,     /* an image that cannot be read: left out */
    TIA_WARN_OPTION,    /* an option of an image that is not supported: ignored */
    TIA_WARN_RANGE,     /* a number out of range: clamped */
    TIA_WARN_OPACITY,   /* a material that would be invisible, as with `Tr 1`: opaque */
    TIA_WARN_NUMBER,    /* no number where a texture coordinate is expected: 0 */
    TIA_WARN_NORMAL,    /* a normal without a direction: faces that use it have none */
    TIA_WARN_CORNER,    /* texture coordinates or normals on some corners of a face only: ignored */
    TIA_WARN_FACE,      /* a face with too few corners, or one whose vertex does not exist: left out */
    TIA_WARN_EMPTY,     /* a model without faces: only the background is visible */
    TIA_WARN_DARK,      /* in any format: a warning of tia_scene_check */
    TIA_WARNINGS
};

struct tia_read_warning {
    uint32_t count;           /* 0: none of this kind */
    struct tia_read_error at; /* the first mistake, and its remedy */
};

/* Parts of a camera that replace those of a file. Positions are in the file's unit, Q31.32. */
struct tia_camera_change {
    bool has_eye, has_reference, has_up;
    int64_t eye[3], reference[3];
    int64_t up[3]; /* any length but 0 */
    tia_q16 fov;   /* degrees: the camera becomes a perspective one; 0: no change */
    int64_t
        height; /* the camera becomes an orthographic one with a centred window of this height, Q31.32; 0: no change */
};

/* Where a reader puts positions: the position p of a file is (p - origin) 2^bits in the scene. */
struct tia_placement {
    int64_t origin[3]; /* Q31.32; other than 0 only for a model that is moved */
    int bits;          /* scale_bits of the scene, or the scale of that model */
};

struct tia_reader {
    enum tia_format format;
    const char *text;
    size_t length; /* the text may hold any bytes and needs no final 0 */

    /* Loads the file called `name`, a path relative to the scene's folder. On failure returns a negative status and
     * sets *why to a static string. The text is read in several passes: `library` may be called again for the same name
     * and must then return the same text. Here and below, the loaded memory stays the caller's and must outlive the
     * scene. If the function is NULL, a reference to such a file is an error. */
    int (*library)(void *ctx, const char *name, const char **text, size_t *length, const char **why);
    /* Loads an image: sets the texture's width, height and texels; if it has `footprint`, also `mip_levels`, without
     * which it is not filtered. Called once for each texture, and only once the memory is certain to suffice. Names and
     * errors are as for `library`. */
    int (*image)(void *ctx, const char *name, struct tia_texture *texture, const char **why);
    /* Loads one channel of an image, otherwise as `image` does. */
    int (*opacity)(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                   const char **why);
    void (*material)(void *ctx, uint32_t index, const char *name); /* NULL, or called for each named material */
    void *ctx;

    bool unscaled; /* lengths stay in the file's unit: scale_bits is 0 */
    /* If above 0, the unit of length is the finest in which the scene fits, together with all positions whose
     * coordinates are at most `reach`, in the file's unit. If 0, a unit finer than the file's is chosen only if a
     * length would be rounded, so that planes extend farther. */
    tia_q16 reach;
    /* Threads that share the reading of a large .obj file; NULL: none. The scene, the warnings and errors do not depend
     * on them, and the functions above are called on the caller's thread only. */
    const struct tia_workers *workers;
    const struct tia_camera_change *camera; /* NULL, or changes of the file's camera */
    struct tia_placement placement;         /* set by tia_read if it returns TIA_OK */
    bool strict;                            /* warnings are errors */
    struct tia_read_warning *warnings;      /* array of TIA_WARNINGS elements, by kind, which tia_read sets; or NULL */
    struct tia_read_error error;            /* set if tia_read returns TIA_ERR_RANGE: the first mistake */
    /* NULL, or called with each mistake, in the order of the text, for the first TIA_MISTAKES_MAX of them, before
     * tia_read returns TIA_ERR_RANGE. `image` and `opacity` may then have been called twice for a texture. What only
     * tia_scene_check refuses, and mistakes in formats other than TIA_FORMAT_TIA, are told one at a time. */
    void (*mistake)(void *ctx, const struct tia_read_error *error);
    uint32_t mistakes; /* set by tia_read: the number of mistakes; TIA_MISTAKES_MAX + 1: there are more */
};

/* The view of a model that has neither a camera nor lights, such as an .obj or .stl file: its eye is 35 degrees to the
 * right of +z and 25 above the horizon, and sees the sphere of that centre and radius, of TIA_RADIUS_MIN or more, in a
 * field of view of 40 degrees. Its lights are the sun, to the left of the eye and above it, and an ambient light for
 * its shadows. `lights` may be NULL. */
#define TIA_MODEL_LIGHTS 2
struct tia_camera tia_model_view(struct tia_vec3 centre, uint64_t radius, struct tia_light lights[TIA_MODEL_LIGHTS]);

/* Reads the scene into `memory` of `size` bytes, aligned for uint64_t; *scene points into it, and tia_scene_check
 * accepts it. *need is the number of bytes needed. When `size` is less, the status is TIA_ERR_MEMORY, and a second call
 * with *need bytes succeeds; `memory` may be NULL in the first. TIA_ERR_RANGE when the text is not a valid scene:
 * reader->error has the place and the reason. If *need is then greater than `size`, mistakes that need memory, such as
 * undefined names, were not looked for: a call with *need bytes tells all. */
int tia_read(struct tia_reader *reader, struct tia_scene *scene, void *memory, size_t size, size_t *need);

#ifdef __cplusplus
}
#endif

#endif
