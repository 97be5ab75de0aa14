/* raster.h - draws convex polygons into depth, stencil and colour buffers; only their vertices are rounded.
 *
 * A vertex is (x, y, w), with `fraction` fraction bits, and h; the caller has rounded these once. All else is computed
 * exactly: which pixels a polygon covers, and which of two polygons is nearer at a pixel. So no pixel at a common edge
 * is drawn twice or left out, and the result does not depend on drawing order, tiles or machine.
 *
 * Perspective: x, y, w are clip coordinates, the image shows -w..w, and w grows away from the eye. They are also affine
 * coordinates with the eye at 0. h is 1 for a point, and 0 for a direction, that is, a vertex at infinity whose
 * coordinates are a difference of two points. w may have any sign: there is no near plane, nothing is clipped and no
 * depth is out of range. Orthographic: w is 1, stored as 2^fraction, and h is the nearness: larger is nearer. A
 * direction has w = 0.
 *
 * Pixel (i, j) of the image shows the points at positive multiples of D(i, j), an integer vector linear in i and j.
 * Where an edge passes exactly through the pixel's centre, D is moved to the right by an infinitesimal distance, then
 * down by a still smaller one: the top-left rule of OpenGL and Direct3D. A polygon whose plane contains the eye is not
 * drawn.
 *
 *     quantity                               perspective   orthographic   kept in
 *     coordinate of a point q, size below        2^40          2^29       int64_t
 *     coordinate of a direction, size below      2^41          2^30       int64_t
 *     h, size at most                             1            2^30
 *     D, any component, at most                  2^30          2^30
 *     normal of an edge, q x q                   2^83          2^61       128 bits
 *     edge at a pixel, (q x q).D                 2^115         2^93       128 bits
 *     f = N.D, N = sum of h_i (q_j x q_k)        2^117         2^125      128 bits
 *     det = det(q, q, q)                         2^126         2^93       128 bits
 *     order in depth, f1 det2 - f2 det1          2^243         2^218      256 bits, where a filter is undecided
 *
 * (8192^2 pixels, 16 samples.) Polygons with smaller coordinates need only 64 bits for all but det; each such polygon
 * is detected and drawn faster, with the same result.
 */
#ifndef TIA_RASTER_H
#define TIA_RASTER_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_RASTER_CORNERS 8   /* largest number of corners of a polygon */
#define TIA_NO_FACE UINT32_MAX /* no face at this pixel */

/* The pixels of an image: D(i, j) = (x + right i, y - down j, w). */
struct tia_raster_grid {
    enum tia_projection projection;
    uint16_t width, height; /* size of the whole image */
    int32_t x, y, w, right, down;
    int32_t centre[2]; /* position of x = y = 0, in 2^-16 pixel from the centre of pixel (0, 0) */
    int fraction;      /* fraction bits of the vertices */
    int scale;         /* nearness is 1/t 2^scale, where the visible point is t D; see struct tia_raster_target */
    int64_t narrow;    /* largest coordinate of a polygon that needs only 64 bits */
};

#define TIA_RANGE_MAX 24  /* largest `range` of tia_raster_grid_init in perspective */
#define TIA_RANGE_FLAT 20 /* the same in orthographic views */

/* Sets the grid of sample number `sample`, 0..samples - 1, of each pixel of a width x height image (1..TIA_SIZE_MAX
 * each) with 1, 4 or 16 `samples` per pixel, placed as in camera.h. All coordinates of points must be below 2^range in
 * magnitude; `range` is 0..TIA_RANGE_MAX, in orthographic views 0..TIA_RANGE_FLAT. TIA_FRUSTUM counts as perspective,
 * since its shear is in the vertices. TIA_ERR_ARGUMENT when an argument is outside these bounds.
 *
 * The function chooses `fraction`. In perspective it is 25 - range if that is at least 18 and most polygons then fit 64
 * bits, else 40 - range; in orthographic views it is 29 - range, or 28 when `range` is 0, as w is 1. Of 6 million
 * pixels of meshes, 5 show another face with 18 fraction bits than with 34, and none with 22. */
