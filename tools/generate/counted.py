#!/usr/bin/env python3
"""Updates the figures in README.md and docs/ that are counted, not timed; `make docs` calls it.

    counted.py [--check] [--only NAME] [--root FOLDER] [BUILD]

`<!-- counted: NAME -->` stands in front of a table, a block or a paragraph with such figures. --check changes no file. It
prints a line for each name: "ok NAME", "FAIL NAME: WHY" if a figure is out of date, or "skip NAME: WHY"; and it leaves out
counts that take minutes. Numbers of instructions depend on the compiler's version. The figures are those of Debian 12's
compilers; without these, a name is skipped."""
import argparse
import functools
import glob
import importlib.machinery
import importlib.util
import itertools
import os
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests/boards"))
import count
import cycles as cycle_models
import qemu
import size
import stack as call_graph
import ways as build_ways

BUILD = "build"
VERSIONS = {"gcc": "12", "arm-none-eabi-gcc": "12.2", "riscv64-unknown-elf-gcc": "12.2", "avr-gcc": "5.4"}
DATABASES = sorted(os.path.relpath(path, ROOT) for path in glob.glob(os.path.join(ROOT, "scenes/nff/*.nff")))


class Missing(Exception):
    """Raised if a figure cannot be counted here; the text is the reason."""


class Wrong(Exception):
    """Raised if a page has no place for a figure."""


def run(*command):
    return subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, cwd=ROOT).stdout


def tool(name, *arguments):
    return run(os.path.join(BUILD, name), *arguments)


def version_is_right(compiler, kind):
    version = run(compiler, "-dumpversion").strip()
    if not (version + ".").startswith(VERSIONS[kind] + "."):
        raise Missing(f"the figures are of {kind} {VERSIONS[kind]}, this is {version}")


def boards(*names):
    for board in names:
        if qemu.missing(board):
            raise Missing(f"{qemu.missing(board)[0]} is not installed (make deps docs installs it)")
        compiler = qemu.binutil(board, "gcc")
        version_is_right(compiler, compiler)


def plain_build():
    """Raises Missing unless the build is one by gcc -O2 on x86-64: floats depend on the compiler and its flags."""
    with open(os.path.join(ROOT, BUILD, "made-with/core"), encoding="utf-8") as file:
        made = file.read().split()
    if made[-1] != "-O2" or os.uname().machine != "x86_64":
        raise Missing("the figures are of a build by -O2 on x86-64")
    if "clang" in run(made[1], "--version"):
        raise Missing("the figures are of a build by gcc")
    version_is_right(made[1], "gcc")


# ---- figures: each function takes the lines on a page, and returns them with today's figures ----

def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def table(row):
    """Returns a function that updates a table: `row` maps a row's old cells to the new ones."""
    def made(lines):
        return lines[:2] + ["|" + "".join(f" {cell} |" if cell != "" else " |" for cell in row(cells(line))) for line in lines[2:]]
    return made


def by_first_cell(rows):
    """Returns a function that updates a table: `rows` has the cells after a row's first one; None keeps a cell."""
    def row(old):
        if old[0] not in rows:
            raise Wrong(f"nothing is counted for the row {old[0]!r}")
        new = rows[old[0]]
        return [old[0]] + [o if n is None else n for o, n in zip(old[1:], new, strict=True)]
    return table(row)


def words(figures):
    """Returns a function that updates a paragraph: `figures` maps sentences to the numbers that belong in their braces."""
    def made(lines):
        text, found = "\n".join(lines), 0
        for sentence, numbers in figures.items():
            pattern = re.escape(sentence).replace(r"\ ", r"\s+").replace(r"\{\}", r"([\d.]*\d)")
            for match in reversed(list(re.finditer(pattern, text))):
                found += 1
                for i in range(len(numbers), 0, -1):
                    text = text[:match.start(i)] + str(numbers[i - 1]) + text[match.end(i):]
        if not found:
            raise Wrong("none of the sentences is there")
        return text.split("\n")
    return made


def block(text):
    """Returns a function that writes a block of text up to its first empty line, without the rows of vector units, which not
    every processor has."""
    made = [line for line in text.split("\n\n")[0].splitlines() if not re.match(r" +(scalar|sse41|avx2|avx512) ", line)]
    return lambda _: ["    " + line if line else line for line in made]


