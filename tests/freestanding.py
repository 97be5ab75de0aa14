"""freestanding.py - what object files of the core may and may not contain, read with nm and objdump.

Used by tests/quick/freestanding (the host's own objects) and tests/slow/freestanding (the core
compiled for processors without an FPU).
"""
import os
import re
import subprocess

# What a compiler may call for integers: copies, and libgcc's arithmetic.
ALLOWED = re.compile(
    r"(memcpy|memset|memmove|__aeabi_(mem\w+|u?idiv(mod)?|u?ldivmod|lmul|ll[sa][lr]|llsr|lasr|lcmp|ulcmp)"
    r"|__(u?div|u?mod|mul|ashl|ashr|lshr|clz|ctz|popcount|cmp|ucmp|neg|bswap)[sdt]i\d?|__udivmoddi4"
    r"|__clz_tab|__gnu_thumb1_case_\w+|_GLOBAL_OFFSET_TABLE_)$")
# Where every instruction of a unit is forbidden, its registers are.
FLOATING = {
    # Vector moves and integer vectors are how compilers copy and add quickly; arithmetic on floats is not.
    "x86": r":\t(v?(add|sub|mul|div|sqrt|min|max|cmp\w*|u?comi|rcp|rsqrt|round|cvt\w*|f?n?m(add|sub)\d*|hadd|hsub|dp)"
           r"(ss|sd|ps|pd)|v?cvt\w+|f[a-z]\w*)\b",
    "x86 general registers": r"%[xyz]mm\d|%st\b|%mm\d|:\tf[a-z]\w*\b",
    "arm": r":\tv(?!mrs|msr)[a-z]+(\.\w+)*\s|\bs\d+,|\bd\d+,",
    "aarch64": r":\t(f[a-z]+|[su]cvtf)\b",
    "riscv": r":\tf(?!ence)[a-z]",
}
MACHINES = {"x86_64": "x86", "i686": "x86", "i386": "x86", "arm": "arm", "aarch64": "aarch64", "riscv": "riscv"}


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def undefined(prefix, objects):
    """Symbols that the objects together leave to others, but for what ALLOWED takes."""
    wanted, defined = set(), set()
    for line in run(prefix + "nm", "-P", *objects).splitlines():
        parts = line.split()
        if len(parts) >= 2 and not line.endswith(":"):
            (wanted if parts[1] in "Uw" else defined).add(parts[0])
    return sorted(name for name in wanted - defined if not ALLOWED.match(name))


def writable(prefix, objects):
    """Sections of writable data that are not empty. Relocated constants, .data.rel.ro, are not written later."""
    found = []
    for line in run(prefix + "objdump", "-h", *objects).splitlines():
        match = re.match(r"\s*\d+ (\.(?:data|bss|tdata|tbss|sdata|sbss)\S*)\s+([0-9a-f]+)", line)
        if match and int(match.group(2), 16) and not match.group(1).startswith(".data.rel.ro"):
            found.append(match.group(1))
        if re.match(r"\s*\d+ (\.init_array|\.ctors)", line):
            found.append("constructors")
    return found


def floating(prefix, objects, unit):
    """Instructions on floats: "function: instruction"."""
    pattern, function, found = re.compile(FLOATING[unit]), "?", []
    for line in run(prefix + "objdump", "-d", "--no-show-raw-insn", *objects).splitlines():
        match = re.match(r"[0-9a-f]+ <(\S+)>:", line)
        if match:
            function = match.group(1)
        elif re.match(r"\s*[0-9a-f]+:\t", line) and pattern.search(re.sub(r"[<#;].*", "", line)):
            found.append(f"{function}: {' '.join(line.split(':', 1)[1].split())}")
    return found


def unprefixed(prefix, objects):
    """Global symbols that could meet another's of the same name in a program: those without tia_."""
    lines = (line.split() for line in run(prefix + "nm", "-P", "--defined-only", "--extern-only", *objects).splitlines())
    return sorted({words[0] for words in lines if len(words) >= 2 and not words[0].startswith("tia_")})


def report(case, faults, what):
    more = f" (and {len(faults) - 1} more)" if len(faults) > 1 else ""
    print(f"FAIL {case}: {what}: {faults[0]}{more}" if faults else f"ok {case}")


def check(name, prefix, objects, unit):
    """The properties that object files show."""
    report(f"{name}: global symbols begin with tia_", unprefixed(prefix, objects), "there is")
    report(f"{name}: no foreign symbols", undefined(prefix, objects), "undefined")
    report(f"{name}: no writable data", writable(prefix, objects), "in")
    if unit:
        report(f"{name}: no floating point", floating(prefix, objects, unit), "in")


class Calls:
    """The call graph with every function's own stack, from gcc's -fcallgraph-info=su."""

    def __init__(self, folder):
        self.stack, self.calls, self.unbounded = {}, {}, []
        for name in sorted(os.listdir(folder)):
            if name.endswith(".ci"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    self.add(file.read())

    def add(self, text):
        for title, label in re.findall(r'node: \{ title: "([^"]+)" label: "([^"]*)"', text):
            bytes_ = re.search(r"(\d+) bytes \((\w[^)]*)\)", label)
            if bytes_:
                self.stack[title] = int(bytes_.group(1))
                if bytes_.group(2) not in ("static", "dynamic,bounded"):
                    self.unbounded.append(title)
        for caller, called in re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', text):
            self.calls.setdefault(caller, set()).add(called)

    def depth(self, function, indirect, path=(), known=None):
        """(bytes, the deepest chain). `indirect` tells what a function's calls through pointers may reach; `known` has
        the depths found so far."""
        known = {} if known is None else known
        if function in path:
            raise ValueError("recursion: " + " > ".join(path[path.index(function):] + (function,)))
        if function in known:
            return known[function]
        called = self.calls.get(function, set())
        if "__indirect_call" in called:
            called = called - {"__indirect_call"} | set(indirect(function))
        best = (0, ())
        for other in sorted(called):
            best = max(best, self.depth(other, indirect, path + (function,), known), key=lambda d: d[0])
        known[function] = self.stack.get(function, 0) + best[0], (function.split(":")[-1],) + best[1]
        return known[function]