int tia_raster_grid_init(struct tia_raster_grid *grid, enum tia_projection projection, unsigned width, unsigned height,
                         uint32_t samples, uint32_t sample, unsigned range);

struct tia_raster_vertex {
    int64_t x, y, w, h;
};

/* OpenGL's comparisons, in its order. The new value is on the left: TIA_COMPARE_LESS passes nearer pixels, or those
 * where reference & mask is less than stored & mask. */
enum tia_compare {
    TIA_COMPARE_NEVER,
    TIA_COMPARE_LESS,
    TIA_COMPARE_EQUAL,
    TIA_COMPARE_LEQUAL,
    TIA_COMPARE_GREATER,
    TIA_COMPARE_NOTEQUAL,
    TIA_COMPARE_GEQUAL,
    TIA_COMPARE_ALWAYS
};

/* OpenGL's operations. TIA_STENCIL_INCR and TIA_STENCIL_DECR stop at 255 and 0. */
enum tia_stencil_op {
    TIA_STENCIL_KEEP,
    TIA_STENCIL_ZERO,
    TIA_STENCIL_REPLACE,
    TIA_STENCIL_INCR,
    TIA_STENCIL_DECR,
    TIA_STENCIL_INVERT,
    TIA_STENCIL_INCR_WRAP,
    TIA_STENCIL_DECR_WRAP
};

struct tia_stencil {
    enum tia_compare test;
    uint8_t reference, mask; /* the mask applies to both sides of the comparison */
    uint8_t write;           /* bits of the buffer that may change */
    enum tia_stencil_op fail, zfail, zpass;
};

/* Two polygons are equal in depth at a pixel if they have the same face, or lie in the same plane. Where two planes
 * cross exactly at a pixel, D is moved to the right, then down, as above: the plane that is then nearer is nearer. An
 * empty pixel is farther than any polygon. */
struct tia_raster_state {
    enum tia_compare depth;
    bool depth_write;  /* a pixel that passes also stores the polygon's face */
    bool ties_by_face; /* in the same plane, the face with the smaller number is nearer: the drawing order does not
                          matter */
    bool skip_front, skip_back; /* corners of front faces run counterclockwise in the image */
    bool ahead;                 /* orthographic: draw only where h <= 0, that is, in front of the window */
    struct tia_stencil front, back;
    bool colour_write[3];
    uint16_t colour[3];
};

/* Buffers of a target, for tia_raster_size. */
enum tia_buffer {
    TIA_BUFFER_DEPTH = 1,   /* nearness, face and planes: without it every pixel passes the depth test */
    TIA_BUFFER_STENCIL = 2, /* without it every pixel passes the stencil test */
    TIA_BUFFER_COLOUR = 4,
    TIA_BUFFER_SUM = 8, /* with TIA_BUFFER_COLOUR only */
    TIA_BUFFER_COUNT = 16
};

/* The plane of a face: at pixel (i, j) 1/t is (x i + y j + c)/det, each number in two halves, the lower first. det is 0
 * for a face that is never drawn. */
struct tia_raster_plane {
    uint64_t x[2], y[2], c[2], det[2];
};

/* The rasteriser's inner loops for an instruction set; their results are those of plain C. */
struct tia_raster_runs;

/* The buffers of a rectangle of the image, row by row. An absent buffer is NULL. */
struct tia_raster_target {
    const struct tia_raster_grid *grid;
    struct tia_tile area;
    uint32_t *face;     /* TIA_NO_FACE at empty pixels */
    uint64_t *nearness; /* 1/t 2^scale, in orthographic views plus 2^61, with an error below 2^15 and clamped to
                           0..2^62; 0 at empty pixels. In perspective w = 1/16 has a nearness of 2^61..2^62, in
                           orthographic views h = -2^range has one of 0..2^60 */
    uint8_t *stencil;
    uint32_t *count; /* TIA_STENCIL_INCR_WRAP and TIA_STENCIL_DECR_WRAP count here too, modulo 2^32 and without masks */
    uint16_t *colour; /* three a pixel: red, green, blue */
    uint32_t *sum;    /* the accumulation buffer, three a pixel */
    struct tia_raster_plane *planes;
    uint32_t face_count, pitch;         /* pitch: pixels from one row to the next */
    bool planes_known;                  /* `planes` are the caller's, computed for another target, and only read */
    const struct tia_raster_runs *runs; /* NULL: plain C; see tia_simd_raster */
    uint32_t exact;                     /* number of depth tests that the filter could not decide */
};

