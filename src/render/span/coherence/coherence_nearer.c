#include "coherence.h"

#define WORTH 16 /* least number of pixels for which the samples pay */

static num_u apart(num_u a, num_u b)
{
    return a < b ? b - a : a - b;
}

/* In every plane through the eye the visible half of a sphere is convex. So along the row t is convex and largest at an
 * end. A convex function stays above the line through two of its points, extended beyond them: with the samples f0, f1
 * and f2, of which f1 is in the middle or a pixel before it, t of sphere `other` is at least f1 - (f2 - f1) and f1 -
 * 8/7 (f0 - f1), as there are 7 pixels or more on each side.
 *
 * The samples are off by up to 2^-7.2, .0069 of themselves: that lowers these limits by at most .0069 (f1 + 8/7 (f0 +
 * f1)), .023 f1 and .008 times their distance, and the largest t of sphere `n` may be 1.007 times the larger of its two
 * ends. So `n` is nearer if this end is below .968 f1 and 1.16 times the distance less. */
bool coherence_nearer(const struct span_view *spans, uint32_t n, uint32_t other, int y, struct span span)
{
    int count = span.end - span.first;
    const int at[3] = {span.first, span.first + (count - 1) / 2, span.end - 1};
    num_u ends[2], behind[3];

    if (count < WORTH || !(spans->spheres[n].c > 0))
        return false;
    for (int i = 0; i < 2; i++)
        span_distances(spans, n, y, at[2 * i], 1, &ends[i]);
    num_u most = ends[0] < ends[1] ? ends[1] : ends[0];
    if (!span_is_accurate(&spans->spheres[n], most))
        return false;
    for (int i = 0; i < 3; i++) {
        span_distances(spans, other, y, at[i], 1, &behind[i]);
        if (!span_is_accurate(&spans->spheres[other], behind[i]))
            return false;
    }
    num_u left = apart(behind[0], behind[1]), right = apart(behind[2], behind[1]), far = left > right ? left : right;
    return far <= behind[1] / 4 &&
           num_nearer(most, spans->spheres[n].t_exponent, behind[1] - behind[1] / 16 - far - far / 4,
                      spans->spheres[other].t_exponent);
}