COMPARED = {"scene": ("--exact",), "default": ("--exact", "-s", "640x480", "--summary"),
            "random": ("--exact", "--random", "200", "--seed", "7", "--summary"),
            "ties": ("--exact", "--ties", "700", "--seed", "7", "--summary"),
            "hard": ("--exact", "--hard", "100", "--seed", "7", "--summary"),
            "everything": ("--rays-random", "100", "--summary"), "databases": ("-s", "320x240", *DATABASES, "--summary")}


@functools.lru_cache(None)
def compared(what):
    plain_build()
    return tool("tia-compare", *COMPARED[what])


def differing(what):
    """Returns the number of pixels, and the numbers of pixels in integers and in floats that differ from doubles."""
    q16, f32 = [line.split() for line in compared(what).split("\n\n")[0].splitlines()[-2:]]
    at, base = q16.index("q16"), f32.index("f32")
    return int(q16[at + 1]), int(q16[at + 1]) - int(q16[at + 2]), "the reference", int(f32[base + 1]) - int(f32[base + 2])


def inexact(what):
    """Returns the number of pixels, and the numbers of pixels in integers, doubles and floats that are not exact."""
    rows = dict(re.findall(r" (\w+) +(\d+ +\d+)(?: +\d+)*$", compared(what).split("\n\n")[0].split(" frames", 1)[1], re.M))
    figures = {name: [int(number) for number in row.split()] for name, row in rows.items()}
    double, single = figures.pop("f64")[1], figures.pop("f32")[1]
    return figures["plain"][0], sum(row[1] for row in figures.values()), double, single


def compare(full):
    return by_first_cell({"the built-in scene, 5 frames of 640x480": inexact("default"),
                          "the built-in scene, 5 frames of 1920x1080": inexact("scene"),
                          "200 random scenes of spheres": inexact("random") if full else (None,) * 4,
                          "700 scenes with ties": inexact("ties"),
                          "100 hard scenes": inexact("hard"),
                          "100 random scenes of everything": differing("everything") if full else (None,) * 4,
                          "the Standard Procedural Databases, 13 scenes": differing("databases")})


def sizes(_):
    boards(*(board for board, _ in size.BOARDS))
    rows = {}
    for board, processor in size.BOARDS:
        flash, data, stack = size.measure(BUILD, board)
        rows[processor] = (flash, data, stack, data + stack, size.RAM - data, size.least_stack(board, size.image_of(BUILD, board)))
    return by_first_cell(rows)


def stacks(_):
    """Updates the bounds of the stack that drawing takes."""
    for prefix, _ in call_graph.PROCESSORS.values():
        if not shutil.which(prefix + "gcc"):
            raise Missing(f"{prefix}gcc is not installed (make deps docs installs it)")
        version_is_right(prefix + "gcc", prefix + "gcc")
    return by_first_cell({processor: list(call_graph.measure(processor).values()) for processor in call_graph.PROCESSORS})


def tiny(_):
    boards("stm32vldiscovery")
    image = f"{BUILD}/boards/stm32vldiscovery/rows.elf"
    stack = int(re.search(r"^stack (\d+)$", qemu.run("stm32vldiscovery", image), re.M)[1])
    flash, data = size.sections("stm32vldiscovery", image)
    return words({"takes {} bytes of flash, {} of data and {} of stack, for which 8 KB of RAM leave {}": (flash, data, stack, 8192 - data)})


@functools.lru_cache(None)
def counts():
    """Returns by processor and arithmetic: instructions of a full and of a relit frame, and the AVR's cycles."""
    boards(*(board for board, _ in count.BOARDS))
    made = {}
    for board, processor in count.BOARDS:
        for arithmetic, _ in count.ARITHMETICS:
            image = count.image_of(BUILD, board, arithmetic)
            if os.path.exists(image):
                full, relit, _, _, cycles = count.count(board, image, count.plugin_of(BUILD))
                made[processor, arithmetic] = full, relit, cycles
    return made


