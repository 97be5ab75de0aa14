#!/usr/bin/env python3
"""What a certifier asks of the span core, in one report.

    evidence.py BUILD [PART...]     parts: misra analyzers eva stack coverage requirements slips; none: all but slips

Writes each part into BUILD/evidence/, and all parts that are there into BUILD/evidence.md. A part whose tools are not there
is named. The status is not 0 if a part has something that is not explained. docs/evidence.md describes the parts."""
import os
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import analyzers  # noqa: E402
import core  # noqa: E402
import coverage  # noqa: E402
import eva  # noqa: E402
import kept  # noqa: E402
import misra  # noqa: E402
import requirements  # noqa: E402
import slips  # noqa: E402
import stack  # noqa: E402

WORKERS = os.cpu_count() or 1


def said_by(*command):
    said = subprocess.run(command, capture_output=True, text=True, check=False)
    return (said.stdout + said.stderr).strip()


def version(*command):
    return said_by(*command).splitlines()[0]


# What the parts run, by its package in Debian.
TOOLS = {"misra": {"cppcheck": "cppcheck"}, "analyzers": {"gcc": "gcc", "clang-tidy": "clang-tidy"},
         "eva": {"frama-c": "frama-c-base", "gcc": "gcc"}, "coverage": {"gcov": "gcc", "clang": "clang", "llvm-cov": "llvm"}}


def verdict(open_points):
    """The lines that say whether a part is complete."""
    if not open_points:
        return ["Nothing is left unexplained."]
    return [f"**Left unexplained: {len(open_points)}.**", ""] + [f"- {point}" for point in open_points]


def in_code(text):
    return f"`{text}`"


def kept_table(entries, keep):
    """Findings that stay, with their reasons."""
    lines = ["| file | finding | why it stays |", "|---|---|---|"]
    for path, text in sorted(entries):
        cell = text.replace("|", "\\|")
        lines.append(f"| {path} | {in_code(cell)} | {keep.get((path, text), '')} |")
    return lines if entries else []


def asserted_table(entries):
    lines = ["| file | in front of | condition |", "|---|---|---|"]
    for (path, text), condition in entries.items():
        lines.append(f"| {path} | {in_code(text.replace('|', chr(92) + '|'))} | {in_code(condition.replace('|', chr(92) + '|'))} |")
    return lines


def part_misra(build):
    """MISRA C:2012"""
    found, recorded = misra.findings(build), misra.deviations(misra.read(misra.FILE))
    open_points = list(misra.faults(found, recorded))
    return [f"{version('cppcheck', '--version')} with its addon; {len(found)} findings of {len(misra.by_rule(found))} rules. The deviations "
            f"are recorded in `{misra.FILE}`.", "", *misra.table(found, recorded), "", *verdict(open_points)], open_points


def part_analyzers(build):
    """Static analysis"""
    sources, keep = core.sources(build), kept.read(analyzers.FILE)
    by_gcc, by_clang = (analyzers.findings(tool, sources) for tool in (analyzers.fanalyzer, analyzers.tidy))
    open_points = [f"{path}: {text}" for path, text in kept.compare(by_gcc | by_clang, keep)[0]]
    return [f"`-fanalyzer` of {version('gcc', '--version')}: {len(by_gcc)} findings. clang-tidy "
            f"({version('clang', '--version')}; `{analyzers.CHECKS}`): {len(by_clang)} findings.", "",
            *kept_table(by_gcc | by_clang, keep), "", *verdict(open_points)], open_points


def part_eva(build):
    """Absence of run-time errors: Frama-C's Eva"""
    alarms, rows, wrong = eva.run(build, bool(os.environ.get("EVIDENCE_FULL")), WORKERS)
    open_points = [f"{alarm} ({place})" for alarm, place in alarms.items()]
    open_points += [f"state {state}, row {y}: Eva has other pixels than the program, or none" for state, y in wrong]
    return [f"Frama-C {version('frama-c', '-version')}, {rows} rows of 320 pixels of the built-in scene, of {eva.STATES * eva.HEIGHT} in "
            f"its {eva.STATES} states of the light: {len(alarms)} alarms. In {rows - len(wrong)} rows the pixels that Eva computed are "
            "those of the program, so that its values were exact.", "", *verdict(open_points)], open_points


