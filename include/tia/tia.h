/* tia.h - tia draws ray-traced pictures with integers only.
 *
 *   fixed.h   number formats and status codes
 *   vec.h     vectors and colours
 *   camera.h  where the picture is seen from
 *   scene.h   what is drawn
 *   render.h  from a scene to pixels
 *   port.h    what a board or an OS has to offer
 *   viewer.h  the interactive loop
 */
#ifndef TIA_TIA_H
#define TIA_TIA_H

#define TIA_VERSION "0.1.0"

#include <tia/viewer.h>

#endif