def instructions(_):
    made = counts()
    return by_first_cell({processor: [count.per_pixel(number) for arithmetic, _ in count.ARITHMETICS
                                      for number in made.get((processor, arithmetic), (None, None))[:2]]
                          for _, processor in count.BOARDS})


def crowds(_):
    boards(*(board for board, _ in count.CROWDED))
    return by_first_cell(dict(count.crowds(BUILD)))


def cycles(_):
    integers, floats = (counts()["ATmega1284P", arithmetic][2] for arithmetic in ("q16", "f32"))
    return words({"takes {} cycles a pixel: a frame of 320x240 is drawn in {} seconds at 16 MHz":
                  (count.per_pixel(integers), round(integers / 16e6)),
                  "Float takes {} cycles,": (count.per_pixel(floats),)})


@functools.lru_cache(None)
def modelled():
    boards(*{board for board, _ in cycle_models.MODELS.values()})
    return cycle_models.measure(BUILD)


def models(_):
    return by_first_cell({processor: [count.per_pixel(number) for number in numbers] for processor, numbers in modelled().items()})


def chips(_):
    """Updates a table of chips: processor, MHz, instructions a pixel, those of floats, cycles, and a frame's time by the
    model."""
    def row(chip, processor, mhz):
        executed, taken = modelled()[processor]
        single = counts().get((processor.rstrip("+"), "f32"), (None,))[0]
        return processor, mhz, *(count.per_pixel(number) for number in (executed, single, taken)), cycle_models.frame_ms(taken, mhz)
    return by_first_cell({chip[0]: row(*chip) for chip in cycle_models.CHIPS})


# The processor of ways if not all are counted: each of them takes a compiler and QEMU as long.
WAYS_USUAL = ("Cortex-M3",)


@functools.lru_cache(None)
def ways_built(full):
    boards(*(board for board, _ in build_ways.PROCESSORS.values()))
    if build_ways.missing():
        raise Missing(f"{build_ways.missing()[0]} is not installed (make deps docs installs it)")
    return dict(build_ways.table(BUILD, tuple(build_ways.PROCESSORS) if full else WAYS_USUAL))


# How many times the instructions of `make boards` any other way may take.
WAYS_MOST = 1.05


def ways(full):
    """Updates the table of ways, for one processor unless all are asked for. Raises Wrong if one takes more than the
    boards' own programs, or draws something else."""
    made = ways_built(full)
    best = made[build_ways.FIRST]
    for way, measured in made.items():
        for processor, (instructions, _, _, picture) in measured.items():
            if instructions > WAYS_MOST * best[processor][0]:
                raise Wrong(f"{way} takes {count.per_pixel(instructions)} instructions on a {processor}, `make boards` {count.per_pixel(best[processor][0])}")
            if picture != best[processor][3]:
                raise Wrong(f"{way} draws {picture} on a {processor}, not {best[processor][3]}")
    return by_first_cell({way: build_ways.cells(measured, "-" if full else None) for way, measured in made.items()})


def changes(_):
    """Writes the bytes that keys take on an SPI panel."""
    if not os.path.exists(os.path.join(BUILD, "tests/test_spi_figures")):
        raise Missing("test_spi_figures is not built (make counted builds it)")
    rows = tool("tests/test_spi_figures", "--table").splitlines()
    return lambda lines: lines[:2] + rows


def cores(full):
    """Updates the table of cores: a program's flash, and instructions a pixel; for the core of all scenes only if asked."""
    boards("mps2-an385")
    names = [name for name in build_ways.CORES if full or name != build_ways.ALL_SCENES]
    made = {f"`{name}`": build_ways.core(BUILD, name) for name in names}

    def row(old):
        instructions, flash = made.get(old[0], (None, None))
        return [*old[:2], count.per_pixel(instructions), round(flash / 1000) if flash else old[3]]
    return table(row)


def shadows(_):
    boards("mps2-an385")
    return by_first_cell({name: (f"{number:.0f}", view, hits) for name, number, view, hits in count.shadows(BUILD)})


def trust(_):
    boards("mps2-an385")
    return by_first_cell({f"strips of {rows} rows": count.trust_cells(BUILD, rows) for rows in count.TRUST_ROWS})


