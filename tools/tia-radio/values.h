/* values.h - the values of options. Each function returns FINE, or REFUSED after printing why. */
#ifndef TOOLS_RADIO_VALUES_H
#define TOOLS_RADIO_VALUES_H

#include "options.h"

int wrong(const char *option, const char *value, const char *rule);

/* As many numbers with commas between them, and nothing else. */
bool parse_numbers(const char *text, double *values, int count);

int parse_place(const char *option, const char *text, double (*places)[3], unsigned *count);
int parse_count(const char *option, const char *text, uint32_t low, uint32_t high, uint32_t *value);
int parse_frequency(const char *text, double *frequency);
int parse_size(const char *text, struct options *o);
int parse_map(const char *text, struct options *o);
int parse_rows(const char *text, struct options *o);
int parse_material(const char *text, struct options *o);

#endif
