#include "utf8.h"

#include <langinfo.h>
#include <locale.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

bool locale_is_utf8(void)
{
    static const char *const names[] = {"LC_ALL", "LC_CTYPE", "LANG"};
    locale_t locale = newlocale(LC_CTYPE_MASK, "", (locale_t)0);
    const char *name = NULL;

    if (locale != (locale_t)0) {
        bool found = strcmp(nl_langinfo_l(CODESET, locale), "UTF-8") == 0;
        freelocale(locale);
        return found;
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0] && (!name || *name == '\0'); i++)
        name = getenv(names[i]);
    return name && (strcasestr(name, ".utf-8") || strcasestr(name, ".utf8"));
}