def light(_):
    boards("mps2-an385")
    image = f"{BUILD}/boards/mps2-an385/light.elf"
    said = qemu.run("mps2-an385", image)
    views, hits = zip(*((int(view), int(hit)) for view, hit in re.findall(r"^(?:ao|path) \w+ (\d+) (\d+)$", said, re.M)))
    stack = int(re.search(r"^stack (\d+)$", said, re.M)[1])
    return words({"Of that RAM {} bytes are data, {} of them a view and {} a tile's hits, and {} are stack":
                  (size.sections("mps2-an385", image)[1], max(views), max(hits), stack)})


@functools.lru_cache(None)
def rays():
    """Returns by scene of the Standard Procedural Databases: number of rays, and instructions on a Cortex-M3."""
    boards("mps2-an385")
    made = {}
    for line in tool("boards/observed", *DATABASES).splitlines():
        name = os.path.basename(line.split()[0])[:-4]
        image = f"{BUILD}/boards/mps2-an385/rays-{name}.elf"
        made[name] = int(line.split()[1]), count.count("mps2-an385", image, count.plugin_of(BUILD))[0]
    return made


def ray_by_ray(_):
    def row(old):
        number, executed = rays()[old[0]]
        now = round(executed / number)
        return old[0], f"{number / count.RAY_PIXELS:.2f}", old[2], now, round(100 - 100 * now / int(old[2]))
    return table(row)


SCENES = tuple(f"scenes/{name}.tia" for name in ("porch", "shadow-volume", "shadow-mapping"))


def techniques(_):
    """Updates the table of techniques. A row lists techniques that draw the same picture, and the memory of each."""
    seen, by_technique, scene = {}, {}, None
    for line in tool("tia-compare", "--shadows", "-s", "400x300", *SCENES).splitlines():
        if match := re.match(r"(\S+\.tia), 400x300, (\d+) pixels see", line):
            scene = match[1]
            seen[scene] = match[2]
        elif scene and (match := re.match(r"([a-z-]+) +(\d+) +(\d+) +(\d+) .* (\d+)$", line)):
            by_technique[scene, match[1]] = match[2], match[3], match[4], match[5]
    at = None

    def row(old):
        nonlocal at
        at = old[0].split(",")[0] or at
        figures = [by_technique[at, name] for name in old[1].split(", ")]
        if len({f[:3] for f in figures}) > 1:
            raise Wrong(f"{at}: {old[1]} do not draw the same")
        title = re.sub(r"\d+", seen[at], old[0].split(",")[1]) if old[0] else ""
        return [f"{at},{title}" if old[0] else "", old[1], *figures[0][:3], ", ".join(f[3] for f in figures)]
    return table(row)


