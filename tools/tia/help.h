/* help.h - the pages of tia --help, but for the options' own texts. */
#ifndef TOOLS_TIA_HELP_H
#define TOOLS_TIA_HELP_H

#include "common/command_table.h"

#define HELP_KEYS                                                                                                      \
    "Keys: a scene's own keys place lights (a d s w: above left, above right, near,\n"                                 \
    "far); arrows and page up/down move the first light. In the built-in scene every\n"                                \
    "other key quits. In others:\n"                                                                                    \
    "tab: next light   shift and arrows, page up/down: move the eye\n"                                                 \
    "h j k l, drag: orbit   + - : zoom   home: back   n p: next, previous scene\n"                                     \
    "v: next view   t: shadow technique   space: pause\n"                                                              \
    "c: save a picture, tia-0001.png   e: print the eye as a camera line\n"                                            \
    "?: help   q, escape: quit   Ctrl-Z: stop, on terminals\n"

extern const char help_overview[]; /* with the list of the themes below it: 23 lines of 80 columns */
extern const struct help_theme help_themes[];

#endif
