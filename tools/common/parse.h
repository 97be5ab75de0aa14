/* parse.h - strict parsers for the values of options. */
#ifndef TOOLS_PARSE_H
#define TOOLS_PARSE_H

#include <tia/scene.h>

/* Parses a decimal number from `min` to `max`, without sign or blanks. *end receives the position behind it; if `end`
 * is NULL, nothing may follow. */
bool parse_number(const char *text, const char **end, uint32_t min, uint32_t max, uint32_t *value);
/* Parses a number of 64 bits as parse_number does. */
bool parse_wide(const char *text, const char **end, uint64_t min, uint64_t max, uint64_t *value);

/* Parses "640x480", each number 1..max; `end` as for parse_number. */
bool parse_size(const char *text, const char **end, uint32_t max, uint16_t *width, uint16_t *height);

/* Parses "preferred", "WxH" or "WxH@R" with R in hertz. */
bool parse_mode(const char *text);

/* Parses "1.25": seconds below 32768, with at most 40 fractional digits, rounded to the nearest 2^-16. */
bool parse_seconds(const char *text, tia_q16 *seconds);
/* Parses a number as parse_seconds does, and multiplies it by 2^bits, -16..16, with a result below 32768. */
bool parse_scaled(const char *text, int bits, tia_q16 *value);
/* Parses a number as parse_seconds does, with an optional minus sign, below 2^31, Q31.32; `end` as for parse_number. */
bool parse_long(const char *text, const char **end, int64_t *value);
/* Parses "X,Y,Z", three such numbers. */
bool parse_place(const char *text, int64_t place[3]);
/* Returns the largest whole number that parse_scaled accepts. */
unsigned parse_longest(int bits);

/* Parses "25" or "30000/1001", each number 1..1000000. */
bool parse_rate(const char *text, uint32_t rate[2]);

/* Parses a finite number at *text, and moves *text behind it. */
bool parse_real(const char **text, double *value);

/* Parses exactly `count` finite numbers, of absolute values below `limit`, with commas between them. */
bool parse_reals(const char *text, double limit, double *values, int count);

#endif
