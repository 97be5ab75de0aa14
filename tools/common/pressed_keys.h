/* pressed_keys.h - parses the keys of an option, which are pressed before the first frame. */
#ifndef TOOLS_COMMON_PRESSED_KEYS_H
#define TOOLS_COMMON_PRESSED_KEYS_H

#include <tia/scene.h>

/* Parses "ad<left>" as key codes, at most one per character; *count receives their number. Accepts only keys that set
 * or move a light of `scene`; *bad receives the position of an error. */
bool keys_parse(const char *text, const struct tia_scene *scene, uint16_t *keys, size_t *count, const char **bad);

#endif
