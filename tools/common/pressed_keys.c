#include "pressed_keys.h"

#include <string.h>

#include <tia/port.h>

static const struct {
    const char *name;
    uint16_t key;
} named[] = {{"<left>", TIA_KEY_LEFT}, {"<right>", TIA_KEY_RIGHT},  {"<up>", TIA_KEY_UP},
             {"<down>", TIA_KEY_DOWN}, {"<pgup>", TIA_KEY_PAGE_UP}, {"<pgdn>", TIA_KEY_PAGE_DOWN}};

/* Returns the length of the key's name at the start of `text`; 0 if there is none. */
static size_t key_at(const char *text, const struct tia_scene *scene, uint16_t *key)
{
    for (size_t i = 0; i < sizeof named / sizeof named[0]; i++) {
        size_t length = strlen(named[i].name);
        if (strncmp(text, named[i].name, length) == 0) {
            *key = named[i].key;
            return length;
        }
    }
    for (uint32_t i = 0; i < scene->binding_count; i++) {
        if (scene->bindings[i].key == (unsigned char)*text) {
            *key = (unsigned char)*text;
            return 1;
        }
    }
    return 0;
}

bool keys_parse(const char *text, const struct tia_scene *scene, uint16_t *keys, size_t *count, const char **bad)
{
    *count = 0;
    while (*text != '\0') {
        size_t length = key_at(text, scene, &keys[*count]);
        if (length == 0) {
            *bad = text;
            return false;
        }
        text += length;
        ++*count;
    }
    return true;
}
