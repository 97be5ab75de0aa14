#!/usr/bin/env python3
"""Writes the library as two files that compile as C11 and as C++20: tia.h has all public headers, tia.c the whole core in
integer arithmetic. They need no other file.

amalgamation.py FOLDER SOURCE...

SOURCE are the core's files, as `make` compiles them, those that are compiled for speed first. A header's text stands where it
is first included. Of num.h's
arithmetics only the integers are included. If several files define the same name for themselves, each gets its file's name
as a suffix. Constructs that C++ spells differently become macros, TIA_CXX_..., which expand to the original text in C.
"""
import os
import re
import sys
from collections import Counter

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
INCLUDE = re.compile(r'#\s*include\s+(?:"([^"]+)"|<([^>]+)>|(\w+))')
# Macros of other builds: other arithmetics, and the tests' instrumented ones.
ABSENT = re.compile(r"TIA_NUM_F64|TIA_NUM_F32|TIA_NUM_F128|TIA_NUM_CHK|TIA_WATCHED|BOUND_SCALES")
TOKEN = re.compile(r'/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[A-Za-z_]\w*|\.?\d[\w.]*|->|[^\w\s]|\s+', re.S)
# Keywords of C++ that are names in C.
KEYWORDS = {"class", "this", "new", "delete", "template", "operator", "private", "public", "typename", "namespace", "try", "catch",
            "throw", "using", "virtual", "friend", "and", "or", "not", "xor", "explicit", "mutable", "export"}
TAG = "struct "

HEADER_TOP = """/* tia.h - all of include/tia/ in one file, for tia.c beside it. Written by `make amalgamation`; do not change it. */
"""
SOURCE_TOP = """/* tia.c - all of the core, in integers, in one file; tia.h is its interface. Written by `make amalgamation` from
 * the files that are named below; do not change it.
 *
 *   cc -std=c11 -O2 -c tia.c        or        c++ -std=c++20 -O2 -c -x c++ tia.c
 *
 * It needs no operating system and of the C library no more than memcpy, memset and the like. A linker that drops what
 * nothing refers to (-ffunction-sections -Wl,--gc-sections) keeps what a program uses.
 */
/* tia_config.h, if there is one, has options such as TIA_CHUNK. */
#if defined(__has_include)
#if __has_include("tia_config.h")
#include "tia_config.h"
#endif
#endif
#include "tia.h"

/* A function that this file happens not to use. */
#if defined(__GNUC__)
#define TIA_UNUSED __attribute__((unused))
#else
#define TIA_UNUSED
#endif

#ifdef __cplusplus
/* C's {0}, of which C++ asks for all the members. */
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define restrict __restrict
#define _Static_assert static_assert
#define TIA_CXX_OF(tag) tia_cxx_type<struct tag>
#define TIA_CXX_AT(tag, ...) tia_cxx_at(tia_cxx_type<struct tag> __VA_ARGS__)
#define TIA_CXX_INDEX(index)
#define TIA_CXX_OPEN 1
#define TIA_CXX_FROM(pointer) tia_cxx_from(pointer)

/* A function may have the name of a structure. */
template <class T> using tia_cxx_type = T;

/* A pointer to void becomes one to whatever is asked for, as in C. */
struct tia_cxx_pointer {
    const void *p;
    template <class T> operator T *() const { return static_cast<T *>(const_cast<void *>(p)); }
};
inline tia_cxx_pointer tia_cxx_from(void *p) { return {p}; }
inline tia_cxx_pointer tia_cxx_from(const void *p) { return {p}; }
template <class T> inline T tia_cxx_from(T value) { return value; }

/* The address of a value that lives until the statement ends. */
template <class T> inline T *tia_cxx_at(T &&value) { return &value; }

extern "C" {
#else
#define TIA_CXX_OF(tag) (struct tag)
#define TIA_CXX_AT(tag, ...) (&(struct tag)__VA_ARGS__)
#define TIA_CXX_INDEX(index) [index] =
#define TIA_CXX_OPEN
#define TIA_CXX_FROM(pointer) (pointer)
#endif
"""
FAST = "src/math/fast.h"
FAST_END = """/* The rest is compiled as the build asks. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif
"""
SOURCE_END = """
#ifdef __cplusplus
}
#endif
"""


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


