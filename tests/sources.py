"""sources.py - the C files of the project and what they include, for tests/quick/laws and its kin."""
import os
import re

from cases import chosen

FOLDERS = ("include", "src", "port", "tools", "tests", "bench")


def sources():
    for folder in FOLDERS:
        for path, folders, names in os.walk(folder):
            folders.sort()
            for name in sorted(names):
                if name.endswith((".c", ".h")):
                    yield os.path.join(path, name)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def includes(path):
    """(line, whether in quotes, name) of each #include."""
    for number, line in enumerate(read(path).splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def find_quoted(path, name, folders):
    """Where `#include "name"` in `path` leads, with those folders to search."""
    for folder in (os.path.dirname(path), *folders):
        candidate = os.path.normpath(os.path.join(folder, name))
        if os.path.exists(candidate):
            return candidate
    return None


def report(laws):
    """A case for each law, a function that yields what breaks it. Names on the command line choose."""
    names = chosen([law.__name__ for law in laws])
    for law in [law for law in laws if law.__name__ in names]:
        broken = list(law())
        for what in broken[1:]:
            print("#", what)
        more = f" (and {len(broken) - 1} more)" if len(broken) > 1 else ""
        print(f"FAIL {law.__name__}: {broken[0]}{more}" if broken else f"ok {law.__name__}")
