/* tick.h - the motion of balls within 1/256 s: contacts, one after the other. */
#ifndef TIA_SCENE_FALL_TICK_H
#define TIA_SCENE_FALL_TICK_H

#include "contact.h"

/* Handles all contacts from the beginning of tick number `tick` to the time `end` in it, then moves all balls there.
 * The state at that time does not depend on `end`, to the bit. */
void tia_fall_tick(struct falling *f, uint32_t tick, uint32_t end);

#endif
