/* radio.h - measures the search for paths of radio waves. */
#ifndef BENCH_RADIO_H
#define BENCH_RADIO_H

void bench_radio(void);

#endif
