#include "shown.h"

#include <stdlib.h>

#include "pixels/changes.h"

int shown_resize(struct shown *shown, const struct canvas *canvas)
{
    shown_free(shown);
    shown->pixels = damage_of_canvas(&shown->damage, canvas);
    return shown->pixels ? TIA_OK : TIA_ERR_MEMORY;
}

bool shown_update(struct shown *shown, const struct canvas *canvas, struct strip strip)
{
    const struct tia_tile rows = {0, (uint16_t)strip.first, canvas->width, (uint16_t)strip.rows};
    struct tia_surface surface;
    struct tia_tile area;

    if (!shown->pixels || canvas_tile(canvas, rows, &surface))
        return true;
    bool changed = tia_damage_update(&shown->damage, rows, &surface, &area);
    if (strip.first + strip.rows >= canvas->height) /* strips come from the top down */
        tia_damage_complete(&shown->damage);
    return changed;
}

void shown_forget(struct shown *shown)
{
    tia_damage_forget(&shown->damage);
}

void shown_free(struct shown *shown)
{
    free(shown->pixels);
    shown->pixels = NULL;
}
