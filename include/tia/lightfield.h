/* lightfield.h - pictures for displays that show each eye a different view, with horizontal parallax only.
 *
 * The display is a flat screen in the scene: the window of a TIA_FRUSTUM camera with an observer line, see camera.h.
 * Each pixel of such a picture, or each of its three subpixels, is a pixel of an ordinary off-axis picture of the whole
 * screen, seen from an eye somewhere on that line. The kinds differ only in the choice of pixel and eye. So each pixel
 * of a light field equals a pixel of one of those pictures.
 *
 * A quilt is a grid of such pictures, each of floor(width/columns) x floor(height/rows) pixels. View 0, the leftmost,
 * is at the lower left; the next views follow to the right, then row by row upwards. Remaining columns at the right and
 * rows at the top stay black.
 *
 * A subpixel of a lenticular panel lies under a lens, which sends its light in one direction only. The lenses are
 * parallel and straight, so a subpixel's place under its lens is a linear function of its place in the picture, modulo
 * 1. This phase is the position on the observer line from which the subpixel is visible, from 0, the left end, to 1,
 * the right end. Subpixel k = 0, 1, 2 of pixel x, in row r, counted from 0 at the bottom, of a picture W pixels wide
 * has the phase
 *
 *     ((x + 1/2 + k/3) pitch + (r + 1/2) rise)/W - centre   modulo 1,   or if `inverted`, 1 less this.
 *
 * With rise = pitch/slope this is the formula of HoloPlayCore's shader, published by Looking Glass Factory, without its
 * intermediate quilt of views. The subpixel is pixel 3x + k of the row of an ordinary picture that is three times as
 * wide. Without subpixels k is 0, and the ordinary picture is as wide as the light field.
 *
 * A projector behind the screen sends the light of its pixel x through the screen at q, the middle of that pixel's
 * column on the screen, to the observer line at
 *
 *     s = q + (q - p) D/d,
 *
 * where p is the projector's position, d its distance from the screen, and D that of the observer line; p, q and s are
 * lengths along the camera's axis u. The projector projects the whole picture. Pixels whose light misses the line are
 * black.
 */
#ifndef TIA_LIGHTFIELD_H
#define TIA_LIGHTFIELD_H

#include <tia/camera.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_QUILT_MAX 256
#define TIA_PITCH_MAX (INT64_C(1) << 60)

enum tia_light_field_kind { TIA_QUILT, TIA_LENTICULAR, TIA_PROJECTOR };

struct tia_quilt {
    uint16_t columns, rows; /* number of views, each 1..TIA_QUILT_MAX */
};

enum tia_subpixels { TIA_SUBPIXELS_RGB, TIA_SUBPIXELS_BGR, TIA_SUBPIXELS_NONE };

struct tia_lenticular {
    /* Number of lenses in the width of the picture, 40 fraction bits. |pitch| and |rise| are below TIA_PITCH_MAX. */
    int64_t pitch;
    int64_t rise;                 /* phase gained over as many rows as the picture is wide, 40 fraction bits */
    int64_t centre;               /* offset of the phase, 40 fraction bits */
    enum tia_subpixels subpixels; /* order of subpixels, from left to right */
    bool flipped;                 /* the picture is mirrored left to right, together with its lenses */
    bool inverted;
};

struct tia_projector {
    tia_q16 place;    /* position along u, from the middle of the screen */
    tia_q16 distance; /* distance behind the screen, above 0 */
};

/* Only the member for `kind` is used. */
struct tia_light_field {
    enum tia_light_field_kind kind;
    struct tia_quilt quilt;
    struct tia_lenticular lens;
    struct tia_projector projector;
};

/* Returns the position of the eye of view number `view`, of `views` views spread from one end of the observer line to
 * the other: along u, from the line's middle, rounded to the nearest 2^-16. The position is 0, the middle, for a single
 * view, for a number that is not below `views`, and for a line of negative length. */
tia_q16 tia_light_field_place(const struct tia_camera *camera, uint32_t view, uint32_t views);

/* Sets *out to the ordinary off-axis camera whose eye is at `place` on the observer line: eye and reference are moved
 * by `place` times u, each coordinate rounded to the nearest 2^-16; the window stays where it is, and out->line is 0.
 * TIA_ERR_RANGE, and *out stays as it is, when `place` is beyond the line's ends, when tia_scene_check refuses *camera,
 * and when the moved eye or reference has a coordinate outside of -32768 to 32768. */
int tia_light_field_camera(struct tia_camera *out, const struct tia_camera *camera, tia_q16 place);

#ifdef __cplusplus
}
#endif

#endif
