/* The camera in fixed point against the formulas of camera.h in long double, written independently. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "flat/eye.h"
#include "random.h"

#define FRACTION 20
#define BITS 25 /* bits of directions */

static long double real(tia_q16 q)
{
    return q / 65536.0L;
}

static void cross(const long double a[3], const long double b[3], long double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(long double v[3])
{
    long double length = sqrtl(dot(v, v));

    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static void copy(struct tia_vec3 v, long double out[3])
{
    out[0] = real(v.x);
    out[1] = real(v.y);
    out[2] = real(v.z);
}

/* Digits of the eye and the reference point below Q16.16; 0 if the scene has none. */
static struct tia_fine fine;

static void copy_finely(struct tia_vec3 v, struct tia_fine_place digits, long double out[3])
{
    copy(v, out);
    out[0] += ldexpl(digits.x, -32);
    out[1] += ldexpl(digits.y, -32);
    out[2] += ldexpl(digits.z, -32);
}

/* Finds the camera's axes u, v, n. */
static void find_axes(const struct tia_camera *c, long double axes[3][3])
{
    long double eye[3], reference[3], up[3];

    copy_finely(c->eye, fine.eye, eye);
    copy_finely(c->reference, fine.reference, reference);
    copy(c->up, up);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axes[i][k] = i == k;
    if (up[0] == 0 && up[1] == 0 && up[2] == 0)
        return;
    for (int k = 0; k < 3; k++)
        axes[2][k] = eye[k] - reference[k];
    normalise(axes[2]);
    cross(up, axes[2], axes[0]);
    normalise(axes[0]);
    cross(axes[2], axes[0], axes[1]);
}

/* Finds the window's left, right, bottom and top at the distance 1; of orthographic views as given. */
static void find_window(const struct tia_camera *c, unsigned width, unsigned height, long double w[4])
{
    long double by = c->projection == TIA_FRUSTUM ? real(c->window.near) : 1, a;

    w[0] = real(c->window.left) / by;
    w[1] = real(c->window.right) / by;
    w[2] = real(c->window.bottom) / by;
    w[3] = real(c->window.top) / by;
    if (c->projection == TIA_PERSPECTIVE) {
        a = tanl(real(c->fov) * acosl(-1) / 360);
        w[2] = -a;
        w[3] = a;
    }
    if (c->projection == TIA_PERSPECTIVE || (w[0] == 0 && w[1] == 0)) {
        a = (w[3] - w[2]) * width / height / 2;
        if (c->projection != TIA_PERSPECTIVE && a > 32768 / by)
            a = 32768 / by;
        w[0] = -a;
        w[1] = a;
    }
}

/* Finds the vertex (x, y, w, h) of a point, or of a direction. */
static void find_vertex(const struct tia_camera *c, unsigned width, unsigned height, const long double at[3],
                        bool direction, long double out[4])
{
    long double axes[3][3], window[4], eye[3], p[3], to[3];
    bool flat = c->projection == TIA_ORTHOGRAPHIC;

    find_axes(c, axes);
    find_window(c, width, height, window);
    copy_finely(c->eye, fine.eye, eye);
    for (int i = 0; i < 3; i++)
        to[i] = at[i] - (direction ? 0 : eye[i]);
    for (int i = 0; i < 3; i++)
        p[i] = dot(axes[i], to);
    long double w = flat ? !direction : -p[2];
    out[0] = (2 * p[0] - (window[1] + window[0]) * w) / (window[1] - window[0]);
    out[1] = (2 * p[1] - (window[3] + window[2]) * w) / (window[3] - window[2]);
    out[2] = w;
    out[3] = flat ? p[2] : !direction;
}

static tia_q16 within(int32_t range)
{
    return (tia_q16)(random_real() * range * 65536);
}

static struct tia_vec3 any_point(int32_t range)
{
    return (struct tia_vec3){within(range), within(range), within(range)};
}

static bool is_askew(const struct tia_camera *c)
{
    long double eye[3], reference[3], up[3], n[3], side[3];

    copy_finely(c->eye, fine.eye, eye);
    copy_finely(c->reference, fine.reference, reference);
    copy(c->up, up);
    for (int k = 0; k < 3; k++)
        n[k] = eye[k] - reference[k];
    cross(up, n, side);
    return dot(side, side) > dot(up, up) * dot(n, n) / 100000;
}

static struct tia_camera any_camera(enum tia_projection projection)
{
    struct tia_camera c = {.projection = projection, .eye = any_point(100)};

    do {
        c.reference = any_point(100);
        c.up = any_point(3);
    } while (!is_askew(&c));
    if (random_bits() % 4 == 0)
        c.up = (struct tia_vec3){0, 0, 0};
    c.fov = TIA_FOV_MIN + (tia_q16)(random_bits() % (uint64_t)(TIA_FOV_MAX - TIA_FOV_MIN + 1));
    c.window.bottom = within(4);
    c.window.top = c.window.bottom + 6000 + (tia_q16)(random_bits() % 200000);
    c.window.near = 1 + (tia_q16)(random_bits() % 300000);
    c.window.left = random_bits() % 2 ? within(4) : 0;
    c.window.right = c.window.left ? c.window.left + 6000 + (tia_q16)(random_bits() % 200000) : 0;
    return c;
}

static void check_coordinate(int64_t got, long double want, const char *what)
{
    long double exact = ldexpl(want, FRACTION);
    CHECK_MSG(fabsl((long double)got - exact) <= 0.5L + ldexpl(fabsl(exact), -40) + 0.001L, "%s is %jd, not %Lf", what,
              (intmax_t)got, exact);
}

static void check_vertex(const struct tia_raster_vertex *v, const long double want[4], bool flat)
{
    check_coordinate(v->x, want[0], "x");
    check_coordinate(v->y, want[1], "y");
    check_coordinate(v->w, want[2], "w");
    check_coordinate(flat ? v->h : v->h << FRACTION, want[3], "h");
}

static unsigned range_of(const long double v[4], bool flat)
{
    unsigned r = 0;

    for (int i = 0; i < 4; i++)
        while (i != (flat ? 2 : 3) && fabsl(v[i]) >= ldexpl(1, (int)r))
            r++;
    return r;
}

/* Checks that the vertex of a direction is parallel to `want`, and as long as BITS allow. */
static void check_direction(const struct tia_eye *eye, const int64_t direction[3], const long double want[4], bool flat)
{
    struct tia_raster_vertex v;
    long double length = 0, got = 0;

    tia_eye_direction(eye, direction, BITS, &v);
    const int64_t own[4] = {v.x, v.y, v.w, v.h};
    for (int i = 0; i < 4; i++) {
        length += want[i] * want[i];
        got += (long double)own[i] * (long double)own[i];
        CHECK(llabs(own[i]) <= INT64_C(1) << BITS);
    }
    CHECK(got > ldexpl(1, 2 * BITS - 5) && own[flat ? 2 : 3] == 0);
    for (int i = 0; i < 4; i++)
        CHECK_MSG(fabsl((long double)own[i] - want[i] * sqrtl(got / length)) <= 2, "%d is %jd", i, (intmax_t)own[i]);
}

static struct tia_fine_place any_digits(void)
{
    return (struct tia_fine_place){(int16_t)(random_bits() & 32767), (int16_t)(random_bits() & 32767), INT16_MIN};
}

static void check_camera(enum tia_projection projection)
{
    bool finely = random_bits() % 2;
    fine = finely ? (struct tia_fine){any_digits(), any_digits(), NULL, NULL} : (struct tia_fine){.spheres = NULL};
    const struct tia_scene scene = {.camera = any_camera(projection), .fine = finely ? &fine : NULL};
    const struct tia_camera c = scene.camera;
    unsigned width = 1 + (unsigned)random_short(13), height = 1 + (unsigned)random_short(13);
    bool flat = projection == TIA_ORTHOGRAPHIC;
    struct tia_eye eye;

    tia_eye_init(&eye, &scene, width, height);
    for (int i = 0; i < 20; i++) {
        struct tia_raster_vertex v;
        struct tia_vec3 p = any_point(200);
        const int64_t point[3] = {p.x * (INT64_C(1) << 16), p.y * (INT64_C(1) << 16), p.z * (INT64_C(1) << 16)};
        long double at[3], want[4];

        copy(p, at);
        find_vertex(&c, width, height, at, false, want);
        CHECK_EQ(tia_eye_range(&eye, point), range_of(want, flat));
        if (range_of(want, flat) > (flat ? TIA_RANGE_FLAT : TIA_RANGE_MAX))
            continue;
        tia_eye_point(&eye, point, FRACTION, &v);
        check_vertex(&v, want, flat);
        normalise(at);
        find_vertex(&c, width, height, at, true, want);
        const int64_t direction[3] = {(int64_t)ldexpl(at[0], 62), (int64_t)ldexpl(at[1], 62),
                                      (int64_t)ldexpl(at[2], 62)};
        check_direction(&eye, direction, want, flat);
    }
}

TEST(perspective)
{
    for (int i = 0; i < 3000; i++)
        check_camera(TIA_PERSPECTIVE);
}

TEST(frustum)
{
    for (int i = 0; i < 3000; i++)
        check_camera(TIA_FRUSTUM);
}

TEST(orthographic)
{
    for (int i = 0; i < 3000; i++)
        check_camera(TIA_ORTHOGRAPHIC);
}

int main(void)
{
    RUN(perspective);
    RUN(frustum);
    RUN(orthographic);
    return check_status();
}
