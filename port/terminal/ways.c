#include "ways.h"

#include <stddef.h>
#include <string.h>

static const struct {
    const char *name;
    struct way way;
} ways[] = {
    {"automatic", {false, PICTURES_HALF_BLOCKS}},
    {"halfblocks", {true, PICTURES_HALF_BLOCKS}},
    {"symbols", {true, PICTURES_SYMBOLS}},
    {"sixel", {true, PICTURES_SIXEL}},
    {"kitty", {true, PICTURES_KITTY}},
};

bool ways_find(const char *name, struct way *way)
{
    for (size_t i = 0; name && i < sizeof ways / sizeof ways[0]; i++)
        if (strcmp(name, ways[i].name) == 0) {
            *way = ways[i].way;
            return true;
        }
    return false;
}

const char *ways_format(enum pictures pictures, enum colours colours)
{
    bool direct = colours == COLOURS_DIRECT, few = colours_are_few(colours);

    switch (pictures) {
    case PICTURES_KITTY:
        return "kitty's pictures";
    case PICTURES_SIXEL:
        return "sixel";
    case PICTURES_SYMBOLS:
        return direct ? "symbols, 24-bit colours" : few ? "symbols, 16 colours" : "symbols, 256 colours";
    default:
        return direct ? "24-bit colours" : few ? "16 colours" : colours == COLOURS_NONE ? "no colours" : "256 colours";
    }
}
