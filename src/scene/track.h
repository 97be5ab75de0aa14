/* track.h - values of tracks. */
#ifndef TIA_SCENE_TRACK_H
#define TIA_SCENE_TRACK_H

#include <tia/motion.h>

/* Returns a track's value at the time. */
struct tia_vec3 tia_track_value(const struct tia_track *track, tia_q16 time);

/* True if a track of visibility shows its target at the time. */
bool tia_track_shows(const struct tia_track *track, tia_q16 time);

#endif
