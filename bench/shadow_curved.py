#!/usr/bin/env python3
"""Prints the table of curved shapes in docs/shadows.md: the numbers of pixels that --shadows rays draws otherwise than
--shadows traced, with curved shapes left to rays, and tessellated with several errors.

    shadow_curved.py TIA SCENE...   for 320x240 pixels: all that differ, and those by more than 1/8 of a channel's range"""
import os
import subprocess
import sys
import tempfile

WIDTH, HEIGHT = 320, 240
ERRORS = ["0", "0.1", "0.01", "0.001"]


def draw(folder, tia, scene, *options):
    """Returns the channels of all pixels; nothing if tia refuses the scene, after tia's own message."""
    out = os.path.join(folder, "out.ppm")
    drawn = subprocess.run([tia, *options, "-s", f"{WIDTH}x{HEIGHT}", "-o", out, scene], check=False)
    if drawn.returncode:
        return b""
    with open(out, "rb") as file:
        return file.read()[-3 * WIDTH * HEIGHT:]


def differences(a, b):
    """Returns the number of pixels that differ, and of those that differ by more than an eighth."""
    pixels = range(0, len(a), 3)
    most = [max(abs(a[i + c] - b[i + c]) for c in range(3)) for i in pixels if a[i:i + 3] != b[i:i + 3]]
    return f"{len(most)}, {sum(1 for m in most if m > 32)}"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print("| scene | left to rays | " + " | ".join(f"tessellated {error}" for error in ERRORS[1:]) + " |")
    print("|---|" + "--:|" * len(ERRORS))
    with tempfile.TemporaryDirectory() as folder:
        for scene in sys.argv[2:]:
            traced = draw(folder, sys.argv[1], scene, "--shadows", "traced")
            row = []
            for error in ERRORS:
                got = draw(folder, sys.argv[1], scene, "--shadows", "rays", "--tessellated", error)
                row.append(differences(traced, got) if got else "refused")
            print(f"| {os.path.basename(scene)} | " + " | ".join(row) + " |", flush=True)


main()
