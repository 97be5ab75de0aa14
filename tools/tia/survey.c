#include "survey.h"

#include <stdlib.h>
#include <time.h>

#include "common/forecast.h"

bool survey_begin(struct survey *survey, unsigned bands, unsigned parts, size_t part_pixels, bool colours)
{
    size_t probes = forecast_probes(parts), count = bands * probes;

    *survey = (struct survey){.bands = bands, .probes = (unsigned)probes, .probe_pixels = part_pixels};
    survey->pixels = malloc(count * part_pixels * sizeof *survey->pixels + 1);
    survey->colours = colours ? malloc(3 * count * part_pixels * sizeof *survey->colours + 1) : NULL;
    survey->ns = calloc(count + 1, sizeof *survey->ns);
    survey->weights = calloc(bands, sizeof *survey->weights);
    if (probes && survey->pixels && survey->ns && survey->weights && (survey->colours || !colours))
        return true;
    survey_end(survey);
    return false;
}

void survey_end(struct survey *survey)
{
    free(survey->pixels);
    free(survey->colours);
    free(survey->ns);
    free(survey->weights);
    *survey = (struct survey){.bands = 0};
}

ptrdiff_t survey_place(const struct survey *survey, unsigned band, unsigned part)
{
    unsigned probe = part / FORECAST_STEP;

    if (!survey->probes || forecast_probe(probe) != part)
        return -1;
    return (ptrdiff_t)((size_t)band * survey->probes + probe);
}

void survey_weigh(struct survey *survey, unsigned band, unsigned probes, uint64_t pixels)
{
    uint64_t ns = 0;

    for (unsigned i = 0; i < probes; i++)
        ns += survey->ns[(size_t)band * survey->probes + i];
    survey->weights[band] = probes || !band ? forecast_weight(ns, pixels) : survey->weights[band - 1];
}

uint64_t survey_clock(void)
{
    struct timespec now = {0, 0};

    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (uint64_t)now.tv_sec * 1000000000 + (uint64_t)now.tv_nsec;
}
