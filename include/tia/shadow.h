/* shadow.h - techniques for shadows, to compare with each other. All but the first draw planes, boxes, triangles and
 * meshes by the rasteriser, see raster.h, whose vertices are rounded once and whose depths are exact. All techniques
 * give the same picture of these, except those marked as not exact. Spheres, discs, cylinders, cones and grids are left
 * to rays: primary rays where they are nearer than all faces, and shadow rays towards lights that no face hides. On
 * these shapes themselves shadows are traced.
 *
 * With `tessellated` in scene.h they become flat faces instead, all but grids: the faces decide visibility and shadow,
 * while colour, normal and reflection are those of the true surface where the ray meets it. So outlines and the borders
 * of shadows have corners, and a face can turn away from the light a little before the true surface does.
 *
 * Such a scene needs opaque materials (transmission 0, no opacity), no sphere lights but with TIA_FILTER_PCSS, and at
 * most TIA_SHADOW_SAMPLES samples of all its lights and keys together. Area lights have the same sample points at each
 * pixel, those of b = 0 in light.h. Only directly visible surfaces have these shadows; in mirrors they are traced. Hits
 * take 28 bytes for each sample of a pixel and 4 more; TIA_SHADOWS_MAP_EXACT 36, filters of maps 2 more for each sample
 * of all lights.
 */
#ifndef TIA_SHADOW_H
#define TIA_SHADOW_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_SHADOW_SAMPLES 64

struct tia_scene;
struct tia_light;
struct tia_mesh;

enum tia_shadows {
    TIA_SHADOWS_TRACED, /* rays that start a little off the surface, any scene */
    TIA_SHADOWS_RAYS,   /* exact rays from the visible point, tested with each face */
    TIA_SHADOWS_ZPASS,  /* shadow volumes, counted in front of the visible point; where undecided, as TIA_SHADOWS_ZFAIL
                         */
    TIA_SHADOWS_ZFAIL,  /* shadow volumes, counted behind the visible point; where undecided, as TIA_SHADOWS_ZPASS */
    TIA_SHADOWS_MAP,    /* shadow maps, see struct tia_shadow_map: not exact */
    TIA_SHADOWS_MAP_EXACT,  /* an alias-free map, whose samples are the visible points: exact */
    TIA_SHADOWS_ZPASS_PLAIN /* as TIA_SHADOWS_ZPASS, assuming the eye in no volume: wrong where it is in one */
};

/* Returns "traced", "rays", "zpass", "zfail", "map", "map-exact", "zpass-plain"; NULL beyond the last. */
const char *tia_shadows_name(unsigned technique);

/* Returns the first object (see render.h) that is too far away for the rasteriser, in a width x height view that
 * tia_view_init has refused with TIA_ERR_RANGE, or TIA_NO_OBJECT, as for a scene that tia_scene_check refuses. A corner
 * is too far if a clip coordinate, see raster.h, reaches 2^TIA_RANGE_MAX, in orthographic views 2^TIA_RANGE_FLAT: it is
 * then that many times half the view's width or height off its middle. */
uint32_t tia_shadow_too_far(const struct tia_scene *scene, unsigned width, unsigned height);

/* Returns the first of these lights for the scene that is too far away, in a view that tia_view_init or
 * tia_view_set_lights has refused. Of a light with an area all of it counts. *range receives the r for which 2^r is too
 * far: as for corners, but less in an orthographic view whose image has more than 1024 pixels in a row or column. There
 * lights much farther away than all corners are in range, too: they count as directional where this moves no shadow by
 * half a pixel. */
uint32_t tia_shadow_light_too_far(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count,
                                  unsigned width, unsigned height, unsigned *range);

/* Shadow maps: pictures of the distance from a light to the nearest face, in size x size texels. A directional light
 * has one map, around the scene's corners; a spot light whose outer cone is at most TIA_SPOT_MAP degrees has one,
 * around the cone; other lights have six, the faces of a cube. Each sample of a rectangle or disc has its own, 4 bytes
 * a texel.
 *
 * A point is lit where the map has no distance below its own less a bias, which keeps faces from shadowing themselves.
 * In a map of 90 degrees a texel is 2 w/size long at the distance w. With the amount a the bias is
 *
 *     none       0
 *     constant   a, in the file's units, see scene.h
 *     slope      a texels times 1 + tan(t), t the angle between the light and the face's normal, the tangent at most 50
 *     normal     none; the point is moved a texels along the normal, towards the light
 *     plane      a texels; and the distance is that of the face's plane where the tap's texel has its centre
 *
 * Filters take several texels, the taps; the point's light is the fraction of taps that are lit. The taps are the texel
 * itself; the four around the point, weighted bilinearly; n x n; 16 in a disc of radius 3, which turns from pixel to
 * pixel. PCSS (Fernando 2005) searches the texels that the light's disc can see for blockers, and takes those that the
 * penumbra then covers, 2 x 2 at least. It treats any area light as a disc of the same area, with one sample that
 * stands for all. */
enum tia_bias {
    TIA_BIAS_DEFAULT, /* TIA_BIAS_SLOPE, whose amount is TIA_SHADOW_AMOUNT */
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

#define TIA_MAP_SIZE 1024 /* the default */
#define TIA_MAP_SIZE_MIN 64
#define TIA_MAP_SIZE_MAX 4096
#define TIA_SHADOW_AMOUNT TIA_Q16(2)
#define TIA_AMOUNT_BITS_MAX 12
#define TIA_SPOT_MAP 60

struct tia_shadow_map {
    uint16_t size;       /* a power of 2 from TIA_MAP_SIZE_MIN to TIA_MAP_SIZE_MAX; 0 means TIA_MAP_SIZE */
    uint8_t amount_bits; /* for TIA_BIAS_CONSTANT, 0..TIA_AMOUNT_BITS_MAX; 0 for others */
    enum tia_bias bias;
    tia_q16 amount; /* times 2^-amount_bits; at least 0 */
    enum tia_filter filter;
};

/* Returns "none", "constant", "slope", "normal", "plane", from TIA_BIAS_NONE on; NULL for others. */
const char *tia_bias_name(unsigned bias);
/* Returns "none", "bilinear", "3x3", "5x5", "7x7", "poisson", "pcss", from TIA_FILTER_NONE on; NULL for others. */
const char *tia_filter_name(unsigned filter);

/* Returns the bytes of room for tia_shadow_mesh_closes. */
size_t tia_shadow_mesh_room(const struct tia_mesh *mesh);
/* True if each edge of a mesh has a face on its other side that runs along it in the opposite direction. A mesh that
 * does not close casts the same shadow, but face by face, so its volumes have more sides. `room` is aligned for
 * uint32_t, or the result is false; the mesh is one that tia_scene_check accepts. */
bool tia_shadow_mesh_closes(const struct tia_mesh *mesh, void *room);

#ifdef __cplusplus
}
#endif

#endif
