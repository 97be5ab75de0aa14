"""cases.py - the choice of a script's cases: all, or those that its arguments name."""
import difflib
import sys


def chosen(names):
    """Returns the cases to run. An argument that is not among `names` ends the script with status 2 and one line."""
    asked = sys.argv[1:]
    for name in asked:
        if name not in names:
            parts = [other for other in names if name in other]
            near = (parts + [other for other in difflib.get_close_matches(name, names, 3, 0) if other not in parts])[:3]
            print(f"no case '{name}': there is {', '.join(near)}", file=sys.stderr)
            sys.exit(2)
    return asked or names
