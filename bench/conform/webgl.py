#!/usr/bin/env python3
"""Draws the trials of tia-conform by WebGL 2 in headless Chromium:

    build/tia-conform --by bench/conform/webgl.py --step 16"""
import base64
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests"))
import browser  # noqa: E402

SIDE = 64
# By SwiftShader, Chromium's own OpenGL for machines without a GPU, unless WEBGL_FLAGS has other flags.
FLAGS = os.environ.get("WEBGL_FLAGS", "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader").split()
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/web/page/webgl.js"), encoding="utf-8") as script:
    PAGE = script.read() + "; window.triangles = openTriangles(); triangles ? triangles.driver : ''"
DRAW = "btoa(Array.from(triangles.draw({}), byte => String.fromCharCode(byte)).join(''))"


def main():
    if not browser.PROGRAM:
        sys.exit("webgl.py: no Chromium")
    browser.FLAGS = tuple(flag for flag in browser.FLAGS if flag != "--disable-gpu") + tuple(FLAGS)
    with browser.Browser() as program:
        page = program.page("about:blank", SIDE, SIDE)
        driver = page.run(PAGE)
        if not driver:
            sys.exit("webgl.py: no WebGL 2")
        sys.stdout.buffer.write(driver.encode() + b"\n")
        sys.stdout.buffer.flush()
        for line in sys.stdin:
            numbers = [int(word) for word in line.split()]
            sys.stdout.buffer.write(base64.b64decode(page.run(DRAW.format(numbers))))
            sys.stdout.buffer.flush()


main()
