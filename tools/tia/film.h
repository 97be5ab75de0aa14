/* film.h - which frames there are, and when. */
#ifndef TOOLS_TIA_FILM_H
#define TOOLS_TIA_FILM_H

#include "options.h"
#include "rotate.h"

/* The time of frame `frame`, counted from 0 at --time: exact to the nearest 2^-16 s, whatever came before. */
tia_q16 film_time(const struct options *options, uint32_t frame);

/* The picture's size, and how it is turned into the file. */
struct rotation film_turn(const struct options *options);

/* What goes into the file: size, rows, frames. EXIT_FINE, or EXIT_USAGE after one line that says what is wrong. */
int film_plan(const struct options *options, struct image_film *film);

#endif
