"""misra.py - findings of cppcheck's addon for MISRA C:2012 in the span core, by rule, and the deviations recorded for them.

    misra.py [BUILD]            prints the findings of rules that have no deviation, or more than are recorded
    misra.py --all [BUILD]      prints all findings
    misra.py --recount [BUILD]  writes today's counts into deviations.txt
"""
import collections
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import core  # noqa: E402

FILE = "tests/evidence/deviations.txt"
HEAD = re.compile(r"(\d+\.\d+) (required|advisory|mandatory) (\d+)$")
# The product's arithmetic, for a processor of 32 bits.
OPTIONS = ("-q", "--std=c11", "--platform=arm32-wchar_t4", "--addon=misra", "--enable=style", "--max-configs=1", "-Iinclude",
           "-Isrc", "-UTIA_NUM_F64", "-UTIA_NUM_F32", "-UTIA_NUM_F128", "-UTIA_NUM_CHK", "-UTIA_WATCHED", "-D__GNUC__=12",
           "-D__SIZEOF_INT__=4", "-UTIA_NO_INT128", "-U__SIZEOF_INT128__", "-D__ARM_FEATURE_CLZ", "-D__arm__",
           "-DUINTPTR_MAX=0xffffffffU", "-DUINT32_MAX=0xffffffffU", "-D__GCC_ATOMIC_BOOL_LOCK_FREE=1")


class Deviation:
    """A rule that the core does not keep everywhere: its category, how often at most, and why that is right."""

    def __init__(self, category, count):
        self.category, self.count, self.reason = category, count, ""


def deviations(text):
    """By rule, its deviation."""
    found, last = {}, None
    for line in text.splitlines():
        head = HEAD.match(line)
        if head:
            last = found[head.group(1)] = Deviation(head.group(2), int(head.group(3)))
        elif line.startswith("    ") and last:
            last.reason = f"{last.reason} {line.strip()}".strip()
        elif line and not line.startswith("#"):
            raise ValueError(f"{FILE}: {line!r} is neither a rule nor a reason")
    return found


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def findings(build):
    """(rule, file, line) of each finding, once."""
    said = subprocess.run(["cppcheck", *OPTIONS, "--template={id} {file} {line}", *core.sources(build)], check=True,
                          capture_output=True, text=True).stderr
    found = re.findall(r"^misra-c2012-(\d+\.\d+) (\S+) (\d+)$", said, re.M)
    if not found:
        raise RuntimeError(f"cppcheck's addon for MISRA found nothing at all: {said.strip()[:200]}")
    return sorted({(rule, path, int(line)) for rule, path, line in found}, key=in_order)


def in_order(finding):
    return [int(part) for part in finding[0].split(".")], finding[1:]


def by_rule(found):
    return collections.Counter(rule for rule, _, _ in found)


def faults_of(recorded):
    """Deviations that are none: of no category, or without a reason."""
    for rule, deviation in recorded.items():
        if len(deviation.reason) < 40:
            yield f"rule {rule}: a deviation without a reason"
        if deviation.category == "mandatory":
            yield f"rule {rule} is mandatory and has no deviations"
        if not deviation.count:
            yield f"rule {rule}: no finding is recorded"


def faults(found, recorded):
    """Rules without a deviation, or with more findings than are recorded; deviations without a finding, or that are none."""
    for rule, count in by_rule(found).items():
        first = next(f"{path}:{line}" for other, path, line in found if other == rule)
        if rule not in recorded:
            yield f"rule {rule} has {count} findings and no deviation, the first at {first}"
        elif count > recorded[rule].count:
            yield f"rule {rule} has {count} findings, {recorded[rule].count} are recorded (tests/evidence/misra.py --all)"
    for rule in recorded:
        if not by_rule(found)[rule]:
            yield f"rule {rule} has a deviation and no finding"
    yield from faults_of(recorded)


def table(found, recorded):
    """A row in Markdown for each rule."""
    lines = ["| rule | category | findings | why they stay |", "|---|---|--:|---|"]
    for rule, count in by_rule(found).items():
        deviation = recorded.get(rule, Deviation("?", 0))
        lines.append(f"| {rule} | {deviation.category} | {count} | {deviation.reason.replace('|', chr(92) + '|')} |")
    return lines


def recount(found):
    counts = by_rule(found)

    def line(text):
        head = HEAD.match(text)
        return f"{head.group(1)} {head.group(2)} {counts[head.group(1)]}" if head else text

    lines = [line(text) for text in read(FILE).splitlines()]
    with open(FILE, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def main(arguments):
    option = arguments.pop(0) if arguments[:1] in (["--all"], ["--recount"]) else None
    found = findings(arguments[0] if arguments else "build")
    if option == "--recount":
        recount(found)
    for rule, path, line in found if option == "--all" else ():
        print(f"{path}:{line}: {rule}")
    wrong = list(faults(found, deviations(read(FILE))))
    print("\n".join(wrong) or f"{len(found)} findings of {len(by_rule(found))} rules, all with deviations")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
