/* lightfield.h - measures pictures for light-field displays. */
#ifndef BENCH_LIGHTFIELD_H
#define BENCH_LIGHTFIELD_H

void bench_light_fields(void);

#endif
