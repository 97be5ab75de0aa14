#!/usr/bin/env python3
"""Cycles per pixel by a model of each processor: two tables in Markdown.

    cycles.py [BUILD]           BUILD is the build's folder, default "build"

Instructions and jumps taken of a full frame are counted in an emulator, by address. Each is given the cycles of the
processor's manual, with memory that answers at once: caches, wait states of flash and alignment are not modelled. Where
a manual gives a range the model takes its middle, and says so below.

  Cortex-M0    Technical Reference Manual, ARM DDI 0432C, table 3-1, with the fast multiplier
  Cortex-M0+   Technical Reference Manual, ARM DDI 0484C, table 3-1, with the fast multiplier
  Cortex-M3    Technical Reference Manual, ARM DDI 0337I, table 3-1. A pipeline refill takes 2 cycles of 1 to 3, a product
               of 64 bits 4 of 3 to 5, with a sum 5.5 of 4 to 7, a division 7 of 2 to 12. A load directly after another
               one takes a cycle, and a store too, as section 3.3 explains.
  Cortex-M4    Technical Reference Manual, ARM DDI 0439D, table 3-1: the same, but products take a cycle
  rv32imac     Ibex, the core of lowRISC, whose user manual has such a table (Pipeline Details): two stages, the multiplier
               of a cycle. Makers of chips seldom publish such a table.

A Cortex-M7 issues two instructions at a time, and Arm publishes no such table: there is no model."""
import os
import re
import subprocess
import sys
from dataclasses import dataclass

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import count
import qemu


@dataclass
class Arm:
    """Cycles of what takes more than one, on a processor of Arm's profile M."""
    refill: float               # of the pipeline after a jump
    call: float                 # the same after BL
    back: float                 # and after POP of the program counter
    load: float = 2
    next_load: float = 2        # directly after a load
    store: float = 2
    sum: float = 1              # MLA and MLS
    product: float = 1          # of 64 bits
    product_sum: float = 1
    divide: float = 7

    def cycles(self, name, operands, last):
        """Of an instruction, without a refill; `last` is the name of the one before."""
        many = re.search(r'\{(.*)\}', operands)
        if many:
            return 1 + number_of_registers(many[1])
        for pattern, cycles in ((r'[us]mull$', self.product), (r'[us]mlal$|umaal$', self.product_sum), (r'ml[as]$', self.sum),
                                (r'[us]div$', self.divide), (r'(ldr|str)d$', 3), (r'tb[bh]$', 2), (r'str', self.store),
                                (r'ldr', self.next_load if re.match(r'ldr(?!d)', last) else self.load)):
            if re.match(pattern, name):
                return cycles
        return 1

    def jump(self, name, operands):
        """What is added when another instruction than the next one follows."""
        return self.call if name == 'bl' else self.back if '{' in operands else self.refill


class Ibex:
    @staticmethod
    def cycles(name, _operands, _last):
        for pattern, cycles in ((r'[ls][bhw]u?$', 2), (r'mulh', 2), (r'(div|rem)u?$', 37)):
            if re.match(pattern, name):
                return cycles
        return 1

    @staticmethod
    def jump(name, _operands):
        return 2 if name.startswith('b') else 1


def number_of_registers(text):
    total = 0
    for part in text.split(','):
        first, _, last = part.strip().partition('-')
        total += 1 + (register(last) - register(first) if last else 0)
    return total


def register(name):
    return {'sl': 10, 'fp': 11, 'ip': 12, 'sp': 13, 'lr': 14, 'pc': 15}.get(name) or int(name[1:])


M3 = Arm(refill=2, call=2, back=2, next_load=1, store=1, sum=2, product=4, product_sum=5.5)
M4 = Arm(refill=2, call=2, back=2, next_load=1, store=1)
# A processor, the board that counts for it, and its model.
MODELS = {'Cortex-M3': ('mps2-an385', M3), 'Cortex-M4': ('mps2-an386', M4),
          'Cortex-M0': ('microbit', Arm(refill=2, call=3, back=3)), 'Cortex-M0+': ('microbit', Arm(refill=1, call=2, back=2)),
          'rv32imac': ('rv32', Ibex)}
# Chips, their processors and clocks in MHz; of two processors one.
CHIPS = (('STM32F103', 'Cortex-M3', 72), ('STM32F407', 'Cortex-M4', 168), ('RP2040', 'Cortex-M0+', 125),
         ('nRF51822', 'Cortex-M0', 16), ('ESP32-C3', 'rv32imac', 160))


def disassembly(board, image):
    """Yields address, name without its width, and operands of each instruction."""
    out = subprocess.run([qemu.binutil(board, 'objdump'), '-d', '--no-show-raw-insn', image], check=True,
                         stdout=subprocess.PIPE, text=True).stdout
    for line in out.splitlines():
        match = re.match(r' *([0-9a-f]+):\t(\S+)\s*(.*)', line)
        if match:
            yield int(match[1], 16), match[2].split('.')[0] if board != 'rv32' else match[2], match[3]


def by_address(build, board):
    """How often each instruction of the full frame was executed, and how often another than the next one followed."""
    image, plugin = count.image_of(build, board, 'q16'), count.plugin_of(build)
    addresses = [address for address, _ in count.symbols(board, image)]
    each = count.counted(board, image, plugin)[4]
    more = ',text=%#x:%#x,passages=%d' % (addresses[0], addresses[-1] + 0x1000, each)
    full, _, _, lines, _ = count.counted(board, image, plugin, more)
    executed, taken = count.numbers(lines, 'at'), count.numbers(lines, 'taken')
    # The mark that ends a passage belongs to it, its return does not.
    if abs(sum(executed.values()) - full) > 2 * each:
        raise qemu.Failed('%s: %d of %d instructions have an address' % (image, sum(executed.values()), full))
    return executed, taken


def cycles(model, instructions, executed, taken):
    total, last = 0, ''
    for address, name, operands in instructions:
        total += executed.get(address, 0) * model.cycles(name, operands, last)
        total += taken.get(address, 0) * model.jump(name, operands)
        last = name
    return total


def measure(build):
    """By processor: instructions and cycles of a full frame."""
    made, kept = {}, {}
    for processor, (board, model) in MODELS.items():
        if board not in kept:
            kept[board] = list(disassembly(board, count.image_of(build, board, 'q16'))), *by_address(build, board)
        made[processor] = sum(kept[board][1].values()), cycles(model, *kept[board])
    return made


def frame_ms(frame_cycles, mhz):
    return '%.0f' % (frame_cycles / mhz / 1000)


def main(build):
    missing = [package for board, _ in MODELS.values() for package in qemu.missing(board)]
    if missing:
        print('cycles: %s is missing' % missing[0], file=sys.stderr)
        return
    made = measure(build)
    print('| processor | instructions a pixel | cycles a pixel |\n|---|--:|--:|')
    for processor, (executed, taken) in made.items():
        print('| %s | %s | %s |' % (processor, count.per_pixel(executed), count.per_pixel(taken)))
    print('\n| chip | processor | MHz | ms a frame |\n|---|---|--:|--:|')
    for chip, processor, mhz in CHIPS:
        print('| %s | %s | %d | %s |' % (chip, processor, mhz, frame_ms(made[processor][1], mhz)))


if __name__ == '__main__':
    main(sys.argv[1] if len(sys.argv) > 1 else 'build')
