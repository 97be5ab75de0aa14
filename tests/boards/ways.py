#!/usr/bin/env python3
"""What the ways that docs/ecosystems.md names make of the example of docs/boards.md: a table in Markdown.

    ways.py [BUILD]             BUILD is the build's folder, default "build"

For each way the commands that compile the library are asked of the build system itself: of make, of CMake for its own
builds and with substitutes for the functions of ESP-IDF's and Zephyr's. For Arduino, PlatformIO and the Pico SDK, the options
are those that their packages for these processors give a compiler. Those sources are compiled by them that the example
may need, and the example with them; its start-up code is that of `make boards`. In QEMU instructions a pixel are counted for a
frame of 320x240, the preparation of the view included, and the stack is measured."""
import concurrent.futures
import importlib.machinery
import importlib.util
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import count
import qemu
import size

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
EXAMPLE = 'tests/boards/example_main.c'
PROCESSORS = {'Cortex-M0': ('microbit', '-mthumb -mcpu=cortex-m0'), 'Cortex-M3': ('mps2-an385', '-mthumb -mcpu=cortex-m3'),
              'rv32imac': ('rv32', '-march=rv32imac -mabi=ilp32')}
SECTIONS = '-ffunction-sections -fdata-sections'
# Zephyr's CMakeLists.txt, with its default CONFIG_SIZE_OPTIMIZATIONS.
ZEPHYR = f'-Os -fno-strict-aliasing -fno-common -fno-pic -fno-pie -fno-asynchronous-unwind-tables -fno-reorder-functions ' \
         f'-fno-defer-pop {SECTIONS} -ffreestanding'
# ESP-IDF's, with its default CONFIG_COMPILER_OPTIMIZATION_DEBUG.
ESP_IDF = f'{SECTIONS} -Og -fno-jump-tables -fno-tree-switch-conversion -fstrict-volatile-bitfields'
# platform.txt of the packages for SAMD, STM32 and RP2040.
ARDUINO = f'-c -g -Os -w -std=gnu11 {SECTIONS} -nostdlib --param max-inline-insns-single=500'


def run(*command, **more):
    return subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, **more).stdout


def stubs(name):
    """The substitutes of tests/slow/ecosystems."""
    loader = importlib.machinery.SourceFileLoader('ecosystems', f'{ROOT}/tests/slow/ecosystems')
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('ecosystems', loader))
    loader.exec_module(module)
    return getattr(module, name)


# ---- ways: each returns the options by source, for a processor's compiler and options ----

def by_make(flags):
    def commands(_, compiler, options, folder):
        kept = {k: v for k, v in os.environ.items() if not k.startswith('MAKE') and k not in ('MFLAGS', 'BUILD', 'CC', 'F64')}
        said = run('make', '-n', '-C', ROOT, f'BUILD={folder}', f"CROSS={compiler.removesuffix('gcc')}",
                   f'CFLAGS={flags} {options}', f'{folder}/libtia.a', env=kept)
        return {words[-1]: words[1:-4] for words in map(shlex.split, said.splitlines()) if '-c' in words}
    return commands


def by_cmake(project, build_type='', platform=''):
    def commands(_, compiler, options, folder):
        with open(f'{folder}/CMakeLists.txt', 'w', encoding='utf-8') as file:
            file.write(f'cmake_minimum_required(VERSION 3.13)\nproject(program C)\n{project.replace("@ROOT@", ROOT)}')
        run('cmake', '-S', folder, '-B', f'{folder}/made', '-DCMAKE_SYSTEM_NAME=Generic', f'-DCMAKE_C_COMPILER={compiler}',
            '-DCMAKE_C_COMPILER_FORCED=ON', f'-DCMAKE_C_FLAGS={options} {platform}', f'-DCMAKE_BUILD_TYPE={build_type}',
            '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON')
        with open(f'{folder}/made/compile_commands.json', encoding='utf-8') as file:
            made = [(entry['file'], shlex.split(entry['command'])) for entry in json.load(file)]
        return {os.path.relpath(path, ROOT): words[1:words.index('-o')] for path, words in made}
    return commands


