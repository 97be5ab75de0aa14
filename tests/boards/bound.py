#!/usr/bin/env python3
"""The bound of docs/boards.md for the instructions of a row on a Cortex-M3, against rows of random scenes.

    bound.py [BUILD] [SCENES-SEED]          compares the rows of BUILD/boards/mps2-an385/bound-SCENES-SEED.elf, by default 1000-2
    bound.py --fit [BUILD] [SCENES-SEED]    prints coefficients that fit these rows, by default 600-3

S spheres, L lights, W pixels, E decisions with balls. A row has a part for each sphere, and a pixel one for each light,
sphere, and both: each light may be blocked by each sphere. So has a decision, of a pixel's colour, of the nearer of two
spheres, or of an outline, of which there are at most W (S + 1) and for each sphere two outlines. QEMU counts the
instructions and the decisions."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import count
import qemu

BOARD = 'mps2-an385'
# Instructions of each term: a quarter more than in the scenes of bound-600-3.
BOUND = {'1': 40000, 'S': 2000, 'W': 800, 'W L': 600, 'W L S': 300, 'E': 81000, 'E L': 49000, 'E L S': 4900}
DECISIONS = 'tia_exact_shade', 'tia_exact_nearer', 'tia_exact_meets'
LEAST = .3  # largest part of the bound that some row must have, else the bound is too large


def product(factors):
    result = 1
    for factor in factors:
        result *= factor
    return result


class Row:
    """A row of a scene: what its bound depends on, and its instructions: in all, the most between two polls of `stop`, and
    those after a poll that returned true."""

    def __init__(self, scene):
        self.S, self.L, self.W, self.traits = scene
        self.E = self.instructions = self.between = self.after = 0

    def terms(self):
        values = {'1': 1, 'S': self.S, 'L': self.L, 'W': self.W, 'E': self.E}
        return [product(values[factor] for factor in term.split()) for term in BOUND]

    def bound(self):
        return sum(coefficient * value for coefficient, value in zip(BOUND.values(), self.terms()))


def rows(build, name):
    """The rows that the program of some scenes and a first number draws."""
    image = f'{build}/boards/{BOARD}/bound-{name}.elf'
    at = {symbol: address for address, symbol in count.symbols(BOARD, image)}
    qemu.LIMIT = 3600
    text, lines = count.marked(BOARD, image, count.plugin_of(build), ''.join(',calls=%#x' % at[name] for name in DECISIONS))
    said, passages = text.split('\n'), count.passages_of(lines)
    decisions = [sum(map(int, line[1:])) for line in lines if line[0] == 'calls']
    found, at = [], 0
    for word, *numbers in (line.split() for line in said if line.count(' ') == 5):
        scene, polls = [int(number, 16) for number in numbers[:4]], int(numbers[4], 16)
        if word == 'row':
            found.append(Row(scene))
            found[-1].instructions, found[-1].E = passages[at], decisions[at]
        elif word == 'polls':
            found[-1].between = max(passages[at:at + polls + 1])
        else:
            found[-1].after = passages[at]
        at += polls + 1 if word == 'polls' else 1
    if 'done' not in said or at != len(passages) or at != len(decisions):
        raise qemu.Failed(f'{image}: {said[-2:]}, {len(found)} rows, {at} of {len(passages)} passages')
    return found


def report(found):
    """Rows that exceed the bound, after a line that says how near the others come."""
    shares = sorted(row.instructions / row.bound() for row in found)
    worst = max(found, key=lambda row: row.instructions)
    print(f'{len(found)} rows: at most {100 * shares[-1]:.0f} % of the bound, half of them at most '
          f'{100 * shares[len(shares) // 2]:.0f} %; the longest takes {worst.instructions} instructions ({worst.S} spheres, '
          f'{worst.L} lights, {worst.W} pixels)')
    sure = sum(row.E == 0 for row in found)
    print(f'{100 * sure / len(found):.0f} % of the rows are decided without balls, and have at most '
          f'{max(row.instructions // row.W for row in found if row.E == 0)} instructions a pixel')
    print(f'at most {max(row.between for row in found)} instructions from one poll of `stop` to the next, and '
          f'{max(row.after for row in found)} after the one that stops')
    return [row for row in found if row.instructions > row.bound()]


def main(arguments):
    build = arguments[0] if arguments else 'build'
    found = rows(build, arguments[1] if len(arguments) > 1 else '1000-2')
    over = report(found)
    for row in over[:10]:
        print(f'over its bound: {vars(row)}, {row.bound()}')
    if not over and max(row.instructions / row.bound() for row in found) < LEAST:
        print('the bound is far from every row')
        return 1
    return int(bool(over))


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
