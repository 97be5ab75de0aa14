"""coverage.py - statements and branches of the span core that its tests execute.

    coverage.py [BUILD]         prints what no test executes and uncovered.txt does not explain

The core is compiled once more, by gcc for lines (gcov) and by clang for branches (llvm-cov), each with the code for 64 bits
and with that for 32 (as32.h), and linked with the objects of the tests of tests.txt, which are built already. What is
executed in one of the two counts. Before the lines of asserted.txt the copies have assertions, which end a test.

Each test runs on one processor alone: counters are not atomic, and llvm-cov computes a side of a branch as a difference of two,
which an increment that threads lost on several processors would make wrong."""
import collections
import concurrent.futures
import glob
import json
import os
import queue
import shlex
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import core  # noqa: E402
import kept  # noqa: E402

FILE = "tests/evidence/uncovered.txt"
ASSERTED = "tests/evidence/asserted.txt"
TESTS = "tests/evidence/tests.txt"
# Tests that call functions of headers themselves: they are compiled for coverage as well.
OF_HEADERS = ("math", "num", "wide")
FLAGS = ("-std=c11", "-ffreestanding", "-Iinclude", "-iquote", "src", "-g", "-O1")
HOSTED = ("-std=c11", "-D_GNU_SOURCE", "-Iinclude", "-Iport", "-Itools", "-Ibench", "-iquote", "src", "-iquote", "tests", "-g", "-O1", "-pthread")
SIZES = {"64": (), "32": ("-include", "tests/evidence/as32.h")}
TOOLS = {"gcc": (["--coverage"], ["--coverage"]),
         "clang": (["-fprofile-instr-generate", "-fcoverage-mapping"], ["-fprofile-instr-generate"])}


def run(*command, **more):
    done = subprocess.run(command, check=False, capture_output=True, text=True, **more)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command[:1] + command[-2:])}: {done.stderr.strip()[:1000]}")
    return done.stdout


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def plain(text):
    """Text with single spaces."""
    return " ".join(text.split())


def asserting(source, text, asserted):
    """The source with its assertions, each in front of its line, in the same line."""
    for (path, line), condition in asserted.items():
        if path == source:
            if text.count("\n" + line_of(text, line) + "\n") != 1:
                raise RuntimeError(f"{ASSERTED}: {path} has not one line {line!r}")
            old = line_of(text, line)
            text = text.replace("\n" + old + "\n", f"\nif (!({condition})) __builtin_trap(); {old.strip()}\n")
    return f'# 1 "{source}"\n{text}'


def line_of(text, wanted):
    return next((line for line in text.splitlines() if line.strip() == wanted), wanted)


def compiled(source, folder, compiler, flags):
    """The object of a source: by gcc of a copy with assertions, which clang would count as branches."""
    name, taken = f"{folder}/{source.replace('/', '-')[:-2]}", source
    if compiler == "gcc":
        taken = name + ".c"
        with open(taken, "w", encoding="utf-8") as file:
            file.write(asserting(source, text_of(source), kept.read(ASSERTED)))
    run(compiler, *FLAGS, "-iquote", os.path.dirname(source), *flags, "-c", "-o", name + ".o", taken)
    return name + ".o"


