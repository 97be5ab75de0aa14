/* reports.h - the reports of the checking build: their number, and the place of the first. */
#ifndef TESTS_REPORTS_H
#define TESTS_REPORTS_H

#include <stdio.h>

static char first_report[200];
static unsigned reports;

void tia_chk_report(const char *file, int line, const char *range);

void tia_chk_report(const char *file, int line, const char *range)
{
    if (!reports++)
        (void)snprintf(first_report, sizeof first_report, "%s:%d: %s", file, line, range);
}

#endif
