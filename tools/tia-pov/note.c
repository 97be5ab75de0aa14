#include "pov.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void pov_note(struct pov *pov, const char *format, ...)
{
    char note[sizeof pov->note];
    va_list values;

    va_start(values, format);
    (void)vsnprintf(note, sizeof note, format, values);
    va_end(values);
    if (strcmp(note, pov->note) == 0)
        return;
    memcpy(pov->note, note, sizeof note);
    text_print(&pov->text, "%s// %s\n", pov->text.column > 0 ? "\n" : "", note);
    (void)fprintf(stderr, "tia-pov: note: %s\n", note);
}
