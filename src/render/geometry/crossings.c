#include "crossings.h"

bool crossings_chord(const num_length *t, unsigned count, num_length after, struct chord *chord)
{
    for (unsigned i = 0; i + 1 < count; i += 2)
        if (t[i + 1] > after) {
            *chord = (struct chord){{t[i], 0}, {t[i + 1], 0}};
            return true;
        }
    return false;
}