def part_stack(_):
    """Stack"""
    lines, unbounded = stack.table()
    return ["Bytes at most, by the call graph with each function's own stack (gcc's `-fcallgraph-info=su`, `-O2`). The path through "
            "each pointer to a function is named in `tests/slow/freestanding`; recursion would be an error.", "", *lines, "",
            *verdict(unbounded)], unbounded


def part_coverage(build):
    """Coverage"""
    found, names, failed = coverage.measure(build)
    keep, missed = kept.read(coverage.FILE), set(found.missed())
    open_points = [f"{path}: {in_code(text)}" for path, text in kept.compare(missed, keep)[0]] + [f"test_{n} fails" for n in failed]
    lines, branches = found.line_counts(), found.branch_counts()
    return [f"Lines with statements ({version('gcov', '--version')}): {lines[0]} of {lines[1]}, {100 * lines[0] / lines[1]:.1f} %. Sides "
            f"of branches (llvm-cov, {version('clang', '--version')}): {branches[0]} of {branches[1]}, "
            f"{100 * branches[0] / branches[1]:.1f} %. Code for 64 bits and for 32 bits together. Tests, each in its quick form: "
            f"{', '.join(names)}.", "", f"The tests checked the assertions of `{coverage.ASSERTED}`:", "",
            *asserted_table(kept.read(coverage.ASSERTED)), "", "Not executed:", "",
            *kept_table(missed, keep), "", *verdict(open_points)], open_points


def part_requirements(_):
    """Requirements and their tests"""
    open_points = requirements.faults()
    return [f"Each sentence stands in its document, and each test is there (`{requirements.FILE}`).", "", *requirements.table(), "",
            *verdict(open_points)], open_points


def part_slips(_):
    """Tests that fail without a requirement"""
    rows, open_points = ["| slip | noticed by |", "|---|---|"], []
    for _, name, found in slips.run():
        rows.append(f"| {name} | {found or 'nothing'} |")
        if not found:
            open_points.append(f"{name}: {'does not build' if found == '' else 'no test of the requirement notices it'}")
    return ["The core with one slip at a time, from `tests/mutants`: which test of the requirement fails first.", "", *rows, "",
            *verdict(open_points)], open_points


PARTS = {name[5:]: function for name, function in list(globals().items()) if name.startswith("part_")}


def assemble(build):
    """Joins the parts that are there."""
    lines = ["# Evidence for the span core", "", f"tia {re.search(r'TIA_VERSION .(.*).$', misra.read('include/tia/tia.h'), re.M)[1]}, "
             f"commit {version('git', 'rev-parse', 'HEAD')}. Written by `make evidence`, described in docs/evidence.md.", "",
             f"The span core is what a program that draws spheres gets of the library: {', '.join(core.sources(build))}.", ""]
    for name, function in PARTS.items():
        path = f"{build}/evidence/{name}.md"
        lines += [f"## {function.__doc__}", "", misra.read(path) if os.path.exists(path) else "Not run.\n"]
    with open(f"{build}/evidence.md", "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def missing(name):
    """What a part lacks, in words; or nothing."""
    return [f"no {tool} (apt-get install {package})" for tool, package in TOOLS.get(name, {}).items() if not shutil.which(tool)]


def write_part(build, name):
    """Writes a part; whether nothing is left unexplained."""
    lacks = missing(name)
    lines, open_points = ([f"Not run: {lacks[0]}."], []) if lacks else PARTS[name](build)
    with open(f"{build}/evidence/{name}.md", "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print(f"{name}: " + (lines[0] if lacks else f"{len(open_points)} left unexplained"), flush=True)
    return not open_points


def main(build, names):
    os.makedirs(f"{build}/evidence", exist_ok=True)
    unknown = [name for name in names if name not in PARTS]
    if unknown:
        sys.exit(f"evidence: there is no part {unknown[0]}; there are {', '.join(PARTS)}")
    explained = [write_part(build, name) for name in names or [name for name in PARTS if name != "slips"]]
    assemble(build)
    print(f"written: {build}/evidence.md")
    return int(not all(explained))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "build", sys.argv[2:]))
