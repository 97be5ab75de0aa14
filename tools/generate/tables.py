#!/usr/bin/env python3
"""tables.py - prints src/math/integer.c: the seed tables of the number kernels; with "power", src/math/power_tables.c.

Each entry packs a straight line over one interval of the argument: its value at the left end and its slope. One
multiplication gives a seed that is accurate to 17 bits; one Newton step makes that 32. An entry is (c0 - 1) 2^20 << 12 | c1,
where c1 is the line's fall over the whole interval in units of 2^-18:  seed(f) = c0 - c1 f 2^-18, for the position f in [0,
1) within the interval.

    tia_rsqrt_lines[i]       1/sqrt(a), a in [(128+i)/512, (129+i)/512)
    tia_reciprocal_lines[i]  1/d,       d in [(128+i)/256, (129+i)/256)

Of the lines with these numbers of bits, the one whose maximal relative error is smallest is chosen. Its slope is that of the
chord, rounded down or up. Its height makes the errors at the ends and at the interior extremum equal in size and opposite in
sign.
"""
import math
import sys

IN_FLASH = ("tia_turns", "tia_sines")   # see src/math/integer.h


def line(f, lo, hi, extremum):
    """Returns the best line for f on [lo, hi] as (largest relative error, c0, c1), in units of 2^-20 for c0 and 2^-18 for c1."""
    unit0, unit1 = 2.0 ** -20, 2.0 ** -18
    chord = (f(lo) - f(hi)) / unit1
    best = None
    for c1 in (math.floor(chord), math.ceil(chord)):
        slope = c1 * unit1 / (hi - lo)
        at = [lo, hi, extremum(lo, hi)]
        # c0 such that the relative errors at the ends and inside are opposite
        ends = [(f(x) + slope * (x - lo)) for x in at]
        middle = (min(ends) + max(ends)) / 2
        for c0 in (math.floor(middle / unit0), math.ceil(middle / unit0)):
            worst = max(abs((c0 * unit0 - slope * (x - lo)) / f(x) - 1) for x in at)
            if best is None or worst < best[0]:
                best = (worst, c0, c1)
    return best


def table(count, first, scale, f, extremum):
    words, worst = [], 0.0
    for i in range(first, first + count):
        error, c0, c1 = line(f, i / scale, (i + 1) / scale, extremum)
        high = c0 - (1 << 20)
        assert 0 <= high < 1 << 20 and 0 <= c1 < 1 << 12
        words.append(high << 12 | c1)
        worst = max(worst, error)
    return words, worst


def tangent_rsqrt(lo, hi):
    """Returns the point where the curve 1/sqrt is parallel to its chord: a^(-3/2) / 2 = slope."""
    slope = (lo ** -0.5 - hi ** -0.5) / (hi - lo)
    return (2 * slope) ** (-2 / 3)


def show(name, words):
    print(f"const TIA_FLASH uint32_t {name}[{len(words)}] = {{")
    for i in range(0, len(words), 8):
        print("    " + " ".join(f"0x{w:08x}," for w in words[i:i + 8]))
    print("};")


def leading_zeros():
    """Returns tia_clz_places; 2^n - 1 has 32 - n leading zeros."""
    places = [None] * 32
    for n in range(1, 33):
        places[(((1 << n) - 1) * 0x07c4acdd & 0xffffffff) >> 27] = 32 - n
    assert None not in places
    return places