# ---- conditions and includes ----

def chosen(text):
    """Returns the text of this build: lines that test the macros in ABSENT are removed, and so are the branches that are not
    built."""
    kept, inside = [], []  # inside: for each open condition None if it stays, else whether its present branch is built
    for line in text.split("\n"):
        word = re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b(.*)", line)
        if word and word[1].startswith("if"):
            names = set(re.findall(r"[A-Za-z_]\w*", word[2])) - {"defined"}
            ours = names and all(ABSENT.fullmatch(n) for n in names)
            inside.append(word[1] == "ifndef" if ours else None)
            if ours:
                continue
        elif word and inside[-1] is not None:
            if word[1] == "endif":
                inside.pop()
            else:
                inside[-1] = word[1] == "else" or not ABSENT.search(word[2])
            continue
        elif word and word[1] == "endif":
            inside.pop()
        if all(state is None or state for state in inside):
            kept.append(line)
    return "\n".join(kept)


def found(name, beside):
    """Returns the path, relative to ROOT, of the file that #include "name" in the file `beside` refers to."""
    for folder in (os.path.dirname(beside), "src"):
        path = os.path.normpath(os.path.join(folder, name))
        if os.path.exists(os.path.join(ROOT, path)):
            return path
    raise SystemExit(f"amalgamation: {beside} includes {name}, which is not there")


class Library:
    """The text of tia.c or of tia.h as a list of parts: (file, lines)."""

    def __init__(self):
        self.seen, self.system, self.parts = set(), set(), []

    def add(self, path, within=None):
        """Adds a file, unless it has been added already. A header without a guard is a part of the file `within` that includes
        it."""
        text = chosen(read(path))
        if re.search(r"^#ifndef \w+_H$", text, re.M) or not within:
            within = path
            if path in self.seen:
                return
            self.seen.add(path)
        lines = []
        for line in text.split("\n"):
            include = INCLUDE.match(line)
            if not include:
                lines.append(line)
                continue
            self.put(within, lines)
            lines = []
            self.include(path, within, include)
        self.put(within, lines)

    def include(self, path, within, include):
        name, public, macro = include[1], include[2], include[3]
        if macro:
            raise SystemExit(f"amalgamation: {path} includes what {macro} stands for")
        if name:
            self.add(found(name, path), within)
        elif public.startswith("tia/"):
            self.add_public(public)
        elif public not in self.system:
            self.system.add(public)
            self.put(within, [include[0]])

    def add_public(self, name):
        """Does nothing: tia.c includes the public headers by tia.h."""

    def put(self, path, lines):
        if any(line.strip() for line in lines):
            self.parts.append((path, "\n".join(lines).strip("\n") + "\n"))


class Header(Library):
    def add_public(self, name):
        self.add("include/" + name)


# ---- names ----

def tokens(text):
    return TOKEN.findall(text)


def own_names(text):
    """Returns the names that a file defines at file scope: static functions and objects, types, constants of enumerations; and
    the tags of structures, unions and enumerations, with TAG in front."""
    code = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    code = re.sub(r"^#.*(?:\\\n.*)*", "", code, flags=re.M)
    names = set(re.findall(r"^static [^;={(]*?\b(\w+)(?:\[[^;=]*)?\s*[(;=]", code, re.M))
    names |= set(re.findall(r"^\} (\w+)(?:\[\w*\])* = ", code, re.M))
    names |= {TAG + name for name in re.findall(r"^(?:struct|union|enum) (\w+) \{", code, re.M)}
    names |= set(re.findall(r"^typedef [^;]*?\b(\w+);", code, re.M))
    for body in re.findall(r"\benum(?: \w+)? \{(.*?)\}", code, re.S):
        names |= set(re.findall(r"(?:^|,)\s*([A-Za-z_]\w*)", body))
    return names - {"inline"} - set(macros_of(text)) - {"FORM"}