def by_platformio(sources, _, options, __):
    manifest = json.loads(open(f'{ROOT}/library.json', encoding='utf-8').read())['build']
    words = shlex.split(f"-Os -ffreestanding {SECTIONS} {options} {manifest.get('flags', '')}") + [f"-I{manifest['includeDir']}", f"-I{manifest['srcDir']}"]
    return {source: words for source in sources}


def by_arduino(sources, _, options, folder):
    run(sys.executable, f'{ROOT}/tools/generate/amalgamation.py', f'{folder}/tia', *sources, cwd=ROOT)
    return {f'{folder}/tia/tia.c': shlex.split(f'{ARDUINO} -ffreestanding {options}')}


DIRECTORY = 'add_subdirectory(@ROOT@ tia)\n'
WAYS = {
    '`make CROSS=`, `CFLAGS=-Os`': by_make(f'-Os {SECTIONS}'),
    '`make CROSS=`, `CFLAGS=-O2`': by_make(f'-O2 {SECTIONS}'),
    'CMake, no build type': by_cmake(DIRECTORY),
    'CMake, `MinSizeRel`': by_cmake(DIRECTORY, 'MinSizeRel'),
    'CMake, `Release`': by_cmake(DIRECTORY, 'Release'),
    'Pico SDK': by_cmake(DIRECTORY, 'Release', f'-mcpu=cortex-m0plus {SECTIONS}'),
    'Arduino': by_arduino,
    'PlatformIO': by_platformio,
    'Zephyr': by_cmake(stubs('ZEPHYR') + 'add_subdirectory(@ROOT@/zephyr tia)\n', '', ZEPHYR),
    'ESP-IDF': by_cmake(stubs('ESP') + f'add_compile_options({ESP_IDF})\n' + DIRECTORY),
}
ONLY = {'Pico SDK': ('Cortex-M0',), 'ESP-IDF': ('rv32imac',)}       # the processors of the ways that are not for all
FIRST = '`make boards`'


# ---- programs ----

def significant(words):
    """The options that decide on code, in an order of their own."""
    level = [word for word in words if re.match(r'-O', word)][-1:]
    return tuple(sorted({word for word in words if re.match(r'-[fmD]', word)} - {'-DNDEBUG'}) + level)


class Programs:
    def __init__(self, build, folder):
        self.build, self.folder, self.kept = os.path.abspath(build), folder, {}
        self.more = []      # options for the example
        self.sources = open(f'{build}/boards/spheres', encoding='utf-8').read().split()

    def built(self, way, processor):
        """What distinguishes a program from others, and a function that builds it."""
        board, options = PROCESSORS[processor]
        compiler = qemu.binutil(board, 'gcc')
        folder = tempfile.mkdtemp(dir=self.folder)
        commands = WAYS[way](self.sources, compiler, options, folder)
        if self.sources and len(commands) > 1:
            commands = {source: words for source, words in commands.items() if source in self.sources}
        key = board, tuple((os.path.basename(source), significant(words)) for source, words in sorted(commands.items()))
        return key, lambda: self.linked(board, compiler, commands, folder)

    def measure(self, way, processor):
        key, link = self.built(way, processor)
        if key not in self.kept:
            self.kept[key] = measure(key[0], self.build, link())
        return self.kept[key]

    def linked(self, board, compiler, commands, folder):
        first = next(iter(commands.values()))
        own = [word for word in first if re.match(r'-[fmO]', word)] + ['-std=c11', '-ffreestanding', '-Iinclude', '-Iport']
        jobs = [*commands.items(), (EXAMPLE, own + self.more)]
        objects = [f"{folder}/{source.replace('/', '-')}.o" for source, _ in jobs]
        with concurrent.futures.ThreadPoolExecutor(int(os.environ.get('TEST_JOBS', os.cpu_count()))) as pool:
            list(pool.map(lambda job: run(compiler, *job[0][1], '-c', '-o', job[1], job[0][0], cwd=ROOT), zip(jobs, objects)))
        names = 'start print memcpy semihost ' + ('start-riscv' if board == 'rv32' else 'cortex-m')
        board_objects = [f'{self.build}/boards/{board}/port/boards/{name}.o' for name in names.split()]
        run(compiler, *(word for word in first if word.startswith('-m')), '-static', '-nostdlib', '-Wl,--gc-sections',
            f'-L{ROOT}/port/boards', '-T', f'{ROOT}/port/boards/{board}-large.ld', *objects, *board_objects, '-lgcc', '-o',
            f'{folder}/example.elf')
        return f'{folder}/example.elf'


