/* link_report.h - a link's paths as text. */
#ifndef TOOLS_RADIO_LINK_REPORT_H
#define TOOLS_RADIO_LINK_REPORT_H

#include "options.h"
#include "path_wave.h"

struct link_report {
    const struct options *options;
    const struct world *world;
    struct tia_vec3 tx, rx;
    const struct tia_radio_path *paths;
    const struct field *fields;
    unsigned count;
};

/* Prints a table. The caller handles failures of standard output. */
void report_table(const struct link_report *report);

/* Prints the link as an element of a JSON array, with a comma in front unless it is the first one. */
void report_json(const struct link_report *report, bool first);
void report_json_begin(const struct options *options, const struct world *world);
void report_json_end(void);

#endif
