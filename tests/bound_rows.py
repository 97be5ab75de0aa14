"""bound_rows.py - the rows of the tables of error bounds, for tests/quick/bounds and tests/bounds."""
import glob
import re

from sources import read

RAYS, SPANS, SHADOWS = "src/simd/rays/", "src/simd/span/", "src/simd/shadow/"
INTEGERS, STEPS, WORDS = "src/render/span/", "src/render/span/steps/", "src/render/span/words/"
TABLES = [*sorted(glob.glob(RAYS + "bounds/*.h") + glob.glob(SPANS + "bounds/*.h") + glob.glob(SHADOWS + "bounds/*.h")), INTEGERS + "span_proved.h",
          STEPS + "steps_proved.h", WORDS + "words_proved.h"]
ROW = re.compile(r"^(?:#define BOUND_(\w+) |FORMULA\((\w+)\);"
                 r"|#define (SPAN_ERROR_\w+|(?:STEPS|WORDS)_(?!BOUND)\w+)[ (])")


def table_of(path):
    """A table's short name: rays/lights, span/cells, integers, steps, words."""
    if path.startswith(STEPS):
        return "steps"
    if path.startswith(WORDS):
        return "words"
    if path.startswith(INTEGERS):
        return "integers"
    return re.sub(r"src/simd/(\w+)/bounds/(\w+)\.h", r"\1/\2", path)


def rows():
    """(name, path, line, the comment above it or beside it) of each row."""
    for path in TABLES:
        lines = read(path).splitlines()
        for number, line in enumerate(lines):
            row = ROW.match(line)
            if not row:
                continue
            first = number
            while first > 0 and lines[first - 1].startswith((" *", "/*")) and not lines[first].startswith("/*"):
                first -= 1
            beside = line.partition("/*")[2]
            text = " ".join(part.strip(" /*") for part in [*lines[first:number], beside])
            yield row.group(1) or row.group(2) or row.group(3), path, number + 1, text.strip()