def members(text):
    """Returns the offsets of members' names in the definitions of structures and unions."""
    places = set()
    for body in re.finditer(r"\b(?:struct|union)(?: \w+)? (?=\{)", text):
        start, end = body.end(), closing(text, body.end())
        places |= {m.start(1) for m in re.compile(r"\b(\w+)(?=[;,\[:])|(?<=\*)(\w+)(?=\))").finditer(text, start, end) if m[1]}
        places |= {m.start(1) for m in re.compile(r"\(\*(\w+)\)").finditer(text, start, end)}
    return places


def renamed(text, names):
    """Appends to each of the names its suffix, names[name]. Names of members stay: those behind . or ->, and in definitions of
    structures."""
    before, out, at, spared = "", [], 0, members(text)
    for token in tokens(text):
        key = TAG + token if before in ("struct", "union", "enum") else token
        own = key in names and before not in (".", "->") and at not in spared
        out.append(token + names[key] if own else token)
        at += len(token)
        if token.strip() and not token.startswith("/*"):
            before = token
    return "".join(out)


def suffix_of(path, paths):
    """Returns a suffix made from the file's name; and from its folder's name, if several files have the same name."""
    stem = os.path.basename(path)[:-2]
    same = [p for p in paths if os.path.basename(p)[:-2] == stem]
    folder = os.path.basename(os.path.dirname(path))
    return "_in_" + (stem if len(same) == 1 else f"{folder}_{stem}").replace("-", "_")


def included(path, whole, known):
    """Returns the file and all files that it includes, directly or not."""
    if path not in known:
        known[path] = {path}
        for include in filter(None, map(INCLUDE.match, whole.get(path, "").split("\n"))):
            if include[1]:
                known[path] |= included(found(include[1], path), whole, known)
    return known[path]


def distinct(parts):
    """Returns the parts with distinct names. A name that several files define gets its file's suffix, in the file itself and in
    those that include it."""
    whole = {}
    for path, text in parts:
        whole[path] = whole.get(path, "") + text
    originals = {path: chosen(read(path)) for path in whole}
    own = {path: own_names(text) for path, text in whole.items()}
    owners = Counter(name for names in own.values() for name in names)
    owners.update(own_names(header()))
    known = {}
    for path, text in parts:
        clash = {}
        for other in sorted(included(path, originals, known) & whole.keys()):
            clash |= {n: suffix_of(other, [p for p in whole if p[-2:] == other[-2:]]) for n in own[other] if owners[n] > 1}
        yield path, renamed(text, clash) if clash else text


# ---- constructs that differ in C++ ----

def closing(text, start):
    """Returns the index behind the bracket that closes the one at `start`."""
    depth = 0
    for match in TOKEN.finditer(text, start):
        depth += (match[0] in "([{") - (match[0] in ")]}")
        if depth == 0:
            return match.end()
    raise SystemExit("amalgamation: a bracket stays open")


def literals(text):
    """Converts compound literals, their addresses, and designators of array elements to macros."""
    while match := re.search(r"&\((?:const )?struct (\w+)\)(?=\{)", text):
        end = closing(text, match.end())
        text = f"{text[:match.start()]}TIA_CXX_AT({match[1]}, {text[match.end():end]}){text[end:]}"
    text = re.sub(r"\(struct (\w+|FORM\(\w+\))\)(?=[\s\\]*\{)", r"TIA_CXX_OF(\1)", text)
    return re.sub(r"(?<=[{,\s])\[(\w+)\] = ", r"TIA_CXX_INDEX(\1) ", text)


