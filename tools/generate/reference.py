#!/usr/bin/env python3
"""Writes the library's manual pages of section 3 from include/tia/*.h: a page for each header; and for each function and object
in libtia.map a page that refers to its header's page.

reference.py FOLDER
"""
import glob
import os
import re
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
COMMENT = re.compile(r"/\*.*?\*/", re.S)
# Parts of a header that its page leaves out: the guard, includes, and lines for C++ only.
FRAME = re.compile(r"^#ifdef __cplusplus\n.*?^#endif\n|^#ifndef TIA_\w+_H\n#define TIA_\w+_H\n|^#include [^\n]*\n|^#endif\n*\Z",
                   re.S | re.M)
FUNCTION = re.compile(r"^(?P<type>[a-z][\w ]*?[ *]+)(?P<name>tia_\w+)\((?P<arguments>[^;]*)\);$")
OBJECT = re.compile(r"^extern (?P<type>[\w ]*?[ *]+)(?P<name>tia_\w+);$")
MACRO = re.compile(r"^#.*(?:\\\n.*)*\n?", re.M)
FORWARD = re.compile(r"(struct tia_\w+;\s*)+")
HEADING = re.compile(r"^---- (.*) ----$")


class Item:
    """A comment and the code below it; either may be empty."""

    def __init__(self, comment, code, heading):
        self.comment, self.code, self.heading = comment, code, heading
        self.declared = list(declarations(code))


def page_of(header):
    name = os.path.basename(header).removesuffix(".h")
    return name if name == "tia" else "tia_" + name


# ---- reading a header ----

def stripped(comment):
    """Returns the lines of a comment without its delimiters. Indentation within the comment is kept."""
    lines = comment.removeprefix("/*").removesuffix("*/").split("\n")
    return [lines[0].strip()] + [re.sub(r"^ \* ?", "", line).rstrip() for line in lines[1:]]


def blocks(text):
    """Splits a header, without changing the text, into comments at the left margin, code up to an empty line or such a comment,
    and empty lines."""
    while text:
        block = re.match(r"/\*.*?\*/\n?|\n+", text, re.S)
        end = block.end() if block else end_of_code(text)
        yield text[:end].rstrip("\n")
        text = text[end:]


def end_of_code(text):
    """Returns the offset of the first line, outside braces and comments, that is empty or begins a comment."""
    depth = 0
    for line in re.finditer(r"(?:/\*.*?\*/|[^\n])*\n?", text, re.S):
        if depth == 0 and line.start() > 0 and re.match(r"\n|/\*|\Z", text[line.start():]):
            return line.start()
        code = COMMENT.sub("", line[0])
        depth += code.count("{") - code.count("}")
    return len(text)


def items(text):
    """Yields the header's items in order. An empty line separates a comment from the code below it."""
    comment, heading = [], None
    for block in [*blocks(text), ""]:
        if block.startswith("/*"):
            comment = stripped(block)
            continue
        title = HEADING.match(comment[0]) if comment else None
        heading = title[1] if title else heading
        if (block or comment) and not title and (comment or not FORWARD.fullmatch(block + "\n")):
            yield Item(comment, block, heading)
        comment = []


def statements(code):
    """Yields the declarations outside braces, each as one line."""
    code = COMMENT.sub("", MACRO.sub("", code))
    for statement in re.findall(r"[^;{}]*(?:\{(?:[^{}]|\{[^{}]*\})*\})?[^;{}]*;", code):
        yield re.sub(r"\s+", " ", statement).strip()


def declarations(code):
    for statement in statements(code):
        found = FUNCTION.match(statement) or OBJECT.match(statement)
        if found:
            yield found


def arguments(found):
    """Returns a function's arguments as written. A comma within brackets does not separate arguments."""
    return [a.strip() for a in re.split(r",(?![^()]*\))", found["arguments"])]


# ---- writing mdoc ----

ESCAPES = {"\\": "\\e", "^": "\\(ha", "~": "\\(ti", "`": "\\(ga", "'": "\\(aq"}


