/* The .nff reader: its choice of the unit, and its refusals. */
#include "reading.h"

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\n"

/* The unit is the finest with which the farthest point stays within 32768 of the eye, and every number in its range:
 * 6.17 from the eye is below 8, 400.01 below 512, and so on. */
TEST(units)
{
    static const struct {
        const char *text;
        int bits;
    } cases[] = {
        {VIEW "s 0 0 0 1\n", 12},
        {VIEW "s 0 0 0 1\nl 0 400 0\n", 6},
        {VIEW "s 0 0 0 1\nl 0 -600 0\n", 5},
        {VIEW "c 0 0 0 1 0 0 -400 2\n", 6},
        {VIEW "p 3\n0 0 0\n1 0 0\n0 600 0\n", 5},
        {VIEW "s 0 0 0 20000\n", 0},
        {VIEW "s 0 0 -20000 1\n", 0},
        {"v\nfrom 1000 0 5\nat 1000 0 0\nup 0 1 0\nangle 40\ns 1000 0 0 1\n", 5},
        {"v\nfrom 0 0 0.0005\nat 0 0 0\nup 0 1 0\nangle 40\ns 0 0 0 0.0001\n", 16},
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct reading r;
        read_string(&r, TIA_FORMAT_NFF, cases[i].text);
        CHECK_MSG(!r.status && r.scene.scale_bits == cases[i].bits, "%zu: %s: %d bits", i, r.reader.error.text,
                  (int)r.scene.scale_bits);
        read_end(&r);
    }
}

TEST(errors)
{
    static const struct {
        const char *text, *want;
    } cases[] = {
        {"", "1:1: the view has no 'v', expected v, from, at, up and angle"},
        {"v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\n", "5:1: the view has no 'angle', expected v, from, at, up and angle"},
        {VIEW "s 0 0 0\n", "6:8: the line ends here, expected a number below 2147483648"},
        {VIEW "s 0 0 0 1 1\n", "6:11: '1' is too much, expected the end of the line"},
        {VIEW "  sphere 0\n", "6:3: 'sphere' is not a statement, expected v, b, l, f, c, s, p, pp or a # comment"},
        {VIEW "l 0 1\n", "6:6: the line ends here, expected a number below 2147483648"},
        {VIEW "f 1 1 1 1 0 x 0 1\n", "6:13: 'x' is not a number, expected a number below 2147483648"},
        {VIEW "p 2\n0 0 0\n1 0 0\n", "6:3: '2' is out of range, expected a whole number from 3 to 4096"},
        {VIEW "p 4097\n", "6:3: '4097' is out of range, expected a whole number from 3 to 4096"},
        {VIEW "p 3\n0 0 0\n1 0 0\n", "9:1: the line ends here, expected a number below 2147483648"},
        {VIEW "p 3\n0 0 0\n1 0 0\nf 1 1 1 1 0 0 0 0\n", "9:1: 'f' is not a number, expected a number below 2147483648"},
        {VIEW "pp 3\n0 0 0 0 0 0\n",
         "7:7: '0' begins a direction of no length, expected three numbers that are not all 0"},
        {VIEW "up 0 0 0\n", "6:4: '0' begins an up vector of no length, expected three numbers that are not all 0"},
        {"\x7f\x45LF\x02\x01", "1:1: '?ELF?\?' is not a statement, expected v, b, l, f, c, s, p, pp or a # comment"},
        {VIEW "l 0 0 0\nl 0 0 0 1 -1 1\n", "7:11: '-1' is out of range, expected a number from 0 to below 2"},
        {VIEW "f 1 1 1 1 1.5 0 0 0\n", "6:11: '1.5' is out of range, expected a number from 0 to 1"},
        {"#\nb 1.5 0 0\n" VIEW, "2:3: '1.5' is out of range, expected a number from 0 to 1"},
        {"\xef\xbb\xbf" VIEW "s 0 0 0\n", "6:8: the line ends here, expected a number below 2147483648"},
        {VIEW "s 0 0 4e9 1\n", "6:7: '4e9' is out of range, expected a number below 2147483648"},
    };
    struct reading r;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        read_string(&r, TIA_FORMAT_NFF, cases[i].text);
        check_read_error(&r, cases[i].want);
    }
}

/* Faults of tia_scene_check are reported at the word responsible, in the file's own words and unit, which is
 * 2^12 of the scene's in the first and third case. */
TEST(places_of_faults)
{
    static const struct {
        const char *text, *want;
    } cases[] = {
        {VIEW "s 0 0 0 1\ns 0 0 0 0\n", "7:9: s: radius: must be at least 2^-22"},
        {VIEW "f 1 1 1 1 0 0 0 0\nf 1 1 1 1.5 0 0 0 0\n", "7:9: f: Kd: each channel must be in 0..1"},
        {VIEW "s 0 0 0 1\nc 0 0 0 1 0 0 0 1\n", "7:11: c: must be at least 2^-22 from the base"},
        {VIEW "p 3\n0 0 0 1 0 0 0 1 0\nf 1 1 1 1 0 0 0.5 9\n", "8:19: f: index: must be in 0.25..4"},
        {VIEW "s 0 0 0 1e6\np 3\n0 0 0 2e9 2e9 0 0 1 0\n",
         "7:1: p: every point must be nearer to the eye than 2147483648"},
        {"#\nv\nfrom 0 0 0\nat 0 0 9\nup 0 1 0\nangle 171\n", "6:7: v: angle: must be in 1..170 degrees"},
        {"v\nfrom 0 0 0\nat 0 0 0\nup 0 1 0\nangle 45\n", "3:4: v: at: must not be the eye"},
    };
    struct reading r;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        read_string(&r, TIA_FORMAT_NFF, cases[i].text);
        check_read_error(&r, cases[i].want);
    }
}

int main(void)
{
    RUN(units);
    RUN(errors);
    RUN(places_of_faults);
    return check_status();
}
