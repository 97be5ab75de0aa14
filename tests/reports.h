/* reports.h - what the checking build reports: how often, and the first time where. */
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
