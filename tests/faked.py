"""make with compilers that are scripts, in a temporary folder that only links to the sources."""
import os
import shutil
import subprocess

from command import LIMIT_S, check, make_files

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
FOLDERS = ("include", "src", "port", "tools", "tests", "bench", "scenes", "man")
# Writes down how it was called and replaces its output, as some compilers do. As a preprocessor it finds no vector unit, but
# a type of 113 bits.
COMPILER = """#!/bin/sh
case " $* " in *" src/num/probe.h "*) echo yes; exit ;; esac
case " $* " in *" -E "*) exit ;; esac
echo "$0 $*" >>"$CALLS"
[ "$1" != -dumpmachine ] || { echo "$MACHINE"; exit; }
while [ $# -gt 0 ]; do [ "$1" != -o ] || out=$2; shift; done
case $out in build/*) rm -f "$out"; echo made >"$out" ;; esac
"""
ARCHIVER = """#!/bin/sh
echo made >"$2"
"""
PKG_CONFIG = """#!/bin/sh
echo "$*" >>"$ASKED"
case " $* " in *" $LACKING "*) exit 1 ;; esac
case " $* " in *" --modversion "*) echo 5.2.4; exit ;; esac
echo -I/somewhere -lsomething -lGL
"""


def script(name, text):
    os.makedirs("bin", exist_ok=True)
    with open(f"bin/{name}", "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(f"bin/{name}", 0o755)


def prepare():
    for name in FOLDERS:
        os.symlink(os.path.join(ROOT, name), name)
    for name in make_files(ROOT):
        if not os.path.dirname(name):
            shutil.copy(os.path.join(ROOT, name), ".")
    script("fake-cc", COMPILER)
    script("fake-ar", ARCHIVER)
    script("fake-pkg-config", PKG_CONFIG)


def environment(**more):
    """As of a shell in which nothing about make was said."""
    kept = {k: v for k, v in os.environ.items() if not k.startswith("MAKE") and
            k not in ("MFLAGS", "BUILD", "CC", "CFLAGS", "CROSS", "F64", "F128", "DRM", "PNG", "CHAFA", "JSON", "ASSIMP", "OSMESA", "EGL", "V")}
    here = os.getcwd()
    return {**kept, "PATH": f"{here}/bin:{kept['PATH']}", "CALLS": f"{here}/calls", "ASKED": f"{here}/asked",
            "LACKING": "-", "MACHINE": "some-linux-gnu", "LC_ALL": "C", **more}


def make(*args, fails=False, **more):
    """What it prints, standard error included."""
    done = subprocess.run(["make", *args], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=environment(**more), timeout=LIMIT_S, text=True, check=False)
    check((done.returncode != 0) == fails, f"make {args} ended with {done.returncode}: {done.stdout[-300:]!r}")
    return done.stdout


def faked(*args, **more):
    return make("CC=fake-cc", "AR=fake-ar", "PKG_CONFIG=fake-pkg-config", *args, **more)


def calls(name="calls"):
    if not os.path.exists(name):
        return []
    with open(name, encoding="utf-8") as file:
        return [line for line in file.read().splitlines() if "-dumpmachine" not in line]
