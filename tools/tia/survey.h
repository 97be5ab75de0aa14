/* survey.h - rows of all bands of a picture that are drawn before the first band, so that the time left can be told:
 * see common/forecast.h. They are kept, so that nothing is drawn twice, in a sixteenth of the picture's memory. */
#ifndef TOOLS_TIA_SURVEY_H
#define TOOLS_TIA_SURVEY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <tia/render.h>

struct survey {
    unsigned bands, probes; /* number of bands; most probes of a band; 0: there is no survey */
    size_t probe_pixels;    /* most pixels of a probe */
    tia_rgb565 *pixels;     /* of all probes */
    uint16_t *colours;      /* NULL, or their colours */
    uint64_t *ns;           /* [bands * probes]: the time of each */
    uint64_t *weights;      /* [bands]: the work of a pixel, see forecast_weight */
};

/* Allocates a survey of bands of up to `parts` parts. False: there is no memory, and no survey. */
bool survey_begin(struct survey *survey, unsigned bands, unsigned parts, size_t part_pixels, bool colours);
void survey_end(struct survey *survey);

/* Returns the place of a part of a band in the survey's arrays, or -1 if it is not drawn beforehand. */
ptrdiff_t survey_place(const struct survey *survey, unsigned band, unsigned part);

/* Sets the weight of a band from the times of its probes, which have `pixels` pixels. */
void survey_weigh(struct survey *survey, unsigned band, unsigned probes, uint64_t pixels);

/* Returns the time that this thread has used, in nanoseconds. Other programs on the machine do not count. */
uint64_t survey_clock(void);

#endif
