"""core.py - the source files of the span core: what a program that draws scenes of spheres gets of the library."""
import os
import subprocess

# What the program of docs/boards.md names.
NAMED = ("tia_core_spheres", "tia_core_spheres_small", "tia_view_set_lights", "tia_hits_init", "tia_hits_object",
         "tia_view_trace", "tia_view_light", "tia_view_draw", "tia_crc32")


def symbols(folder):
    """By object file, the symbols that it defines and those that it needs."""
    objects = [os.path.join(path, name) for path, _, names in os.walk(folder) for name in sorted(names) if name.endswith(".o")]
    said = subprocess.run(["nm", "-P", "-A", *sorted(objects)], check=True, stdout=subprocess.PIPE, text=True).stdout
    defined, needed = {}, {}
    for line in said.splitlines():
        path, rest = line.split(": ", 1)
        name, kind = rest.split()[:2]
        if kind in "UTDRBV":
            (needed if kind == "U" else defined).setdefault(path, set()).add(name)
    return defined, needed


def sources(build, named=NAMED):
    """The files below src/ whose objects a linker takes for a program that names these, in order."""
    folder = os.path.join(build, "q16")
    defined, needed = symbols(folder)
    home = {name: path for path, names in defined.items() for name in names}
    left, taken = [home[name] for name in named], set()
    while left:
        path = left.pop()
        if path not in taken:
            taken.add(path)
            left += [home[name] for name in needed.get(path, ()) if name in home]
    return sorted(os.path.relpath(path, folder)[:-2] + ".c" for path in taken)
