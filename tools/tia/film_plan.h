/* film_plan.h - the frames of a film: number, times, size. */
#ifndef TOOLS_TIA_FILM_PLAN_H
#define TOOLS_TIA_FILM_PLAN_H

#include "options.h"
#include "rotate.h"

/* Returns the time of frame `frame`; frame 0 is at --time. The time is rounded to the nearest 2^-16 s; the errors do
 * not accumulate. */
tia_q16 film_time(const struct options *options, uint32_t frame);

/* Returns the size of the picture, and its rotation in the file. */
struct rotation film_rotation(const struct options *options);

/* Finds the size, rows and frames of the file. EXIT_FINE, or EXIT_USAGE after an error message. */
int film_plan(const struct options *options, struct image_film *film);

#endif