def arctangent(n, bits):
    """Returns atan(1/n) 2^bits by its series, with every term rounded down."""
    term = (1 << bits) // n
    total, k = 0, 0
    while term:
        total += (-1) ** k * (term // (2 * k + 1))
        term //= n * n
        k += 1
    return total


def turns(count, bits=200):
    """Returns atan(2^-i)/(2 pi), Q1.62, with pi by Machin's formula."""
    pi = 4 * (4 * arctangent(5, bits) - arctangent(239, bits))
    angles = [pi // 4] + [arctangent(1 << i, bits) for i in range(1, count)]
    return [((a << 63) // (2 * pi) + 1) >> 1 for a in angles]


def sines(count, bits=200):
    """Returns sin(pi/2 i/count), i = 0..count, Q1.62, by its series."""
    pi = 4 * (4 * arctangent(5, bits) - arctangent(239, bits))
    table = []
    for i in range(count + 1):
        x = pi * i // (2 * count)
        total, term, k = 0, x, 1
        while term:
            total += term
            term = -term * x * x // (1 << 2 * bits) // ((k + 1) * (k + 2))
            k += 2
            if term == -1:
                break
        table.append(((total >> (bits - 63)) + 1) >> 1)
    return table


def show_longs(name, words):
    print(f"\nconst {'TIA_FLASH ' if name in IN_FLASH else ''}int64_t {name}[{len(words)}] = {{")
    for i in range(0, len(words), 4):
        print("    " + " ".join(f"{'-' if w < 0 else ''}0x{abs(w):016x}," for w in words[i:i + 4]))
    print("};")


def ln2(bits):
    """Returns ln 2 2^bits, as 2 atanh(1/3)."""
    term, total, k = (1 << bits) // 3, 0, 0
    while term:
        total += term // (2 * k + 1)
        term //= 9
        k += 1
    return 2 * total


def logarithm(a, b, bits):
    """Returns log2(a/b) 2^bits for 1 <= a/b <= 2, by 2 atanh((a - b)/(a + b))."""
    term, total, k = ((a - b) << bits) // (a + b), 0, 0
    while term:
        total += term // (2 * k + 1)
        term = term * (a - b) ** 2 // (a + b) ** 2
        k += 1
    return (2 * total << bits) // ln2(bits)


def rounded(x, bits, to):
    """Returns x 2^-bits as a number with `to` fractional bits, rounded."""
    return ((x >> (bits - to - 1)) + 1) >> 1


def exponential(n, d, bits):
    """Returns 2^(-n/d) 2^bits, by its series."""
    x = ln2(bits) * n // d
    term, total, k = 1 << bits, 0, 0
    while term and term != -1:
        total += term
        k += 1
        term = -term * x // (k << bits)
    return total


def power(bits=200):
    """Prints power_tables.c: for 64 parts of [1/2, 1) a reciprocal near that of the part's middle, and its logarithm;
    2^(-i/64); and the coefficients of the series of log2(1 + x) and 2^-x."""
    near = [(2 * 512 * 256 + 129 + 2 * i) // (2 * (129 + 2 * i)) for i in range(64)]
    series, factor = [], 1 << bits
    for n in range(1, 7):
        factor = -factor * ln2(bits) // (n << bits)
        series.append(factor)
    print("/* power_tables.c - the tables of power.c, written by tools/generate/tables.py. */")
    print("// clang-format off")
    print('#include "power.h"\n')
    print("const uint16_t tia_log_inverses[64] = {")
    for i in range(0, 64, 16):
        print("    " + " ".join(f"{n}," for n in near[i:i + 16]))
    print("};")
    show_longs("tia_logs", [rounded(logarithm(n, 512, bits), bits, 56) for n in near])
    show_longs("tia_exps", [rounded(exponential(i, 64, bits), bits, 62) for i in range(64)])
    show_longs("tia_log_series", [rounded((-1) ** (n + 1) * (1 << 2 * bits) // (n * ln2(bits)), bits, 62)
                                  for n in range(1, 9)])
    show_longs("tia_exp_series", [rounded(f, bits, 62) for f in series])


def main():
    rsqrt, rsqrt_worst = table(384, 128, 512, lambda a: a ** -0.5, tangent_rsqrt)
    recip, recip_worst = table(128, 128, 256, lambda d: 1 / d, lambda lo, hi: math.sqrt(lo * hi))
    print("/* integer.c - seed tables of the number kernels, written by tools/generate/tables.py, which")
    print(" * explains their format. Largest relative error of the lines: "
          f"{rsqrt_worst:.2e} and {recip_worst:.2e}. */")
    print("// clang-format off")
    print('#include "integer.h"\n')
    show("tia_rsqrt_lines", rsqrt)
    print()
    show("tia_reciprocal_lines", recip)
    print("\nconst TIA_FLASH uint8_t tia_clz_places[32] = {")
    for row in (leading_zeros()[:16], leading_zeros()[16:]):
        print("    " + " ".join(f"{z}," for z in row))
    print("};")
    show_longs("tia_turns", turns(60))
    show_longs("tia_sines", sines(64))


if sys.argv[1:] == ["power"]:
    power()
else:
    main()
