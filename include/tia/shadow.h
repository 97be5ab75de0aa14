/* shadow.h - techniques for shadows, to compare with each other. All but the first draw scenes of planes, boxes,
 * triangles and meshes by the rasteriser, see raster.h, whose vertices are rounded once and whose depths are exact.
 * There each technique gives the same picture, but for those that are known not to be exact.
 *
 * What else such a scene needs: opaque materials (transmission 0, no opacity), one sample a pixel, no disc and sphere
 * lights, and at most TIA_SHADOW_SAMPLES samples of all its lights and keys together. Area lights have the same sample
 * points at each pixel, those of b = 0 in light.h. Only what is seen directly has these shadows; in mirrors they are
 * traced.
 */
#ifndef TIA_SHADOW_H
#define TIA_SHADOW_H

#define TIA_SHADOW_SAMPLES 64

enum tia_shadows {
    TIA_SHADOWS_TRACED, /* rays that start a little off the surface, any scene */
    TIA_SHADOWS_RAYS,   /* rays from what is seen, exact: whether any face stands between that and the light */
    TIA_SHADOWS_ZPASS,  /* shadow volumes, counted before what is seen; where that cannot tell, as TIA_SHADOWS_ZFAIL */
    TIA_SHADOWS_ZFAIL   /* shadow volumes, counted behind what is seen; where that cannot tell, as TIA_SHADOWS_ZPASS */
};

/* "traced", "rays", "zpass", "zfail"; NULL beyond the last. */
const char *tia_shadows_name(unsigned technique);

#endif
