/* track.h - what keyframes say of a time. */
#ifndef TIA_SCENE_TRACK_H
#define TIA_SCENE_TRACK_H

#include <tia/motion.h>

/* The value of the time. */
struct tia_vec3 tia_track_value(const struct tia_track *track, tia_q16 time);

/* Of a track that shows something: whether it is there. */
bool tia_track_shows(const struct tia_track *track, tia_q16 time);

#endif
