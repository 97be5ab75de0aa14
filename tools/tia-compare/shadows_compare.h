/* shadows_compare.h - tia-compare --shadows: the techniques for shadows compared with exact ones, scene by scene. */
#ifndef TIA_COMPARE_SHADOWS_COMPARE_H
#define TIA_COMPARE_SHADOWS_COMPARE_H

#include "common/thread_pool.h"
#include "options.h"

/* Compares techniques in each scene of the command line. Returns the exit status, after an error message if it is not
 * 0. */
int shadows_compare(const struct options *options, struct threads *pool);

#endif
