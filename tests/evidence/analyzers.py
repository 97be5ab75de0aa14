"""analyzers.py - findings of gcc's -fanalyzer and -Wcast-qual and of clang-tidy in the span core.

    analyzers.py [BUILD]        prints those that explained.txt does not explain"""
import concurrent.futures
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import core  # noqa: E402
import kept  # noqa: E402

FILE = "tests/evidence/explained.txt"
INCLUDES = ("-std=c11", "-ffreestanding", "-Iinclude", "-iquote", "src")
CHECKS = "-*,clang-analyzer-*,bugprone-*,cert-*,-bugprone-easily-swappable-parameters"


def fanalyzer(source, compiler="gcc"):
    """(file, "option: text") of each finding of -fanalyzer, and of -Wcast-qual, which rule 11.8 of MISRA is about."""
    said = subprocess.run([compiler, *INCLUDES, "-O1", "-fanalyzer", "-Wcast-qual", "-c", "-o", os.devnull, source], capture_output=True,
                          text=True, check=True).stderr
    return {(path, f"{option}: {text}") for path, text, option in
            re.findall(r"^(\S+?):\d+:\d+: warning: (.*?) \[(?:CWE-\d+\] \[)?(-W(?:analyzer-[\w-]+|cast-qual))\]", said, re.M)}


def tidy(source):
    """(file, "check: text") of each finding of clang-tidy."""
    said = subprocess.run(["clang-tidy", "--quiet", f"--checks={CHECKS}", "--header-filter=(src|include)/.*", source, "--", *INCLUDES],
                          capture_output=True, text=True, check=True).stdout
    return {(os.path.relpath(path), f"{check}: {text}") for path, text, check in
            re.findall(r"^(\S+?):\d+:\d+: warning: (.*?) \[([\w.,-]+)\]$", said, re.M)}


def findings(tool, sources):
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("TEST_JOBS") or os.cpu_count() or 1)) as pool:
        return set().union(*pool.map(tool, sources))


def main(arguments):
    sources = core.sources(arguments[0] if arguments else "build")
    found = findings(fanalyzer, sources) | findings(tidy, sources)
    unexplained, gone = kept.compare(found, kept.read(FILE))
    for path, text in unexplained:
        print(f"{path}: {text}")
    for path, text in gone:
        print(f"# no longer found: {path}: {text}")
    print(f"{len(found)} findings, {len(unexplained)} unexplained")
    return int(bool(unexplained))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
