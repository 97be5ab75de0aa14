/* shadow.h - techniques for shadows, for comparison with each other. All but TIA_SHADOWS_TRACED draw planes, boxes,
 * triangles and meshes by the rasteriser, see raster.h, whose vertices are rounded once and whose depths are exact. All
 * these techniques give the same picture of them, except those marked as not exact. Spheres, discs, cylinders, cones
 * and grids are drawn by rays: primary rays find where they are nearer than all faces, and shadow rays, towards the
 * lights that no face hides, find their shadows. Shadows on these shapes are traced.
 *
 * With `tessellated` in scene.h these shapes, except grids, become flat faces instead. The faces decide visibility and
 * shadow, while colour, normal and reflection are those of the true surface where the ray meets it. So outlines and the
 * borders of shadows have corners, and a face can turn away from the light a little before the true surface does.
 *
 * A scene with a technique other than TIA_SHADOWS_TRACED needs opaque materials (transmission 0, no opacity), no sphere
 * lights except with TIA_FILTER_PCSS, and at most TIA_SHADOW_SAMPLES_MAX samples of all its lights and keys together.
 * Area lights have the same sample points at each pixel, those of b = 0 in light.h. Only directly visible surfaces have
 * these shadows; in mirrors they are traced. Hits take 4 bytes for each pixel and 28 for each of its samples, with
 * TIA_SHADOWS_MAP_EXACT 36; filters of maps take 2 more for each sample of all lights.
 */
#ifndef TIA_SHADOW_H
#define TIA_SHADOW_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_SHADOW_SAMPLES_MAX 64

enum tia_shadows {
    TIA_SHADOWS_TRACED, /* for any scene: rays that start a little off the surface */
    TIA_SHADOWS_RAYS,   /* exact rays from the visible point, tested with each face */
    TIA_SHADOWS_ZPASS,  /* counts shadow volumes in front of the visible point; if that is undecided, as
                           TIA_SHADOWS_ZFAIL */
    TIA_SHADOWS_ZFAIL,  /* counts shadow volumes behind the visible point; if that is undecided, as TIA_SHADOWS_ZPASS */
    TIA_SHADOWS_MAP,    /* shadow maps, see struct tia_shadow_map: not exact */
    TIA_SHADOWS_MAP_EXACT,  /* an alias-free map, whose samples are the visible points: exact */
    TIA_SHADOWS_ZPASS_PLAIN /* TIA_SHADOWS_ZPASS, assuming that no volume contains the eye: wrong where one does */
};

/* Returns "traced", "rays", "zpass", "zfail", "map", "map-exact", "zpass-plain"; NULL beyond the last. */
const char *tia_shadows_name(unsigned technique);

/* Shadow maps: images of the distances from a light to the nearest faces, of size x size texels. A directional light
 * has one map, around the scene's corners; a spot light whose outer cone is at most TIA_SPOT_MAP degrees has one,
 * around the cone; other lights have six, the faces of a cube. Each sample of a rectangle or disc has its own map. A
 * texel takes 4 bytes.
 *
 * A point is lit unless the map's distance is below the point's own distance less a bias, which keeps faces from
 * shadowing themselves. In a map of 90 degrees a texel is 2 w/size wide at the distance w. With the amount a the bias
 * is
 *
 *     none       0
 *     constant   a, in the file's units, see scene.h
 *     slope      a texels times 1 + tan(t), t the angle between the light and the face's normal, tan(t) at most 50
 *     normal     none; the point is moved a texels along the normal, towards the light
 *     plane      a texels; the point's distance is that of its face's plane at the centre of the tap's texel
 *
 * Filters take several texels, the taps; the point's light is the fraction of taps that are lit. The taps are the texel
 * itself; the four around the point, weighted bilinearly; n x n; 16 in a disc of radius 3, which is rotated from pixel
 * to pixel. PCSS (Fernando 2005) searches the texels that the light's disc can see for blockers; its taps are those
 * that the penumbra then covers, 2 x 2 at least. It treats any area light as a disc of the same area, with one sample
 * that represents them all. */
enum tia_bias {
    TIA_BIAS_DEFAULT, /* TIA_BIAS_SLOPE, whose amount is TIA_SHADOW_AMOUNT_DEFAULT */
    TIA_BIAS_NONE,
    TIA_BIAS_CONSTANT,
    TIA_BIAS_SLOPE,
    TIA_BIAS_NORMAL,
    TIA_BIAS_PLANE
};

enum tia_filter {
    TIA_FILTER_DEFAULT, /* TIA_FILTER_3X3 */
    TIA_FILTER_NONE,
    TIA_FILTER_BILINEAR,
    TIA_FILTER_3X3,
    TIA_FILTER_5X5,
    TIA_FILTER_7X7,
    TIA_FILTER_POISSON,
    TIA_FILTER_PCSS
};

#define TIA_MAP_SIZE_DEFAULT 1024 /* texels along a side */
#define TIA_MAP_SIZE_MIN 64
#define TIA_MAP_SIZE_MAX 4096
#define TIA_SHADOW_AMOUNT_DEFAULT TIA_Q16(2)
#define TIA_AMOUNT_BITS_MAX 12
#define TIA_SPOT_MAP 60

struct tia_shadow_map {
    uint16_t size;       /* a power of 2 from TIA_MAP_SIZE_MIN to TIA_MAP_SIZE_MAX; 0 means TIA_MAP_SIZE_DEFAULT */
    uint8_t amount_bits; /* for TIA_BIAS_CONSTANT, 0..TIA_AMOUNT_BITS_MAX; 0 for others */
    enum tia_bias bias;
    tia_q16 amount; /* amount of the bias, times 2^amount_bits; at least 0 */
    enum tia_filter filter;
};

/* Returns "none", "constant", "slope", "normal", "plane", from TIA_BIAS_NONE on; NULL for others. */
const char *tia_bias_name(unsigned bias);
/* Returns "none", "bilinear", "3x3", "5x5", "7x7", "poisson", "pcss", from TIA_FILTER_NONE on; NULL for others. */
const char *tia_filter_name(unsigned filter);

#ifdef __cplusplus
}
#endif

#endif
