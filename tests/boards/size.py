#!/usr/bin/env python3
"""What the program that draws frames on a microcontroller takes: a table in Markdown.

    size.py [BUILD]             BUILD is the build's folder, default "build"

Flash and data are the image's; the stack is measured: the start-up code paints it, the program
says at its end how much was written over."""
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import qemu

BOARDS = (('mps2-an385', 'Cortex-M3'), ('microbit', 'Cortex-M0'), ('rv32', 'rv32im'))


def measure(build, board):
    """Bytes of flash, of data (strips, hits and the prepared scene among them) and of stack."""
    image = '%s/boards/%s/frames.elf' % (build, board)
    said = qemu.run(board, image)
    stack = int(re.search(r'^stack (\d+)$', said, re.M)[1])
    out = subprocess.run([qemu.binutil(board, 'size'), image], check=True, stdout=subprocess.PIPE, text=True).stdout
    text, data, bss = (int(field) for field in out.splitlines()[1].split()[:3])
    return text + data, data + bss, stack


def main(build):
    print('| processor | flash | data | stack | RAM in all |\n|---|--:|--:|--:|--:|')
    for board, processor in BOARDS:
        missing = qemu.missing(board)
        if missing:
            print('| %s | (%s is missing) |' % (processor, missing[0]))
            continue
        flash, data, stack = measure(build, board)
        print('| %s | %d | %d | %d | %d |' % (processor, flash, data, stack, data + stack))


if __name__ == '__main__':
    main(sys.argv[1] if len(sys.argv) > 1 else 'build')
