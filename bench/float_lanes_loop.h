/* float_lanes_loop.h - the loop itself, included once for each width: no guard. Before it: LANES, TARGET, GUESS(x). */
#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define F JOIN(lanes_f, LANES)
#define I JOIN(lanes_i, LANES)
#define H JOIN(lanes_h, LANES)

typedef float F __attribute__((vector_size(4 * LANES)));
typedef int I __attribute__((vector_size(4 * LANES)));
typedef unsigned short H __attribute__((vector_size(2 * LANES)));

#define SELECT(m, a, b) ((F)(((m) & (I)(a)) | (~(m) & (I)(b))))
#define ALL(x) ((F){0} + (x))
#define PER_ROOT(x) JOIN(lanes_per_root_, LANES)(x)
#define CLAMPED(x) SELECT((x) < 1, SELECT((x) > 0, (x), ALL(0.f)), ALL(1.f))

TARGET static inline F JOIN(lanes_per_root_, LANES)(F x)
{
    F y = GUESS(x);

    return y * (1.5f - .5f * x * y * y);
}

TARGET static void JOIN(lanes_draw_, LANES)(const struct lanes_world *w, int width, int height, tia_rgb565 *pixels)
{
    F iota;

    for (int i = 0; i < LANES; i++)
        iota[i] = (float)i;
    for (int y = 0; y < height; y++) {
        float vy = w->up - (float)y * w->down;
        for (int x = 0; x < width; x += LANES) {
            F vx = (iota + (float)x) * w->step + w->start, per = PER_ROOT(vx * vx + (vy * vy + 1));
            F dx = vx * per, dy = vy * per, dz = -per, near = ALL(1e30f);
            I seen = {0}, ball = {0};
            for (int i = 0; i < 2; i++) {
                F b = dx * w->centre[i][0] + dy * w->centre[i][1] + dz * w->centre[i][2], d = b * b - w->c[i];
                F t = b - d * PER_ROOT(d);
                I hit = (d >= 0) & (b > 0) & (t < near);
                near = SELECT(hit, t, near);
                seen |= hit;
                ball = i ? ball | hit : ball;
            }
            F px = dx * near, py = dy * near, pz = dz * near;
            F per_r = SELECT(ball, ALL(w->per_radius[1]), ALL(w->per_radius[0]));
            F nx = (px - SELECT(ball, ALL(w->centre[1][0]), ALL(w->centre[0][0]))) * per_r;
            F ny = (py - SELECT(ball, ALL(w->centre[1][1]), ALL(w->centre[0][1]))) * per_r;
            F nz = (pz - SELECT(ball, ALL(w->centre[1][2]), ALL(w->centre[0][2]))) * per_r;
            F lx = w->light[0] - px, ly = w->light[1] - py, lz = w->light[2] - pz;
            F square = lx * lx + ly * ly + lz * lz, per_l = PER_ROOT(square), far = square * per_l;
            lx *= per_l, ly *= per_l, lz *= per_l;
            F lambert = nx * lx + ny * ly + nz * lz;
            I lit = seen & (lambert > 0);
            px += nx * 1e-4f, py += ny * 1e-4f, pz += nz * 1e-4f;
            for (int i = 0; i < 2; i++) {
                F ax = w->centre[i][0] - px, ay = w->centre[i][1] - py, az = w->centre[i][2] - pz;
                F a = ax * lx + ay * ly + az * lz, h2 = ax * ax + ay * ay + az * az - a * a;
                lit &= ~((a >= 0) & (a < far) & (h2 <= w->radius2[i]));
            }
            lambert = SELECT(lit, lambert, ALL(0.f));
            F rgb[3];
            for (int c = 0; c < 3; c++) {
                F colour = lambert * SELECT(ball, ALL(w->colour[1][c]), ALL(w->colour[0][c]));
                colour = SELECT(seen, colour, ALL(w->background[c]));
                rgb[c] = CLAMPED(colour);
            }
            I packed = __builtin_convertvector(rgb[0] * 31 + .5f, I) << 11 |
                       __builtin_convertvector(rgb[1] * 63 + .5f, I) << 5 |
                       __builtin_convertvector(rgb[2] * 31 + .5f, I);
            H out = __builtin_convertvector(packed, H);
            memcpy(pixels + x, &out, (size_t)(width - x < LANES ? width - x : LANES) * 2);
        }
        pixels += width;
    }
}

#undef F
#undef I
#undef H
#undef SELECT
#undef ALL
#undef CLAMPED
#undef LANES
#undef TARGET
#undef GUESS
#undef PER_ROOT
#undef JOIN
#undef JOIN2
