/* sample_count.h - the samples that SIMD kernels have drawn, to detect kernels that leave all of them to plain C. */
#ifndef TESTS_SAMPLE_COUNT_H
#define TESTS_SAMPLE_COUNT_H

#include "simd/rays/sure.h"

static unsigned long samples, unsure;

static void count_samples(const struct sure_block *block)
{
    int count = block->width * block->height * block->samples;

    samples += (unsigned)count;
    for (int i = 0; i < count; i++)
        unsure += block->unsure[i];
}

#endif
