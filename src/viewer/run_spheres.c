/* run_spheres.c - the viewer of spheres alone. */
#include "loop.h"

int tia_viewer_run_spheres(struct tia_viewer *viewer)
{
    return tia_viewer_loop(viewer, NULL, NULL);
}