def loaded(path):
    """Returns a script, loaded as a module."""
    loader = importlib.machinery.SourceFileLoader("script", os.path.join(ROOT, path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("script", loader))
    loader.exec_module(module)
    return module


KINDS = ("thesis", "random", "rays holes", "ao path room lamps", "play", "curved flat mirror orthographic polygons", "radio")


def frames_of_levels(arch, plain):
    """Returns the numbers of SIMD builds; nothing on a processor without AVX-512, which has fewer of them."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        if "avx512vl" not in file.read().split():
            return {}
    levels = list(arch.simd_builds())
    usual = sum(build.usual() for build in plain + levels)
    return {"{} more builds draw with": (len(levels),), "takes {} of these {}.": (usual, len(plain + levels))}


def frames(_):
    """Counts the pinned frames by kind, and the builds that draw them."""
    with open(os.path.join(ROOT, "tests/golden/frames.crc"), encoding="utf-8") as file:
        kinds = [re.match("[a-z]+", line)[0] for line in file if not line.startswith("#")]
    if set(kinds) != set(" ".join(KINDS).split()):
        raise Wrong(f"tests/golden/frames.crc has other kinds of frames: {sorted(set(kinds))}")
    by_kind = [sum(kind in group.split() for kind in kinds) for group in KINDS]
    arch = loaded("tests/slow/arch")
    plain = list(arch.builds())
    return words({"Of {} frames in {} builds": (len(kinds), len(plain)),
                  "the CRC-32 of {} frames with `tests/golden/frames.crc`: {} builds": (len(kinds), len(plain)),
                  **frames_of_levels(arch, plain),
                  "{} frames are of the built-in scene, {} of random balls, {} of random scenes of everything, {} of paths "
                  "and ambient occlusion, {} of keyframes played, and {} of [shadows]": by_kind[:6],
                  "{} are the points of radio": by_kind[6:]})


def mutants(_):
    names = []
    for path in glob.glob(os.path.join(ROOT, "tests/mutants/*.txt")):
        with open(path, encoding="utf-8") as file:
            names += [line for line in file if re.match(r"  \S", line)]
    return words({"at a time, {} times": (len(names),),
                  "shrinks each of {} bounds to a fourth": (sum("fourth" in name for name in names),)})


# In the order in which they are counted. The names in SLOW take minutes.
NAMES = {"frames": frames, "mutants": mutants, "size": sizes, "stack": stacks, "tiny": tiny, "count": instructions, "crowds": crowds, "cycles": cycles,
         "models": models, "chips": chips, "ways": ways, "cores": cores, "changes": changes,
         "shadows": shadows, "light": light, "trust": trust, "rays": ray_by_ray, "techniques": techniques,
         "compare": compare, **{f"compare-{what}": lambda _, what=what: block(compared(what)) for what in ("scene", "random", "everything", "databases")}}
SLOW = ("compare-everything", "compare-random", "stack")


# ---- pages ----

MARK = re.compile(r"(?m)^<!-- counted: (\S+) -->\n((?:.*\S.*\n)+)")


def pages(root):
    found = ["README.md", *sorted(os.path.relpath(path, root) for path in glob.glob(os.path.join(root, "docs/*.md")))]
    made = {}
    for page in found:
        with open(os.path.join(root, page), encoding="utf-8") as file:
            made[page] = file.read()
    return made


def stale(page, old, new):
    """Yields a message for each line of the page that is out of date."""
    for before, after in itertools.zip_longest(old, new, fillvalue=""):
        if before != after:
            yield f"{page} says {' '.join(before.split())!r}, is {' '.join(after.split())!r}"


def rewrite(texts, name, full):
    """Updates the texts in place. Returns the messages on what was out of date."""
    make, found, wrong = NAMES[name](full), 0, []
    for page in list(texts):
        for match in reversed([match for match in MARK.finditer(texts[page]) if match[1] == name]):
            found += 1
            old = match[2].splitlines()
            new = make(old)
            wrong += stale(page, old, new)
            texts[page] = texts[page][:match.start(2)] + "\n".join(new) + "\n" + texts[page][match.end(2):]
    if not found:
        raise Wrong(f"no page has a mark 'counted: {name}'")
    return wrong


def store(root, before, texts):
    for page, text in texts.items():
        if text != before[page]:
            with open(os.path.join(root, page), "w", encoding="utf-8") as file:
                file.write(text)


def report(root, name, checks):
    """Checks or rewrites the figures of a name. Returns the line to print."""
    before = pages(root)
    texts = dict(before)
    try:
        if name not in NAMES:
            raise Wrong("nothing is counted for this name")
        wrong = rewrite(texts, name, not checks)
    except Missing as why:
        return f"skip {name}: {why}"
    except (Wrong, qemu.Failed, subprocess.CalledProcessError, OSError) as why:
        return f"FAIL {name}: {why}"
    if checks:
        return f"FAIL {name}: {'; '.join(wrong)} (make docs)" if wrong else f"ok {name}"
    store(root, before, texts)
    return f"ok {name}" + (f": {len(wrong)} lines are new" if wrong else "")


def main():
    global BUILD
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", choices=NAMES)
    parser.add_argument("--root", default=ROOT)
    parser.add_argument("build", nargs="?", default=BUILD)
    arguments = parser.parse_args()
    BUILD = arguments.build
    root = os.path.abspath(arguments.root)
    os.chdir(ROOT)
    marks = {match[1] for text in pages(root).values() for match in MARK.finditer(text)}
    names = [arguments.only] if arguments.only else [*NAMES, *sorted(marks - set(NAMES))]
    failed = False
    for name in names:
        if not (arguments.check and name in SLOW):
            said = report(root, name, arguments.check)
            failed = failed or said.startswith("FAIL ")
            print(said, flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
