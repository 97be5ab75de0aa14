#include <stddef.h>
#include <tia/shadow.h>

const char *tia_shadows_name(unsigned technique)
{
    static const char *const names[] = {"traced", "rays", "zpass", "zfail"};

    return technique < sizeof names / sizeof *names ? names[technique] : NULL;
}
