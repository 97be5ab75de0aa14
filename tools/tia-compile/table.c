#include "unit.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>

void table_begin(struct unit *unit, const char *type, const char *name, ...)
{
    char bytes[64];
    va_list values;

    va_start(values, name);
    (void)vsnprintf(bytes, sizeof bytes, name, values);
    va_end(values);
    text_print(&unit->text, "static const %s %s_%s[] = {\n", type, unit->symbol, bytes);
    unit->text.indent = 4;
}

void table_end(struct unit *unit)
{
    text_print(&unit->text, "%s};\n\n", unit->text.column > 0 ? "\n" : "");
}

void field_number(struct unit *unit, const char *field, int64_t value)
{
    if (value != 0)
        text_word(&unit->text, ".%s = %" PRId64 ",", field, value);
}

void field_unsigned(struct unit *unit, const char *field, uint32_t value)
{
    if (value != 0)
        text_word(&unit->text, ".%s = %" PRIu32 "u,", field, value);
}

static void field_triple(struct unit *unit, const char *field, int32_t a, int32_t b, int32_t c)
{
    if (a != 0 || b != 0 || c != 0)
        text_word(&unit->text, ".%s = {%" PRId32 ", %" PRId32 ", %" PRId32 "},", field, a, b, c);
}

void field_vec3(struct unit *unit, const char *field, struct tia_vec3 v)
{
    field_triple(unit, field, v.x, v.y, v.z);
}

void field_dir3(struct unit *unit, const char *field, struct tia_dir3 d)
{
    field_triple(unit, field, d.x, d.y, d.z);
}

void field_rgb(struct unit *unit, const char *field, struct tia_rgb c)
{
    field_triple(unit, field, c.r, c.g, c.b);
}

void field_table(struct unit *unit, const char *field, uint32_t count, const char *name, ...)
{
    char bytes[64];
    va_list values;

    va_start(values, name);
    (void)vsnprintf(bytes, sizeof bytes, name, values);
    va_end(values);
    if (count > 0)
        text_word(&unit->text, ".%s = %s_%s,", field, unit->symbol, bytes);
}
