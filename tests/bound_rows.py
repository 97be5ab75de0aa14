"""bound_rows.py - the rows of the tables in src/simd/rays/bounds, for tests/quick/bounds and tests/bounds."""
import glob
import re

from sources import read

RAYS = "src/simd/rays/"
TABLES = sorted(glob.glob(RAYS + "bounds/*.h"))
ROW = re.compile(r"^(?:#define BOUND_(\w+) |FORMULA\((\w+)\);)")


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
            yield row.group(1) or row.group(2), path, number + 1, text.strip()
