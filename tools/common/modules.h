/* modules.h - projectors behind a light-field display's screen: "32,distance=0.5,spacing=0.02", with lengths in the
 * scene's unit. They stand in a row parallel to the screen, centred behind it. */
#ifndef TOOLS_MODULES_H
#define TOOLS_MODULES_H

#include <tia/scene.h>

enum { MODULES_MAX = 65536 };

struct modules {
    uint32_t count;
    tia_q16 distance, spacing; /* distance from the screen; spacing from one to the next */
};

/* Parses the text. Returns NULL, or the reason why it is wrong. The scene must have an observer line. By default the
 * modules' distance from the screen is half that of the line, and their spacing is such that the whole screen is lit
 * for every position on the line. */
const char *modules_parse(struct modules *modules, const char *text, const struct tia_scene *scene);

/* Returns the position of module `module`, from the screen's middle: (module - (count - 1)/2) spacing, halves rounded
 * up. */
tia_q16 modules_place(uint32_t module, uint32_t count, tia_q16 spacing);

#endif
