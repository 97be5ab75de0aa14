"""eva.py - Frama-C's Eva over the drawing of the built-in scene: alarms, and whether it computed each row's pixels.

    eva.py [--all] [BUILD]      every tenth row of each state of the light, in each state others; or all rows

Eva interprets tests/evidence/eva.c, which prepares a view of 320x240 pixels and draws rows in each state of the light,
with the core for spheres alone and the tables that tia-compile makes of scenes/thesis.tia. All of that is known, so that
every value is one number, and an alarm would be an error or a place where Eva lost a value. That it lost none is
compared: the number that Eva computes of each row's pixels is that of the program."""
import concurrent.futures
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import core  # noqa: E402

STATES, HEIGHT, STEP = 5, 240, 10
DRIVER = "tests/evidence/eva.c"
# Without __GNUC__ the code is plain C: leading zeros from a table, as on a Cortex-M0. One thread reads `traced`.
PLAIN = "-Iinclude -iquotesrc -m32 -U__GNUC__ -Dvolatile="
OPTIONS = ("-c11", "-machdep", "gcc_x86_32", "-eva", "-eva-precision", "0", "-eva-slevel", "1000000000", "-eva-split-return", "full",
           "-eva-no-results", "-eva-no-alloc-returns-null", "-eva-msg-key=-initial-state", "-warn-signed-overflow",
           "-no-warn-right-shift-negative", "-no-warn-left-shift-negative")


def small_sources(build):
    """The core's files that the smaller core for spheres needs."""
    return core.sources(build, [name for name in core.NAMED if name != "tia_core_spheres"])


def compile_scene(build, folder):
    """The scene's tables, and the sizes of a view and of a row's hits on a machine of 32 bits."""
    subprocess.run([f"{build}/tia-compile", "scenes/thesis.tia", "--name", "thesis", "-o", f"{folder}/thesis.c", "--memory",
                    f"{folder}/thesis.h", "-s", "320x1", "--lights", "1"], check=True)
    with open(f"{folder}/thesis.h", encoding="utf-8") as file:
        sizes = dict(re.findall(r"#define THESIS_(VIEW|HITS_320x1) TIA_BYTES\(\d+u, (\d+)u,", file.read()))
    return [f"-DVIEW_BYTES={sizes['VIEW']}", f"-DHITS_BYTES={sizes['HITS_320x1']}"]


def parts(every):
    """(state, first row) of each run of Eva, which draws every tenth row."""
    return [(state, first) for state in range(STATES) for first in (range(STEP) if every else [2 * state])]


def alarms_of(said):
    """The alarms in what Eva says: "file:line: text"."""
    found = re.findall(r"^\[eva:alarm\] (\S+): Warning:((?:.|\n(?!\[|$))*)", said, re.M)
    return [f"{place}: {' '.join(text.split())}" for place, text in found]


def numbers_of(said):
    return {(int(s), int(y)): int(n) for s, y, n in re.findall(r"Frama_C_show_each_row:\s+\{(\d+)\},\s+\{(\d+)\},\s+\{(\d+)\}", said)}


def analyse(build, folder, sizes, part):
    """(alarms, numbers of rows) of one run of Eva."""
    state, first = part
    defines = " ".join([*sizes, f"-DSTATE={state}", f"-DFIRST={first}", f"-DSTEP={STEP}"])
    said = subprocess.run(["frama-c", *OPTIONS, f"-cpp-extra-args={PLAIN} {defines}", *small_sources(build), f"{folder}/thesis.c",
                           DRIVER], capture_output=True, text=True, check=False).stdout
    if "[eva:summary]" not in said:
        raise RuntimeError(f"Eva ended early in state {state}, rows from {first}: {said.strip().splitlines()[-1:]}")
    return alarms_of(said), numbers_of(said)


def drawn(build, folder, sizes, state):
    """The numbers of a state's rows as the program computes them."""
    program = f"{folder}/eva-{state}"
    sizes = [option.split("=")[0] + "=8192" for option in sizes]    # pointers of 64 bits take more
    subprocess.run(["gcc", "-std=c11", "-O1", "-Iinclude", *sizes, f"-DSTATE={state}", "-DFIRST=0", "-DSTEP=1", "-o",
                    program, DRIVER, f"{folder}/thesis.c", f"{build}/libtia.a"], check=True)
    said = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {(int(s), int(y)): int(n) for s, y, n in (line.split() for line in said.splitlines())}


def run(build, every=False, workers=1):
    """(alarms, each with where it was; rows that Eva was to draw; those that it drew otherwise than the program, or not)."""
    folder = f"{build}/evidence"
    os.makedirs(folder, exist_ok=True)
    sizes = compile_scene(build, folder)
    wanted, alarms, got = {}, {}, {}
    for state in range(STATES):
        wanted.update(drawn(build, folder, sizes, state))
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for part, (found, numbers) in zip(parts(every), pool.map(lambda part: analyse(build, folder, sizes, part), parts(every))):
            got.update(numbers)
            for alarm in found:
                alarms.setdefault(alarm, f"state {part[0]}, rows {part[1]}, {part[1] + STEP} ...")
    asked = [(state, y) for state, first in parts(every) for y in range(first, HEIGHT, STEP)]
    return alarms, len(asked), [row for row in asked if got.get(row) != wanted[row]]


def main(arguments):
    every = arguments[:1] == ["--all"]
    alarms, count, wrong = run((arguments[every:] or ["build"])[0], every, os.cpu_count() or 1)
    for alarm, place in alarms.items():
        print(f"{alarm} ({place})")
    print(f"{count} rows, {len(alarms)} alarms, {len(wrong)} rows with other pixels{': ' + str(wrong[:5]) if wrong else ''}")
    return int(bool(alarms or wrong))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
