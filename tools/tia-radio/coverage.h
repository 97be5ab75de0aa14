/* coverage.h - coverage: the gain at each point of a plane. */
#ifndef TOOLS_RADIO_COVERAGE_H
#define TOOLS_RADIO_COVERAGE_H

#include "site.h"

/* Draws the map and writes its numbers, to the files in `options`. Returns FINE, or the exit status after printing the
 * reason. */
int map_draw(const struct options *options, const struct site *site, const struct search *search);

/* Computes rows of the map again and compares them with the picture options->verify, whose size becomes that of the map
 * unless a size is given. Returns FINE; FAILED if rows differ; REFUSED after printing why they cannot be compared. */
int map_verify(struct options *options, const struct site *site, const struct search *search);

#endif