def escaped(text):
    text = re.sub(r"[\\^~`']", lambda found: ESCAPES[found[0]], text)
    return re.sub(r"(?<![A-Za-z])-|-(?![A-Za-z])", r"\\-", text)


def quoted(text):
    return '"' + escaped(text).replace('"', '""') + '"'


def line_of(text):
    """Returns a line of text that roff does not take for a request."""
    return ("\\&" if text[:1] in (".", "'") else "") + text


def literal(lines, *more):
    return [" ".join((".Bd -literal", *more)), *(line_of(escaped(line)) for line in lines), ".Ed"]


def code_lines(code):
    """Returns the lines of the code, with a single space before the backslashes of macros."""
    return re.sub(r" +\\\n", " \\\\\n", code).split("\n")


def prose(text):
    """Formats a line of a paragraph: names in backquotes are in italics, and not hyphenated."""
    parts = re.split(r"`(\w+)`", text)
    return line_of("".join(f"\\fI\\%{escaped(p)}\\fR" if i % 2 else escaped(p) for i, p in enumerate(parts)))


def kind_of(line, before):
    """Returns the kind of a line: "text", "item" of a list, "table", which is kept as it is, or "" between paragraphs."""
    if not line:
        return ""
    if re.match(r" +- ", line):
        return "item"
    if before == "item":
        return before
    return "table" if line.startswith("  ") else "text"


def paragraphs(lines):
    """Yields (kind, lines) for each run of lines of one kind."""
    before, run = "", []
    for line in [*lines, ""]:
        kind = kind_of(line, before)
        if kind != before and run:
            yield before, run
            run = []
        before = kind
        run = run + [line] if kind else []


def bullets(lines):
    out = [".Bl -bullet -compact"]
    for line in lines:
        if re.match(r" +- ", line):
            out.append(".It")
        out.append(prose(re.sub(r"^ +(- )?", "", line)))
    return out + [".El"]


def text_of(comment):
    """Formats a comment as paragraphs, lists and tables; the first paragraph has no space before it."""
    out = []
    for kind, lines in paragraphs(comment):
        if kind == "table":
            indent = min(len(line) - len(line.lstrip()) for line in lines)
            out += literal([line[indent:] for line in lines], "-offset indent")
        elif kind == "item":
            out += bullets(lines)
        else:
            out += ([".Pp"] if out else []) + [prose(line) for line in lines]
    return out


def headings(found):
    """Yields each item with its heading, or None if the previous item had the same."""
    last = None
    for item in found:
        yield item, item.heading if item.heading != last else None
        last = item.heading


def described_types(found):
    out = []
    for item, heading in headings(found):
        out += [f".Ss {escaped(heading)}"] if heading else [".Pp"] if out else []
        out += text_of(item.comment)
        if item.code:
            out += literal(code_lines(item.code))
    return [".Sh TYPES AND CONSTANTS", *out] if out else []


def tag(found):
    if "arguments" in found.re.groupindex:
        return " ".join((".It Fn", found["name"], *map(quoted, arguments(found))))
    return f".It Va {found['name']}"


def beside(code):
    """Returns the comments behind declarations of objects, by the objects' names."""
    return dict(re.findall(r"^extern [^;]*?(tia_\w+); *(/\*.*?\*/)$", code, re.M))


def described_function(item):
    """Formats an item's declarations one after the other. Its comment follows the last of them; the comment behind a
    declaration follows that one."""
    out, said = [], beside(item.code)
    for found in item.declared:
        out.append(tag(found))
        if found["name"] in said:
            out += text_of(stripped(said[found["name"]]))
    out += text_of(item.comment)
    macros = MACRO.findall(item.code)
    return out + (literal([m.rstrip("\n") for m in macros]) if macros else [])


def described_functions(found):
    out = []
    for item, heading in headings(found):
        if heading:
            out += ([".El"] if out else []) + [f".Ss {escaped(heading)}"]
        if heading or not out:
            out.append(".Bl -tag -width Ds")
        out += described_function(item) if item.declared else [".Pp", *text_of(item.comment)]
    return [".Sh FUNCTIONS", *out, ".El"] if out else []