def measure(board, build, image):
    """Instructions of the frame, bytes of flash and of stack, and the frame's checksum."""
    at = {name: address for address, name in count.symbols(board, image)}
    with tempfile.NamedTemporaryFile('r') as log:
        said = qemu.run(board, image, '-plugin', '%s,begin=%#x,end=%#x' % (count.plugin_of(build), at['count_begin'], at['count_end']),
                        '-d', 'plugin', '-D', log.name)
        instructions = sum(int(line.split()[1]) for line in log if line.startswith('passage'))
    crc, stack = re.fullmatch(r'(\w{8})\nstack (\d+)\n', said).groups()
    return instructions, size.sections(board, image)[0], int(stack), crc


def table(build, processors=tuple(PROCESSORS)):
    """Yields for each way its name and what is measured, by processor: by these, or by those that a way is for."""
    with tempfile.TemporaryDirectory() as folder:
        programs = Programs(build, folder)
        yield FIRST, {processor: measure(board, build, f'{build}/boards/{board}/example.elf') for processor, (board, _) in PROCESSORS.items()}
        for way in WAYS:
            yield way, {processor: programs.measure(way, processor) for processor in ONLY.get(way, processors)}


# The cores that a program may name, and that of all scenes, for which all sources are compiled.
ALL_SCENES = 'tia_core_q16'
CORES = ('tia_core_spheres', 'tia_core_spheres_small', ALL_SCENES)


def core(build, name, processor='Cortex-M3'):
    """Instructions of the frame and bytes of flash, when the example names this core and is compiled by make with -Os."""
    with tempfile.TemporaryDirectory() as folder:
        programs = Programs(build, folder)
        programs.more = [f'-D{CORES[0]}={name}']
        if name != ALL_SCENES:
            return programs.measure(next(iter(WAYS)), processor)[:2]
        programs.sources = None
        board = PROCESSORS[processor][0]
        return None, size.sections(board, programs.built(next(iter(WAYS)), processor)[1]())[0]


def missing():
    """What is not installed of what is needed."""
    tools = [package for board, _ in PROCESSORS.values() for package in qemu.missing(board)]
    return tools + [] if shutil.which('cmake') else tools + ['cmake']


def cells(measured, absent='-'):
    """Of a row: instructions a pixel, flash and stack for each processor."""
    return [cell for processor in PROCESSORS for cell in
            ((count.per_pixel(measured[processor][0]), *measured[processor][1:3]) if processor in measured else (absent,) * 3)]


def main(build):
    if missing():
        print(f'ways: {missing()[0]} is missing', file=sys.stderr)
        return
    print('| way | ' + ' | '.join(f'{name}: instructions | flash | stack' for name in PROCESSORS) + ' |')
    print('|---|' + '--:|' * 3 * len(PROCESSORS))
    for way, measured in table(build):
        print(f'| {way} | ' + ' | '.join(map(str, cells(measured))) + ' |', flush=True)


if __name__ == '__main__':
    main(sys.argv[1] if len(sys.argv) > 1 else 'build')
