/* scenes.h - switches between the scenes of the command line, and between views. */
#ifndef TOOLS_TIA_SCENES_H
#define TOOLS_TIA_SCENES_H

#include "device.h"
#include "options.h"

/* Loads the scene `step` places after the current one, cyclically, and closes the current one. False: the new scene
 * cannot be loaded, for the reason in `why`, [PORT_WHY]; the current scene stays open. */
bool scenes_go(struct options *options, int step, char *why);

/* Reads the current scene's files again, see scenes_go. */
bool scenes_read_again(struct options *options, char *why);

/* Gives the name of the current scene for messages, without folders and control characters; "" for the built-in one. */
void scenes_name(const struct options *options, char *name, size_t size);

/* Selects the next view of the scene, see common/views/view_kind.h. */
void scenes_next_view(struct options *options);

#endif