/* Returns the number of bytes for a target of `area` with `buffers`, a sum of enum tia_buffer, and faces 0..faces - 1;
 * SIZE_MAX when that number does not fit. */
size_t tia_raster_size(struct tia_tile area, unsigned buffers, uint32_t faces);

/* Creates a target in `memory`, aligned for uint64_t, and clears it. The grid must outlive it. TIA_ERR_ARGUMENT when
 * the area is empty or not inside the image, or `buffers` is not such a sum; TIA_ERR_MEMORY when `size` is too
 * small. */
int tia_raster_init(struct tia_raster_target *target, void *memory, size_t size, const struct tia_raster_grid *grid,
                    struct tia_tile area, unsigned buffers, uint32_t faces);

/* Empties the depth buffer. This function and those below do nothing, and return TIA_OK, if the target lacks the
 * buffer. */
int tia_raster_clear_depth(struct tia_raster_target *target);
/* Sets the bits of `write` in the stencil buffer to those of `value`, as OpenGL's clear does. */
int tia_raster_clear_stencil(struct tia_raster_target *target, uint8_t value, uint8_t write);
/* Sets all counts to `value`. */
int tia_raster_clear_count(struct tia_raster_target *target, uint32_t value);
/* Sets the colour buffer to one colour: red, green, blue. */
int tia_raster_clear_colour(struct tia_raster_target *target, const uint16_t colour[3]);
/* Sets the accumulation buffer to 0. */
int tia_raster_clear_sum(struct tia_raster_target *target);

/* Adds `weight` times the colour buffer to the accumulation buffer; the sum of all weights must be at most 65536.
 * TIA_ERR_ARGUMENT for a single weight above that. With this buffer a caller can average the pictures of an area
 * light's sample points. */
int tia_raster_sum_add(struct tia_raster_target *target, uint32_t weight);
/* Sets the colour buffer to the accumulation buffer divided by `total`, rounded to nearest, ties up. TIA_ERR_ARGUMENT
 * when the total is not in 1..65536. */
int tia_raster_sum_return(struct tia_raster_target *target, uint32_t total);

/* Draws a convex polygon of 3..TIA_RASTER_CORNERS corners by `state`. Its plane, for depth, is that of its first three
 * corners. A polygon that writes depth needs a face below face_count, and a face must keep its plane until the depth
 * buffer is cleared; other polygons may have TIA_NO_FACE. TIA_ERR_ARGUMENT for a face that is not below face_count, for
 * another number of corners or an enum of the state beyond its last value; TIA_ERR_RANGE when a vertex is out of the
 * range above. */
int tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                    const struct tia_raster_vertex *corners, unsigned count, uint32_t face);

/* A triangle prepared for interpolation. */
struct tia_raster_corners {
    uint64_t weights[3][3][2];
};

/* Prepares a triangle. False when the eye is in the triangle's plane, or a vertex is out of range: *corners is then
 * undefined. */
bool tia_raster_corners_init(struct tia_raster_corners *corners, const struct tia_raster_grid *grid,
                             const struct tia_raster_vertex vertices[3]);

/* Interpolates a[0], a[1], a[2], given at the corners, linearly on the triangle's plane, to the point that pixel (x, y)
 * of the image shows: perspective-correct, rounded to nearest, ties up, and clamped to the range of tia_q16. The value
 * at a corner that is a direction is ignored. Returns 0 where the plane is not in front of the eye, and for x and y not
 * in 0..TIA_SIZE_MAX - 1. */
tia_q16 tia_raster_corners_blend(const struct tia_raster_corners *corners, int x, int y, const tia_q16 a[3]);

#ifdef __cplusplus
}
#endif

#endif
