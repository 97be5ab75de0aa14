#!/usr/bin/env python3
"""Instructions per pixel on boards without an FPU: a table in Markdown.

    count.py [--profile BOARD | --rays] [BUILD]      BUILD is the build's folder, default "build"

The table of crowds is of BUILD/boards/BOARD/crowd-SPHERES-LIGHTS.elf.

Each program BUILD/boards/BOARD/count-ARITHMETIC.elf draws a frame of 320 x 240 between marks; a
plugin of QEMU, or simavr, counts what is executed from mark to mark. --profile shows where the
q16 program's instructions go, by function; not on the AVR. --rays counts the scenes of the databases,
ray by ray, on a Cortex-M3: 64 x 48 pixels, with the pictures' checksums."""
import bisect
import glob
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import qemu

PIXELS = 320 * 240
SHADOW_PIXELS = 160 * 120
RAY_PIXELS = 64 * 48
BOARDS = qemu.SMALL
TRUST_ROWS = 2, 8, 24
ARITHMETICS = (('q16', 'q16'), ('f32', 'float'), ('f64', 'double'))


def symbols(board, image, kinds='tT'):
    """The functions of an image: (address, name), in the order of their addresses; of kind T: those of other files, too."""
    lines = subprocess.run([qemu.binutil(board, 'nm'), '-n', image], check=True, stdout=subprocess.PIPE,
                           text=True).stdout.splitlines()
    fields = [line.split() for line in lines]
    return [(int(f[0], 16), f[2]) for f in fields if len(f) == 3 and f[1] in kinds and not f[2].startswith('$')]


def count(board, image, plugin, text=None):
    """What the marks enclose: instructions of the full frame, of the relit one (or None), the
    frames' checksums, by address when `text` is a range, and the AVR's cycles."""
    full, relit, crcs, lines, _ = counted(board, image, plugin, ',text=%#x:%#x' % text if text else '')
    cycles = sum(int(line[2]) for line in lines if line[0] == 'passage' and len(line) == 3)
    return full, relit, crcs, numbers(lines, 'at'), cycles


def numbers(lines, word):
    """By address, the numbers in the lines that begin with a word."""
    return {int(line[1], 16): int(line[2]) for line in lines if line[0] == word}


def marked(board, image, plugin, more=''):
    """What the program says, and the lines of the log of what its marks enclose, in words; `more` are options of the plugin."""
    at = {name: address for address, name in symbols(board, image, 'T')}
    begin, end = ('%#x' % at[mark] for mark in ('count_begin', 'count_end'))
    with tempfile.NamedTemporaryFile('r') as log:
        if board == qemu.AVR:
            arguments = [begin, end, log.name]
        else:
            arguments = ['-plugin', '%s,begin=%s,end=%s' % (plugin, begin, end) + more, '-d', 'plugin', '-D', log.name]
        said = qemu.run(board, image, *arguments)
        return said, [line.split() for line in log.read().splitlines()]


def passages_of(lines):
    """The instructions of each passage."""
    return [int(line[1]) for line in lines if line[0] == 'passage']


def counted(board, image, plugin, more=''):
    """Instructions of the full frame, of the relit one (or None), the frames' checksums, the log's lines, and the
    number of passages of a frame; `more` are options of the plugin."""
    text, lines = marked(board, image, plugin, more)
    said, passages = text.split(), passages_of(lines)
    frames = said[0::2]
    if frames not in (['full'], ['full', 'relit']) or len(passages) % len(frames) or len(set(said[1::2])) > 1:
        raise qemu.Failed('%s: %s, %d passages' % (image, ' '.join(said), len(passages)))
    each = len(passages) // len(frames)
    relit = sum(passages[each:]) if len(frames) == 2 else None
    return sum(passages[:each]), relit, said[1::2], lines, each


def shadows(build, board='mps2-an385'):
    """A row for each technique: instructions a pixel, bytes of the view and of a tile's hits."""
    image = '%s/boards/%s/shadows.elf' % (build, board)
    said, log = marked(board, image, plugin_of(build))
    lines, passages = [line.split() for line in said.splitlines() if line], passages_of(log)
    if len(lines) != len(passages):
        raise qemu.Failed('%s: %s, %d passages' % (image, said, len(passages)))
    return [(name, instructions / SHADOW_PIXELS, view, hits) for (name, _, view, hits), instructions in zip(lines, passages)]


def shadow_table(build):
    if qemu.missing('mps2-an385'):
        return
    print('\n| shadows, Cortex-M3 | instructions a pixel | view, bytes | hits of a tile, bytes |\n|---|--:|--:|--:|')
    for row in shadows(build):
        print('| %s | %.0f | %s | %s |' % row)


def trust(build, rows, board='mps2-an385'):
    """Instructions of a frame in strips of so many rows: without checks, with a check before and after the frame, with
    tia_view_draw_checked, and those of a telltale of 64x64 pixels alone; and the frame's checksum."""
    image = '%s/boards/%s/trust-%d.elf' % (build, board, rows)
    text, lines = marked(board, image, plugin_of(build))
    said, passages = text.split(), passages_of(lines)
    if said[0::2] != ['plain', 'around', 'checked', 'telltale'] or len(passages) != 4 or len(set(said[1::2])) != 1:
        raise qemu.Failed('%s: %s, %d passages' % (image, ' '.join(said), len(passages)))
    plain, around, checked, telltale = passages
    return plain, around, checked, telltale - plain, said[1]


