/* parse.h - strict parsers for the values of options. */
#ifndef TOOLS_PARSE_H
#define TOOLS_PARSE_H

#include <tia/scene.h>

/* A decimal number from `min` to `max`, without sign or blanks. *end is set to what follows; with end NULL, nothing
 * may follow. */
bool parse_number(const char *text, const char **end, uint32_t min, uint32_t max, uint32_t *value);
bool parse_wide(const char *text, const char **end, uint64_t min, uint64_t max, uint64_t *value);

/* "640x480", each number 1..max; *end as above. */
bool parse_size(const char *text, const char **end, uint32_t max, uint16_t *width, uint16_t *height);

/* "preferred", "WxH" or "WxH@R" with R in hertz. */
bool parse_mode(const char *text);

/* "1.25": seconds below 32768, with at most 40 fractional digits, rounded to the nearest 2^-16. */
bool parse_seconds(const char *text, tia_q16 *seconds);
/* The same times 2^bits, -16..16, which must be below 32768; and the longest whole number that is. */
bool parse_scaled(const char *text, int bits, tia_q16 *value);
unsigned parse_longest(int bits);

/* "25" or "30000/1001", each number 1..1000000. */
bool parse_rate(const char *text, uint32_t rate[2]);

/* A finite number at *text, which goes on behind it; and so many with commas between them, and nothing else. */
bool parse_real(const char **text, double *value);
bool parse_reals(const char *text, double *values, int count);

#endif