def void_names(text):
    """Returns the names of functions and members of type void *, and the names of parameters of that type."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    lasting = set(re.findall(r"^(?:static )?(?:inline )?(?:const )?void \*(\w+)\(|^ +(?:const )?void \*(\w+);|\bvoid \*\(\*(\w+)\)", text, re.M))
    return {name for names in lasting for name in names if name}, set(re.findall(r"\bvoid \*(?:const |restrict )?(\w+)(?=[,)])", text))


def from_void(text, names):
    """Puts TIA_CXX_FROM around each value of type void * that is assigned, returned or passed on: C++ does not convert it
    implicitly."""
    chain = r"(?:[A-Za-z_]\w*(?:->|\.))*([A-Za-z_]\w*)"
    begin = rf"(?<![=!<>]) = \{{?|\breturn |(?<=\w)\(|, |\? "
    out, at = [], 0
    for match in re.finditer(rf"(?:{begin})(?=(\(void \*\)[({{\w])|{chain}(\(|[;,}})]))", text):
        name, after = match[2], match[3]
        passed = match[0][-1] in "(?" or match[0] == ", "
        if match.start() < at or not (match[1] or name in names) or (passed and after != ")" and after != ","
                                                                    and match[0] != "? "):
            continue
        start = match.end()
        end = end_of_value(text, start)
        out.append(f"{text[at:start]}TIA_CXX_FROM({text[start:end]})")
        at = end
    return "".join(out) + text[at:]


def end_of_value(text, start):
    depth = 0
    for match in TOKEN.finditer(text, start):
        if depth == 0 and match[0] in (",", ";", "}", ")", ":"):
            return match.start()
        depth += (match[0] in "([{") - (match[0] in ")]}")
    raise SystemExit("amalgamation: a value has no end")


def for_cxx(text, void):
    text = from_void(literals(text), void | void_names(text)[1])
    text = re.sub(r"^( +struct \w+ \w+)\[\];", r"\1[TIA_CXX_OPEN];", text, flags=re.M)
    text = re.sub(r"\bstatic inline\b", "TIA_UNUSED static inline", text)
    return "".join(token + "_" if token in KEYWORDS else token for token in tokens(text))


# ---- the files ----

def macros_of(text):
    return re.findall(r"^#\s*define (\w+)", text, re.M)


def header():
    library = Header()
    for name in ("tia", "raster", "denoise", "tone", "radio", "trust", "damage", "fit", "step", "debug", "spelling"):
        library.add(f"include/tia/{name}.h")
    return HEADER_TOP + "".join("\n" + text for _, text in library.parts)


def is_fast(path):
    return '#include "math/fast.h"' in read(path)


def source(files):
    """Files whose code is fast come first: so the functions of headers are as fast there as in a build of many files."""
    library = Library()
    library.seen |= {os.path.join("include/tia", n) for n in os.listdir(os.path.join(ROOT, "include/tia"))}
    library.system |= {"stdint.h", "stddef.h", "stdbool.h"}
    for path in filter(is_fast, files):
        library.add(path)
    library.put(FAST, [FAST_END])
    for path in files:
        library.add(path)
    parts = list(distinct(library.parts))
    void = set().union(*(void_names(text)[0] for _, text in parts)) | void_names(header())[0]
    out, last, defined = [SOURCE_TOP], None, []
    for path, text in parts + [(None, "")]:
        if path is None or (path.endswith(".c") and path != last):
            out += [f"#undef {name}\n" for name in dict.fromkeys(defined)]
            defined = []
        if path is None:
            break
        if path != last:
            out.append(f"\n/* ---- {path} ---- */\n")
        if path.endswith(".c"):
            defined += macros_of(text)
        out.append(for_cxx(text, void))
        last = path
    return "".join(out) + SOURCE_END


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(re.sub(r"\n{3,}", "\n\n", text))
    os.replace(path + ".new", path)


def main():
    if len(sys.argv) < 3:
        raise SystemExit("usage: amalgamation.py FOLDER SOURCE...")
    os.makedirs(sys.argv[1], exist_ok=True)
    write(sys.argv[1], "tia.h", header())
    write(sys.argv[1], "tia.c", source(sys.argv[2:]))


main()