def synopsis(header, found):
    out = [".Sh SYNOPSIS", f".In tia/{header}"]
    for one in found:
        if "arguments" in one.re.groupindex:
            out += [f".Ft {quoted(one['type'].strip())}", f".Fo {one['name']}", *(f".Fa {quoted(a)}" for a in arguments(one)), ".Fc"]
        else:
            out.append(f".Vt {quoted('extern ' + one['type'] + one['name'])} ;")
    return out


def see_also(header, includes):
    """Returns the section SEE ALSO: the headers that this one includes or that include it; all headers for tia.h."""
    name = page_of(header)
    pages = {page_of(h) for h in includes} if name == "tia" else \
        {page_of(h) for h, text in includes.items() if f"<tia/{os.path.basename(header)}>" in text} | \
        {page_of(h) for h in includes if f"<tia/{os.path.basename(h)}>" in includes[header]} | {"tia"}
    others = ["tia 1", *(f"{page} 3" for page in sorted(pages - {name})), "tia-scene 5"]
    return [".Sh SEE ALSO", *(f".Xr {page} ," for page in others[:-1]), f".Xr {others[-1]}"]


def page(header, texts, version, date):
    """Returns the page, and the names that it describes."""
    text = texts[header]
    intro = stripped(COMMENT.match(text)[0])
    name, title = re.match(r"(\w+\.h) - (.*)", intro[0]).groups()
    end = intro.index("") if "" in intro else len(intro)
    first = " ".join([title, *intro[1:end]])
    short = re.split(r": |; |\.(?: (?=[A-Z])|$)", first, maxsplit=1)[0]
    parts = sections(items(FRAME.sub("", text[COMMENT.match(text).end():]).lstrip("\n")))
    declared = [d for item in parts[1] for d in item.declared]
    names = list(dict.fromkeys([page_of(header), *(d["name"] for d in declared)]))
    # A title with more than the short description also begins the section DESCRIPTION.
    whole = [first[:1].upper() + first[1:]] if first.rstrip(".") != short else []
    description = text_of([*whole, *intro[end if whole else end + 1:]])
    out = ["." + "\\\" Written by tools/generate/reference.py from include/tia/" + name, f".Dd {date}",
           f".Dt {page_of(header).upper()} 3", f".Os tia {version}", ".Sh NAME",
           *(f".Nm {n} ," for n in names[:-1]), f".Nm {names[-1]}", f".Nd {escaped(short)}",
           *synopsis(name, declared), *([".Sh DESCRIPTION", *description] if description else []),
           *described_types(parts[0]), *described_functions(parts[1]), *see_also(header, texts)]
    return "\n".join(out) + "\n", names


def sections(found):
    """Divides the items into types and functions. A comment that stands alone belongs to the item before it."""
    parts, last = ([], []), 0
    for item in found:
        last = (1 if item.declared else 0) if item.code else last
        parts[last].append(item)
    return parts


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def write(folder, name, text):
    with open(os.path.join(folder, name + ".3"), "w", encoding="utf-8") as file:
        file.write(text)


def main(folder):
    texts = {path: read(path) for path in sorted(glob.glob(os.path.join(ROOT, "include/tia/*.h")))}
    version = re.search(r'TIA_VERSION "(.*)"', read("include/tia/tia.h"))[1]
    date = re.search(r"^\.Dd (.*)", read("man/tia.1"), re.M)[1]
    os.makedirs(folder, exist_ok=True)
    where = {}
    for header in texts:
        text, names = page(header, texts, version, date)
        write(folder, names[0], text)
        where.update({name: names[0] for name in names})
    radio = sorted(name for name in where if name.startswith("tia_radio_"))      # belongs to a static library of its own
    for name in re.findall(r"^ +(tia_\w+);", read("libtia.map"), re.M) + radio:
        if name not in where:
            sys.exit(f"reference.py: libtia.map lists {name}, which no header declares")
        if name != where[name]:
            write(folder, name, f".so man3/{where[name]}.3\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip().splitlines()[-1])
    main(sys.argv[1])
