/* tia.h - tia draws ray-traced pictures with integers only.
 *
 *   fixed.h   number formats and status codes
 *   vec.h     vectors and colours
 *   camera.h  where the picture is seen from
 *   material.h, light.h, shape.h    what surfaces, lights and shapes there are
 *   scene.h   what is drawn: all of them together
 *   bvh.h     a hierarchy of boxes for scenes of many objects
 *   motion.h  keyframes: a scene at a time
 *   read.h    scene files
 *   render.h  from a scene to pixels
 *   port.h    what a board or an OS has to offer
 *   viewer.h  the interactive loop
 */
#ifndef TIA_TIA_H
#define TIA_TIA_H

#define TIA_VERSION "0.1.0"

#include <tia/bvh.h>
#include <tia/motion.h>
#include <tia/read.h>
#include <tia/viewer.h>

#endif