def build_library(build, folder, sources, compiler, flags):
    """The library with the core compiled for coverage."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    objects = [compiled(source, folder, compiler, flags) for source in sources]
    others = sorted(set(glob.glob("src/**/*.c", recursive=True)) - set(sources))    # a build may have objects of former ones
    built = [f"{build}/q16/{source[:-2]}.o" for source in others if "/radio/" not in source]
    run("ar", "rcs", f"{folder}/libtia.a", *objects, *filter(os.path.exists, built))
    run(compiler, "-c", "-o", f"{folder}/exit.o", "tests/evidence/counted_exit.c")


def libraries(build):
    """The options -l of the build."""
    with open(f"{build}/made-with/link", encoding="utf-8") as file:
        words = shlex.split(file.read())
    return [word for word in words if word.startswith(("-l", "-Wl,"))]


def test_object(build, folder, compiler, flags, name):
    """The object of a test."""
    if name not in OF_HEADERS:
        return f"{build}/tests/test_{name}.o"
    run(compiler, *HOSTED, *flags, "-c", "-o", f"{folder}/test-{name}.o", f"tests/test_{name}.c")
    return f"{folder}/test-{name}.o"


def run_test(build, folder, compiler, flags, name, processors):
    """Whether a test passes; flags: to compile and to link it; processors: a queue of those without a test."""
    parts = [f"{build}/{part}" for part in ("liboracle.a", "libcommon.a", "libports.a", "libtia-f64.a", "libtia-f32.a",
                                            "libtia-f128.a", "libtia-simd.a", "libtia-radio.a")]
    program = f"{folder}/test_{name}"
    run(compiler, "-pthread", *flags[1], "-Wl,--wrap=_exit", "-o", program, test_object(build, folder, compiler, flags[0], name),
        f"{folder}/exit.o", *[part for part in parts if os.path.exists(part)], f"{folder}/libtia.a", *libraries(build))
    environment = {**os.environ, "CHECK_QUICK": "yes", "LLVM_PROFILE_FILE": f"{folder}/{name}-%m.profraw"}
    processor = processors.get()
    try:
        return not subprocess.run(["taskset", "--cpu-list", str(processor), program], env=environment, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, check=False).returncode
    finally:
        processors.put(processor)


def run_tests(build, folder, compiler, flags):
    """Those of the tests that fail."""
    names, processors = text_of(TESTS).split(), queue.Queue()
    for processor in os.sched_getaffinity(0):
        processors.put(processor)
    with concurrent.futures.ThreadPoolExecutor(processors.qsize()) as pool:
        passed = pool.map(lambda name: run_test(build, folder, compiler, flags, name, processors), names)
    return {name for name, good in zip(names, passed) if not good}


def lines_by_gcov(folder, found):
    """Adds by file, by line, how often it was executed."""
    for data in sorted(glob.glob(f"{folder}/*.gcda"), key=lambda path: "/test-" in path):
        for file in json.loads(run("gcov", "--json-format", "--stdout", data))["files"]:
            counts = found[os.path.relpath(file["file"])]
            for line in file["lines"]:
                if line["line_number"] in counts or "/test-" not in data:    # a test's own functions are not the core's
                    counts[line["line_number"]] += line["count"]


def branches_by_llvm(folder, found):
    """Adds by file, by place, how often a condition was true, and false."""
    suffix = shutil.which("llvm-cov") and "" or "-14"
    run(f"llvm-profdata{suffix}", "merge", "-o", f"{folder}/all.profdata", *sorted(glob.glob(f"{folder}/*.profraw")))
    programs = sorted(path for path in glob.glob(f"{folder}/test_*"))
    objects = [word for path in programs[1:] for word in ("-object", path)]
    said = json.loads(run(f"llvm-cov{suffix}", "export", f"-instr-profile={folder}/all.profdata", programs[0], *objects))
    for function in said["data"][0]["functions"]:
        for line, column, end, end_column, yes, no, file, *_ in function.get("branches", ()):
            sides = found[os.path.relpath(function["filenames"][file])][line, column, end, end_column]
            sides[0] += yes
            sides[1] += no


def is_core(path):
    return path.startswith(("src/", "include/")) and os.path.exists(path)


class Coverage:
    """What was executed: numbers, and (file, text) of each line and branch that was not."""

    def __init__(self, lines, branches):
        self.lines = {path: found for path, found in lines.items() if is_core(path)}
        # of functions that the core has; clang also counts those of its headers that nothing calls
        self.branches = {path: {place: sides for place, sides in found.items() if place[0] in lines.get(path, {})}
                         for path, found in branches.items() if is_core(path)}

    def line_counts(self):
        every = [count for found in self.lines.values() for count in found.values()]
        return len([count for count in every if count]), len(every)

    def branch_counts(self):
        every = [count for found in self.branches.values() for sides in found.values() for count in sides]
        return len([count for count in every if count]), len(every)

    def missed(self):
        """(file, text) of lines, and of branches with their condition and the side."""
        for path, found in sorted(self.lines.items()):
            for line, count in sorted(found.items()):
                if not count:
                    yield path, text_of(path).splitlines()[line - 1].strip()
        for path, found in sorted(self.branches.items()):
            for (line, column, end, end_column), sides in sorted(found.items()):
                for side, count in zip(("true", "false"), sides):
                    if not count and not self.is_missed_line(path, line):
                        yield path, f"{condition_of(path, line, column, end, end_column)} is never {side}"

    def is_missed_line(self, path, line):
        return self.lines.get(path, {}).get(line, 1) == 0


def condition_of(path, line, column, end, end_column):
    lines = text_of(path).splitlines()[line - 1:end]
    lines[-1] = lines[-1][:end_column - 1]
    lines[0] = lines[0][column - 1:]
    return plain(" ".join(lines))


def measure(build):
    """(coverage, names of the tests, those that failed)."""
    sources, failed = core.sources(build), set()
    lines = collections.defaultdict(lambda: collections.defaultdict(int))
    branches = collections.defaultdict(lambda: collections.defaultdict(lambda: [0, 0]))
    for compiler, (to_compile, to_link) in TOOLS.items():
        for size, flags in SIZES.items():
            folder = f"{build}/evidence/{compiler}-{size}"
            to_compile_so = [*to_compile, *flags]
            build_library(build, folder, sources, compiler, to_compile_so)
            failed |= {f"{name}, {compiler}, {size} bits"
                       for name in run_tests(build, folder, compiler, (to_compile_so, to_link))}
            if compiler == "gcc":
                lines_by_gcov(folder, lines)
            else:
                branches_by_llvm(folder, branches)
    return Coverage(lines, branches), text_of(TESTS).split(), sorted(failed)


def main(arguments):
    found, _, failed = measure(arguments[0] if arguments else "build")
    unexplained, gone = kept.compare(set(found.missed()), kept.read(FILE))
    for path, text in unexplained:
        print(f"{path}: {text}")
    for path, text in gone:
        print(f"# now executed: {path}: {text}")
    print("lines %d of %d, branches %d of %d" % (*found.line_counts(), *found.branch_counts()),
          f"{len(unexplained)} unexplained; failed: {failed}")
    return int(bool(unexplained or failed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
