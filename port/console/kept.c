#include "console/kept.h"

#include <string.h>

struct saved kept[KEPT_MOST];

static bool is_same(const struct saved *a, const struct saved *b)
{
    if (a->kind != b->kind || strcmp(a->path, b->path) != 0)
        return false;
    return a->kind != TEXT || strcmp(a->was.text, b->was.text) == 0;
}

struct saved *kept_find(const struct saved *like)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind != NOTHING && is_same(&kept[i], like))
            return &kept[i];
    return NULL;
}

bool kept_any(enum kind kind)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == kind)
            return true;
    return false;
}

bool kept_nothing(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind != NOTHING)
            return false;
    return true;
}

static struct saved *free_place(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == NOTHING)
            return &kept[i];
    return NULL;
}

int kept_note(const struct saved *message)
{
    struct saved *place = kept_find(message);

    if (!place && !message->forget)
        place = free_place();
    if (!place)
        return -1;
    *place = *message;
    if (message->forget)
        place->kind = NOTHING;
    return 0;
}
