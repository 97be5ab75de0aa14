/* tick.h - the motion of balls within a tick of 1/256 s, contact by contact. */
#ifndef TIA_SCENE_FALL_TICK_H
#define TIA_SCENE_FALL_TICK_H

#include "contact.h"

/* Handles all contacts of tick number `tick` up to the time `end` in the tick, then advances all balls to that time. A
 * simulation to a later time passes through bit for bit the same state. */
void tia_fall_tick(struct falling *f, uint32_t tick, uint32_t end);

#endif
