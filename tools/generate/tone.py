#!/usr/bin/env python3
"""tone.py - prints src/samples/thresholds.c: the linear values from which sRGB's transfer function (IEC 61966-2-1) gives the
next level.

Level k of n begins at the least linear value whose code is (k - 1/2)/n or more.
"""
from decimal import Decimal, ROUND_CEILING, getcontext

getcontext().prec = 60


def linear(code):
    """Returns the linear value of a code, by the inverse of the transfer function."""
    if code <= Decimal("0.04045"):
        return code / Decimal("12.92")
    return (((code + Decimal("0.055")) / Decimal("1.055")).ln() * Decimal("2.4")).exp()


def main():
    print("/* thresholds.c - the lower ends of sRGB's levels, in units of 2^-32, written by tools/generate/tone.py. */")
    print("// clang-format off")
    print('#include "thresholds.h"')
    for bits in (5, 6, 8):
        n = (1 << bits) - 1
        words = [int((linear((k - Decimal("0.5")) / n) * 2 ** 32).to_integral_value(ROUND_CEILING))
                 for k in range(1, n + 1)]
        print(f"\nconst uint32_t tia_srgb{bits}[{n}] = {{")
        for i in range(0, n, 8):
            print("    " + " ".join(f"{w}u," for w in words[i:i + 8]))
        print("};")
    print("\nconst uint8_t tia_srgb8_from[257] = {")
    from_ = [sum(w <= i << 24 for w in words) for i in range(257)]
    for i in range(0, 257, 16):
        print("    " + " ".join(f"{level}," for level in from_[i:i + 16]))
    print("};")


main()
