#include "coherence.h"

#define WORTH 16 /* least number of pixels for which the samples pay */

static num_u apart(num_u a, num_u b)
{
    return a < b ? b - a : a - b;
}

/* In every plane through the eye the visible half of a sphere is convex. So along the row t is convex and largest at an
 * end, and S = c/t is concave. If three samples of t differ by up to 1/8, S between them is at most 1.17 times the
 * middle sample's, as a concave function stays below the extended line through two of its points.
 *
 * The error of t, as a part of it, grows with t: with 2^-7.2 at the samples it is at most 2^-7 everywhere. All t of
 * sphere `other` are above .84 of its middle sample, and all t of sphere `n` below 1.02 of the larger of its two ends.
 */
bool coherence_nearer(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span,
                      const num_u *t)
{
    int count = span.end - span.first;
    num_u most = t[0] < t[count - 1] ? t[count - 1] : t[0], behind[3];
    const int at[3] = {span.first, span.first + (count - 1) / 2, span.end - 1};

    if (count < WORTH || !(spans->spheres[n].c > 0) || !span_is_accurate(&spans->spheres[n], most))
        return false;
    for (int i = 0; i < 3; i++)
        span_distances(spans, other, y, at[i], 1, &behind[i]);
    return span_is_accurate(&spans->spheres[other], behind[0]) && span_is_accurate(&spans->spheres[other], behind[1]) &&
           span_is_accurate(&spans->spheres[other], behind[2]) && apart(behind[0], behind[1]) <= behind[0] / 8 &&
           apart(behind[2], behind[1]) <= behind[2] / 8 &&
           num_nearer(most, spans->spheres[n].t_exponent, behind[1] - behind[1] / 4, spans->spheres[other].t_exponent);
}
