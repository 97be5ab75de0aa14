#!/usr/bin/env python3
"""What the program that draws frames on a microcontroller takes: a table in Markdown.

    size.py [BUILD]             BUILD is the build's folder, default "build"

Flash and data are the image's; the stack is measured: the start-up code paints it, the program
says at its end how much was written over. The linker left it the rest of the RAM, and refuses to
leave it less than the last column."""
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import qemu

BOARDS = qemu.SMALL
RAM = 16 * 1024


def image_of(build, board):
    return '%s/boards/%s/frames.elf' % (build, board)


def measure(build, board):
    """Bytes of flash, of data (strips, hits and the prepared scene among them) and of stack."""
    image = image_of(build, board)
    said = qemu.run(board, image)
    stack = int(re.search(r'^stack (\d+)$', said, re.M)[1])
    return (*sections(board, image), stack)


def sections(board, image):
    """Bytes of flash and of data."""
    out = subprocess.run([qemu.binutil(board, 'size'), image], check=True, stdout=subprocess.PIPE, text=True).stdout
    text, data, bss = (int(field) for field in out.splitlines()[1].split()[:3])
    return text + data, data + bss


def least_stack(board, image):
    """What the linker must leave."""
    out = subprocess.run([qemu.binutil(board, 'nm'), image], check=True, stdout=subprocess.PIPE, text=True).stdout
    return int(re.search(r'^(\w+) A board_stack_min$', out, re.M)[1], 16)


def main(build):
    print('| processor | flash | data | stack | RAM in all | left for the stack | at least |')
    print('|---|--:|--:|--:|--:|--:|--:|')
    for board, processor in BOARDS:
        missing = qemu.missing(board)
        if missing:
            print('| %s | (%s is missing) |' % (processor, missing[0]))
            continue
        flash, data, stack = measure(build, board)
        print('| %s | %d | %d | %d | %d | %d | %d |' % (processor, flash, data, stack, data + stack, RAM - data,
                                                        least_stack(board, image_of(build, board))))


if __name__ == '__main__':
    main(sys.argv[1] if len(sys.argv) > 1 else 'build')
