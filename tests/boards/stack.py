#!/usr/bin/env python3
"""The stack that drawing a scene of spheres takes at most, in bytes, from the call graph: a table in Markdown.

    stack.py [PROCESSOR]...     the processors of the table; default: all

The library is compiled by gcc -Os, with each size of a chunk, see src/render/span/kernels.h, and without or with
TIA_BALL_WORDS=8, see src/exact/ball.h. The stack of a program's own functions comes on top."""
import importlib.machinery
import importlib.util
import os
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
PROCESSORS = {'Cortex-M3': ('arm-none-eabi-', '-mcpu=cortex-m3 -mthumb'), 'Cortex-M0': ('arm-none-eabi-', '-mcpu=cortex-m0 -mthumb'),
              'rv32imac': ('riscv64-unknown-elf-', '-march=rv32imac -mabi=ilp32')}
KINDS = {(chunk, words): f'-DTIA_CHUNK={chunk}' + (f' -DTIA_BALL_WORDS={words}' if words < 16 else '')
         for words in (16, 8) for chunk in (64, 32, 16)}
# What prepares and draws a picture.
DRAWS = ('tia_core_view_init', 'tia_view_set_lights', 'tia_hits_init', 'tia_view_draw', 'tia_draw_rows_size', 'tia_draw_rows')


def freestanding():
    """tests/slow/freestanding, which knows what calls through pointers reach."""
    sys.path.insert(0, f'{ROOT}/tests')
    loader = importlib.machinery.SourceFileLoader('slow_freestanding', f'{ROOT}/tests/slow/freestanding')
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('slow_freestanding', loader))
    loader.exec_module(module)
    return module


def measure(processor, kinds=KINDS):
    """Bytes by kind."""
    before = os.getcwd()
    os.chdir(ROOT)
    try:
        module, made = freestanding(), {}
        prefix, options = PROCESSORS[processor]
        sources = [source for source in module.SMALL_SOURCES if not source.startswith('src/viewer/')]
        for kind in kinds:
            with tempfile.TemporaryDirectory() as folder:
                module.compile_core(prefix, f'{options} {KINDS[kind]}', sources, folder, '-Os')
                calls, depths = module.stack_of(folder, DRAWS)
            if calls.unbounded:
                raise ValueError(f'{calls.unbounded[0]} has no bound')
            made[kind] = max(bytes_ for bytes_, _ in depths.values())
        return made
    finally:
        os.chdir(before)


def main(processors):
    print('| processor | ' + ' | '.join(f'`{options}`' for options in KINDS.values()) + ' |')
    print('|---|' + '--:|' * len(KINDS))
    for processor in processors or PROCESSORS:
        print(f'| {processor} | ' + ' | '.join(str(number) for number in measure(processor).values()) + ' |', flush=True)


if __name__ == '__main__':
    main(sys.argv[1:])
