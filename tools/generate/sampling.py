#!/usr/bin/env python3
"""sampling.py - prints src/samples/tables.c: tables of Sobol points, each for four bits of the index."""

# Joe and Kuo, new-joe-kuo-6.21201, the third and fourth dimension: degree, coefficients, first direction numbers.
KUO = ((2, 1, (1, 3)), (3, 1, (1, 3, 1)))


def directions(degree, coefficients, first):
    """Returns the 32 direction numbers of a dimension, the highest bit first."""
    v = [m << (31 - b) for b, m in enumerate(first)]
    for b in range(degree, 32):
        word = v[b - degree] ^ (v[b - degree] >> degree)
        for k in range(1, degree):
            if coefficients >> (degree - 1 - k) & 1:
                word ^= v[b - k]
        v.append(word)
    return v


def reverse(word):
    return int(f"{word:032b}"[::-1], 2)


def sums(v):
    """Returns, for each four bits of the index and each value of them, the exclusive or of their direction numbers,
    bit-reversed."""
    table = []
    for nibble in range(8):
        row = []
        for bits in range(16):
            word = 0
            for b in range(4):
                if bits >> b & 1:
                    word ^= v[4 * nibble + b]
            row.append(reverse(word))
        table.append(row)
    return table


def main():
    print("/* tables.c - the tables of sobol.h, written by tools/generate/sampling.py. */")
    print("// clang-format off")
    print('#include "sobol.h"\n')
    print("const uint32_t tia_sobol_tables[2][8][16] = {")
    for numbers in KUO:
        print("    {")
        for row in sums(directions(*numbers)):
            print("        {" + " ".join(f"0x{w:08x}," for w in row[:8]))
            print("         " + " ".join(f"0x{w:08x}," for w in row[8:]) + "},")
        print("    },")
    print("};")


main()
