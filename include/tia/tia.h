/* tia.h - the interface of tia, a ray tracer in integers.
 *
 *   fixed.h   number formats and status codes
 *   job.h     threads that share long work, and its cancellation
 *   vec.h     vectors and colours
 *   camera.h, material.h, light.h, shape.h    the parts of a scene
 *   lightfield.h    pictures for displays that show each eye a different view
 *   shadow.h  techniques for shadows
 *   integrator.h    integrators of light
 *   scene.h   the scene
 *   bvh.h     bounding volume hierarchy for scenes of many objects
 *   motion.h  keyframe animation
 *   read.h    scene files
 *   render.h  from a scene to pixels
 *   rows.h    a picture row by row, in one call
 *   simd.h    vector units
 *   port.h    display, input and clock, as a board or an OS provides them
 *   gaze.h    foveated pictures
 *   orbit.h   moving a camera
 *   text.h    small text on pictures
 *   viewer.h  the interactive loop
 *
 * Not included by tia.h:
 *
 *   raster.h  polygons: depth, stencil and colour buffers
 *   denoise.h removal of noise from sampled pictures
 *   tone.h    conversion of sums of samples to pixel values
 *   radio.h   paths of radio waves, in libtia-radio.a
 *   spelling.h    words with two spellings, and near words
 *   mip.h     smaller copies of textures
 *   fit.h     a camera that is changed, or sees a whole scene
 *   step.h    lockstep: a scene step by step, with inputs
 *   damage.h  what has changed on a display
 *   trust.h   checks of memory and pixels, for displays that must not show a wrong picture
 *   debug.h   for tests and comparison
 */
#ifndef TIA_TIA_H
#define TIA_TIA_H

#define TIA_VERSION "0.1.0"

#include <tia/bvh.h>
#include <tia/motion.h>
#include <tia/orbit.h>
#include <tia/read.h>
#include <tia/rows.h>
#include <tia/simd.h>
#include <tia/text.h>
#include <tia/viewer.h>

#endif