def trust_table(build):
    if qemu.missing('mps2-an385'):
        return
    print('\n| checks, Cortex-M3 | instructions of a check | before and after a frame | each strip | telltale |\n|---|--:|--:|--:|--:|')
    for rows in TRUST_ROWS:
        print('| strips of %d rows | %s |' % (rows, ' | '.join(trust_cells(build, rows))))


def trust_cells(build, rows):
    plain, around, checked, telltale, _ = trust(build, rows)
    return ['%d' % ((around - plain) // 2), '%.2f %%' % (100 * (around - plain) / plain),
            '%.2f %%' % (100 * (checked - plain) / plain), '%.2f %%' % (100 * telltale / plain)]


def ray_table(build, board='mps2-an385'):
    if qemu.missing(board):
        print('count: %s is missing' % qemu.missing(board)[0], file=sys.stderr)
        return
    print('| 64x48, Cortex-M3 | instructions a pixel | picture |\n|---|--:|---|')
    for image in sorted(glob.glob('%s/boards/%s/rays-*.elf' % (build, board))):
        full, _, checksums, _, _ = count(board, image, plugin_of(build))
        print('| %s | %.0f | %s |' % (os.path.basename(image)[5:-4], full / RAY_PIXELS, checksums[0]), flush=True)


CROWDS = ((4, 4), (16, 4), (64, 4))
CROWDED = tuple((board, title) for board, title in BOARDS if board in ('mps2-an385', 'microbit', 'rv32'))


def crowd(build, board, spheres, lights):
    """Instructions of a frame with its preparation, and those of the row that takes most; None without a program."""
    image = '%s/boards/%s/crowd-%d-%d.elf' % (build, board, spheres, lights)
    if not os.path.exists(image):
        return None
    said, lines = marked(board, image, plugin_of(build))
    passages = passages_of(lines)
    if not said.startswith('full ') or len(passages) != 241:
        raise qemu.Failed('%s: %s, %d passages' % (image, said, len(passages)))
    return sum(passages), max(passages[1:])


def crowds(build):
    """A row for each crowd: its name, and for each processor instructions a pixel, and a pixel of the worst row."""
    for spheres, lights in CROWDS:
        cells = []
        for board, _ in CROWDED:
            made = None if qemu.missing(board) else crowd(build, board, spheres, lights)
            cells += ['%.0f' % (made[0] / PIXELS), '%.0f' % (made[1] / 320)] if made else ['-', '-']
        yield '%d spheres, %d lights' % (spheres, lights), cells


def crowd_table(build):
    print('\n| scene | ' + ' | '.join('%s | worst row' % title for _, title in CROWDED) + ' |')
    print('|---|' + '--:|--:|' * len(CROWDED))
    for name, cells in crowds(build):
        print('| %s | %s |' % (name, ' | '.join(cells)), flush=True)


def image_of(build, board, arithmetic):
    return '%s/boards/%s/count-%s.elf' % (build, board, arithmetic)


def plugin_of(build):
    return build + '/boards/insn.so'


def per_pixel(instructions):
    return '-' if instructions is None else '%.0f' % (instructions / PIXELS)


def table(build):
    print('| processor | ' + ' | '.join('%s full | relit' % title for _, title in ARITHMETICS) + ' |')
    print('|---|' + '--:|--:|' * len(ARITHMETICS))
    notes = []
    for board, processor in BOARDS:
        if qemu.missing(board):
            print('| %s | (%s is missing) |' % (processor, qemu.missing(board)[0]))
            continue
        cells = []
        for arithmetic, _ in ARITHMETICS:
            image = image_of(build, board, arithmetic)
            if not os.path.exists(image):
                cells += ['-', '-']
                continue
            full, relit, _, _, cycles = count(board, image, plugin_of(build))
            notes += ['%s, %s: %s cycles a pixel' % (processor, arithmetic, per_pixel(cycles))] if cycles else []
            cells += [per_pixel(full), per_pixel(relit)]
        print('| %s | %s |' % (processor, ' | '.join(cells)), flush=True)
    for note in notes:
        print(note)


def profile(build, board):
    image = image_of(build, board, 'q16')
    functions = symbols(board, image)
    starts = [address for address, _ in functions]
    full, relit, _, addresses, _ = count(board, image, plugin_of(build), (starts[0], starts[-1] + 0x1000))
    by_function = {}
    for address, executed in addresses.items():
        name = functions[bisect.bisect_right(starts, address) - 1][1]
        by_function[name] = by_function.get(name, 0) + executed
    print('%s: %s a pixel full, %s relit; both by function:' % (board, per_pixel(full), per_pixel(relit)))
    for name, executed in sorted(by_function.items(), key=lambda item: -item[1]):
        if executed > PIXELS / 20:
            print('%8.1f %s' % (executed / PIXELS, name))


def main(arguments):
    board = None
    if arguments[:1] == ['--profile'] and len(arguments) > 1:
        board, arguments = arguments[1], arguments[2:]
    rays = arguments[:1] == ['--rays']
    arguments = arguments[rays:]
    build = arguments[0] if arguments else 'build'
    if board:
        profile(build, board)
    elif rays:
        ray_table(build)
    else:
        table(build)
        crowd_table(build)
        shadow_table(build)
        trust_table(build)


if __name__ == '__main__':
    main(sys.argv[1:])
