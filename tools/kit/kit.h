/* kit.h - pictures, their comparison and the exact rasteriser behind functions of plain numbers: what the packages for
 * Python (a shared library) and npm (WebAssembly) call. One thread at a time may be in these functions. docs/kit.md
 */
#ifndef TOOLS_KIT_KIT_H
#define TOOLS_KIT_KIT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __wasm__
#define KIT_EXPORT(name) __attribute__((export_name(#name)))
#else
#define KIT_EXPORT(name)
#endif

/* Returns TIA_VERSION. */
KIT_EXPORT(kit_version) const char *kit_version(void);
/* Returns the reason of the last error: one line. */
KIT_EXPORT(kit_why) const char *kit_why(void);
KIT_EXPORT(kit_alloc) void *kit_alloc(size_t size);
KIT_EXPORT(kit_free) void kit_free(void *memory);

/* The elements of kit_draw's options. */
enum kit_option {
    KIT_WIDTH,
    KIT_HEIGHT,
    KIT_INTEGRATOR, /* enum tia_integrator; -1: the scene's */
    KIT_SAMPLES,    /* samples of a pixel; 0: the scene's */
    KIT_SEED,       /* seed of samples; -1: the scene's */
    KIT_DITHER,     /* not 0: dithered */
    KIT_TIME,       /* time of a scene that moves, in 2^-16 seconds */
    KIT_OPTIONS
};

/* Draws the scene file `name` into KIT_WIDTH x KIT_HEIGHT RGB565 pixels, row by row from the top. Its bytes and those
 * of the files that it refers to come from the caller, see files.c. Returns TIA_OK or a negative tia_status, with the
 * reason in kit_why; the pixels are then undefined. */
KIT_EXPORT(kit_draw) int kit_draw(const char *name, const int32_t *options, uint16_t *pixels);

/* Returns the CRC-32 of the pixels as little-endian RGB565: that of `tia --checksum`. */
KIT_EXPORT(kit_crc) uint32_t kit_crc(const uint16_t *pixels, uint32_t count);
/* Expands pixels to red, green and blue of 8 bits each by bit replication, as `tia` writes them to files. */
KIT_EXPORT(kit_expand) void kit_expand(const uint16_t *pixels, uint32_t count, uint8_t *rgb);
/* Returns the number of pixels that differ, and draws them into `rgb`: red where a channel differs by more than one
 * level, yellow where none does, and pixels that agree in grey, at a quarter of their brightness. */
KIT_EXPORT(kit_compare)
uint32_t kit_compare(const uint16_t *a, const uint16_t *b, uint32_t count, uint8_t *rgb);

/* ---- the exact rasteriser, include/tia/raster.h ---- */

struct kit_raster;

/* The elements of a state, each as in struct tia_raster_state: the stencil of front faces, then that of back faces, has
 * KIT_SIDE elements. */
enum kit_state {
    KIT_DEPTH,
    KIT_DEPTH_WRITE,
    KIT_TIES_BY_FACE,
    KIT_SKIP_FRONT,
    KIT_SKIP_BACK,
    KIT_FRONT, /* test, reference, mask, write, fail, zfail, zpass */
    KIT_SIDE = 7,
    KIT_STATE = KIT_FRONT + 2 * KIT_SIDE
};

/* Creates depth and stencil buffers of width x height pixels (1..1024 each), for `faces` faces (1..2^20). Returns NULL
 * on failure, with the reason in kit_why. */
KIT_EXPORT(kit_raster_create)
struct kit_raster *kit_raster_create(uint32_t width, uint32_t height, uint32_t faces);
KIT_EXPORT(kit_raster_free) void kit_raster_free(struct kit_raster *raster);
/* Empties the depth buffer, and sets the stencil buffer to `stencil`. */
KIT_EXPORT(kit_raster_clear) void kit_raster_clear(struct kit_raster *raster, uint32_t stencil);

/* Draws a triangle. A corner has three numbers: its position from the image's upper left corner, x to the right and y
 * down, in 1/256 of a pixel, and its distance w from the eye, 1 or more; corners of equal w have equal depth. Returns
 * TIA_OK; TIA_ERR_ARGUMENT for a state or a face that does not exist; TIA_ERR_RANGE for a corner that is too far away:
 * x and y must be below 2^24 in magnitude, and |2 x - 256 width| height w, |2 y - 256 height| width w and
 * 256 width height w below 2^40. */
KIT_EXPORT(kit_raster_triangle)
int kit_raster_triangle(struct kit_raster *raster, const int32_t *state, const int32_t *corners, uint32_t face);

/* Return the buffers, row by row from the top: the face at each pixel, UINT32_MAX at empty ones, and the stencil. */
KIT_EXPORT(kit_raster_faces) const uint32_t *kit_raster_faces(const struct kit_raster *raster);
KIT_EXPORT(kit_raster_stencil) const uint8_t *kit_raster_stencil(const struct kit_raster *raster);

/* ---- between the files of the kit ---- */

/* Stores the reason of an error. */
void kit_refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));

#ifndef __wasm__
/* Sets the functions that return files: the size of a file, or -1 if there is none of that name, and its bytes. `name`
 * has `length` characters. */
void kit_set_files(int32_t (*size)(const char *name, uint32_t length),
                   void (*read)(const char *name, uint32_t length, void *bytes));
#endif

#endif
