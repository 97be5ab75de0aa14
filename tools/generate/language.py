#!/usr/bin/env python3
"""Generates the reference of scene files from its manual, man/tia-scene.5, and from the words that their reader knows.

language.py BUILD [FOLDER]        docs/language.md
language.py BUILD --page FOLDER   for the page: FOLDER/language.html, FOLDER/language.json, and FOLDER/language/*.png

language.json has "statements": for each word its lines, a help text, and its place in language.html, and "properties": for
each word a list of the statements that it can follow ("of"), with "kind" and "count" of its values, "needed", a help text
and a place. BUILD has tests/scene_words.
"""
import glob
import html
import json
import os
import re
import shutil
import sys
import textwrap

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mdoc  # noqa: E402
import words as scene_words  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
MANUAL = "man/tia-scene.5"
PICTURES = "docs/language"
LEFT_OUT = ("NAME", "SEE ALSO")
INTRO = "DESCRIPTION"
WIDTH = 120


def text_of(parts):
    return "".join(text for _, text in parts)


def slug(title):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


class Entry:
    """A heading of the reference: a section, or in it a statement in one of its forms or a field of many statements.
    `blocks`: what stands below it, as in mdoc.Page; `words`: those of the language in it."""

    def __init__(self, title, section, statements=(), heads=()):
        self.title, self.section, self.statements, self.heads = title, section, list(statements), list(heads)
        self.blocks, self.pictures = [], []

    @property
    def anchor(self):
        return slug(self.title)

    def lines(self):
        """All lines of parts."""
        yield from self.heads
        for kind, _, content in self.blocks:
            yield from content if kind == "item" else [content] if kind == "text" else []

    @property
    def words(self):
        return {text for parts in self.lines() for style, text in parts if style == "word" and not re.match(r"[-.\d]+$", text)}


def first_words(parts):
    return [text for style, text in parts if style == "word"]


def title_of(heads, words, used):
    """The heading of a statement's lines, or of a field's, and the words that it names. A statement's word alone stands
    above its first form, and the words that tell them apart above its others."""
    firsts = [first_words(head) for head in heads]
    choice = text_of(heads[0]).split()[1:2] == ["|"]
    if firsts[0][0] not in words.statements or choice:      # appears, vanishes; union | intersection | difference
        names = [word for word in firsts[0] if not choice or word in words.statements]
        return ", ".join(names), names
    names = scene_words.once(words_of[0] for words_of in firsts)
    if ", ".join(names) not in used:
        return ", ".join(names), names
    forms = {word.word for word in words.words if word.path == names[0] and word.kind == "word"}
    forms = [" ".join(words_of[:2]) for words_of in firsts if words_of[1:2] and words_of[1] in forms]
    return ", ".join(forms) or names[0] + " of materials", names


def entries(words):
    """The reference as a list of entries."""
    with open(os.path.join(ROOT, MANUAL), encoding="utf-8") as file:
        page = mdoc.Page(file.read())
    found, lists, used = [], 0, set()
    for kind, depth, content in page.blocks:
        if kind == "section":
            lists = 0
            found.append(Entry(content.capitalize() if content != INTRO else "The file", content))
        elif kind == "list":
            lists += depth == 1
            found[-1].blocks.append((kind, depth, content))
        elif kind == "item" and depth == 1 and lists == 1 and first_words(content[0])[:1] and \
                content[0][0][0] == "word" and set(first_words(content[0])) & set(words.statements + words.properties) and \
                found[-1].section not in MODELS:
            title, names = title_of(content, words, used)
            used.add(title)
            found.append(Entry(title, found[-1].section, [name for name in names if name in words.statements], content))
        else:
            if kind in ("text", "code") and depth == 0 and found[-1].heads:
                found.append(Entry("", found[-1].section))     # goes on below the section's list
            found[-1].blocks.append((kind, depth, content))
    found = [entry for entry in found if entry.section not in LEFT_OUT]
    add_pictures(found)
    return found


MODELS = ("THE NEUTRAL FILE FORMAT", "WAVEFRONT FILES", "OTHER MODELS READ BY TIA", "OTHER MODELS", "FILES", "DIAGNOSTICS")


def add_pictures(found):
    """Gives each entry its pictures: those of its name, and of its name and another word that no other entry has."""
    names = [os.path.basename(path)[:-4] for path in sorted(glob.glob(os.path.join(ROOT, PICTURES, "*.tia")))]
    for name in names:
        fits = [(len(part), -i) for i, entry in enumerate(found) if entry.heads for part in entry.title.split(", ")
                if name == slug(part) or name.startswith(slug(part) + "-")]
        if not fits:
            sys.exit(f"language.py: {PICTURES}/{name}.tia shows no statement")
        found[-max(fits)[1]].pictures.append(name)
    for entry in found:
        entry.pictures.sort(key=lambda name, e=entry: (e.title.split(", ").index(name) if name in e.title.split(", ") else 9,
                                                       len(name)))


def caption(name):
    with open(os.path.join(ROOT, PICTURES, name + ".tia"), encoding="utf-8") as file:
        return file.readline().lstrip("# ").rstrip()


class Places:
    """Where each word is described."""

    def __init__(self, found, words):
        self.found, self.words = found, words

    def statement(self, name):
        return next((entry for entry in self.found if name in entry.statements), None) or \
            next((entry for entry in self.found if name in entry.words and entry.section not in MODELS), None)

    def word(self, word):
        """The entry that describes a word that can follow others; None if there is none."""
        statement = word.path.split()[0]
        if word.path.startswith("key light"):
            statement = "light"
        own = [entry for entry in self.found if statement in entry.statements and word.word in entry.words]
        form = slug(word.path.removeprefix("key "))
        section = next((entry.section for entry in self.found if statement in entry.statements), None)
        return next((entry for entry in own if entry.anchor == form), None) or (own[0] if own else None) or \
            next((e for e in self.found if e.section == section and not e.statements and word.word in e.words), None) or \
            next((e for e in self.found if e.heads and not e.statements and word.word in first_words(e.heads[0])), None) or \
            next((e for e in self.found if e.section == INTRO and word.word in e.words), None)

    def anchor(self, entry):
        """The anchor of an entry, or of the section that an entry without a heading goes on."""
        return entry.anchor or next(e.anchor for e in self.found if e.section == entry.section)


# ---- Markdown ----

class Markdown:
    """Writes entries as a page of GitHub's Markdown."""

    def __init__(self, places):
        self.places, self.out = places, []

    def inline(self, parts):
        out = ""
        for style, text in parts:
            if style in ("word", "file", "code", "option"):
                out += f"`{text}`"
            elif style == "value":
                out += f"*{text}*"
            elif style == "section":
                out += f"[{text.capitalize()}](#{slug(text)})"
            elif style == "manual":
                out += f"`{text}`"
            else:
                out += re.sub(r"([*_<>\[\]|])", r"\\\1", text)
        return out

    def wrapped(self, text, indent=""):
        lines = textwrap.wrap(text, WIDTH - len(indent), break_long_words=False, break_on_hyphens=False)
        lines = [re.sub(r"^([-+#=])(?=\s)|^(\d+)(?=[.)]\s)", r"\\\g<0>", line) if i else line for i, line in enumerate(lines)]
        self.out.append("\n".join(indent + line for line in lines) + "\n")

    def block(self, block, base):
        """`base`: the number of lists around what stands directly below the heading."""
        kind, depth, content = block
        indent = "  " * max(depth - base, 0)
        if kind == "text":
            self.wrapped(self.inline(content), indent)
        elif kind == "code":
            self.out.append("\n".join([f"{indent}```text"] + [f"{indent}{line}".rstrip() for line in content] + [f"{indent}```"]) + "\n")
        elif kind == "item":
            heads = "; ".join(self.inline(head) for head in content)
            self.wrapped(f"- {heads}", indent[2:])
        elif kind == "bullet":
            self.out.append(indent[2:] + "-")

    def entry(self, entry):
        if entry.title:
            self.out.append(("### " if entry.heads else "## ") + entry.title + "\n")
        for head in entry.heads:
            self.wrapped(self.inline(head) + ("  " if head is not entry.heads[-1] else ""))
        if entry.pictures:
            self.out.append("\n".join(f"[![{caption(name)}](language/{name}.png)](language/{name}.tia)" for name in entry.pictures) + "\n")
        for block in entry.blocks:
            self.block(block, 1 if entry.heads else 0)

    def index(self, words):
        self.out.append("## Index of all words\n\nStatements are bold. Behind each word are the statements that it belongs to; each link "
                        "leads to its description.\n")
        for name, uses in index(words):
            own = self.places.statement(name) if name in words.statements else None
            head = f"**[`{name}`](#{self.places.anchor(own)})**" if own else f"`{name}`"
            links = [f"[{of}](#{self.places.anchor(entry)})" for of, entry in places_of(uses, self.places)]
            self.wrapped(f"- {head}" + (": " + ", ".join(links) if links else ""), "")
            self.out[-1] = self.out[-1].rstrip("\n").replace("\n", "\n  ")
        self.out.append("")

    def page(self, found, words):
        sections = [entry for entry in found if entry.title and not entry.heads]
        contents = " · ".join(f"[{entry.title}](#{entry.anchor})" for entry in sections)
        self.out.append(f"<!-- Written by tools/generate/language.py from {MANUAL}. -->\n# The language of scene files\n")
        self.wrapped("This is the manual page `tia-scene(5)` with pictures; a click on one shows its scene. " + contents +
                     " · [Index of all words](#index-of-all-words)")
        for entry in found:
            self.entry(entry)
        self.index(words)
        text = "\n".join(self.out)
        return re.sub(r"^(\s*)-\n\s*", r"\1- ", text, flags=re.M)


# ---- the index ----

def index(words):
    """(word, its uses) of all words in their order."""
    found = {name: [] for name in words.statements}
    for word in words.words:
        found.setdefault(word.word, []).append(word)
    return sorted(found.items(), key=lambda item: (item[0].lower(), item[0]))


def places_of(uses, places):
    """(statement, entry) once for each; a use without a place is in neither."""
    found = {}
    for use in uses:
        entry, of = places.word(use), use.path.split()[0]
        if entry and use.path.split()[0] != use.word:
            found.setdefault(of, entry)
    return found.items()


# ---- the page's help ----

class Html:
    """Writes entries as a page without scripts, whose style is tools/web/page/language.css."""

    def __init__(self, places):
        self.places, self.out = places, []

    def inline(self, parts):
        tags = {"word": "b", "value": "i", "file": "code", "code": "code", "option": "code", "manual": "cite"}
        out = ""
        for style, text in parts:
            if style == "section":
                out += f'<a href="#{slug(text)}">{html.escape(text.capitalize())}</a>'
            elif style in tags:
                out += f"<{tags[style]}>{html.escape(text)}</{tags[style]}>"
            else:
                out += html.escape(text)
        return out

    def lists(self, depth, now):
        """Opens or closes lists up to a depth."""
        self.out += ["</dd></dl>"] * max(now - depth, 0)
        return min(now, depth)

    def entry(self, entry):
        if entry.title:
            level = "h3" if entry.heads else "h2"
            self.out.append(f'<{level} id="{entry.anchor}">{html.escape(entry.title)}</{level}>')
        for head in entry.heads:
            self.out.append(f'<p class="line">{self.inline(head)}</p>')
        for name in entry.pictures:
            self.out.append(f'<img src="language/{name}.png" width="160" height="120" loading="lazy" alt="{html.escape(caption(name))}">')
        base, now = 1 if entry.heads else 0, 0
        for kind, depth, content in entry.blocks:
            now = self.lists(depth - base, now)
            if kind == "text":
                self.out.append(f"<p>{self.inline(content)}</p>")
            elif kind == "code":
                self.out.append(f"<pre>{html.escape(chr(10).join(content))}</pre>")
            elif kind in ("item", "bullet"):
                opening = "</dd>" if now == depth - base else "<dl>"
                now = depth - base
                heads = "".join(f"<dt>{self.inline(head)}</dt>" for head in (content or [[]]))
                self.out.append(f"{opening}{heads}<dd>")
        self.lists(0, now)

    def page(self, found, words):
        self.out.append('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>The language of scene files</title>\n'
                        '<meta name="viewport" content="width=device-width">\n<meta name="color-scheme" content="light dark">\n'
                        '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; style-src \'self\'; img-src \'self\' data:; '
                        'base-uri \'none\'; form-action \'none\'">\n'
                        '<link rel="icon" href="data:,">\n<link rel="stylesheet" href="colours.css">\n<link rel="stylesheet" href="language.css">\n</head>\n<body>\n<h1>The language of scene files</h1>')
        for entry in found:
            self.entry(entry)
        self.out.append('<h2 id="index-of-all-words">Index of all words</h2>\n<dl>')
        for name, uses in index(words):
            own = self.places.statement(name) if name in words.statements else None
            links = ([("statement", own)] if own else []) + list(places_of(uses, self.places))
            self.out.append(f"<dt>{html.escape(name)}</dt><dd>" + ", ".join(
                f'<a href="#{self.places.anchor(entry)}">{of}</a>' for of, entry in links) + "</dd>")
        return "\n".join(self.out) + "\n</dl>\n</body>\n</html>\n"


MARK = "\0"        # before a word of the language, while sentences are chosen


def sentence(lines, word=None):
    """The first sentence of some lines of parts, or the first one with the word, or else with its letters."""
    text = " ".join("".join(MARK + text if style == "word" else text for style, text in parts) for parts in lines)
    sentences = re.split(r"(?<=\.) (?=\S)", text)
    ends = r"(?![\w-])"
    for start in (MARK, r"(?<![\w-])") if word else ():
        fits = [found for found in sentences if re.search(start + re.escape(word) + ends, found)]
        if fits:
            return fits[0].replace(MARK, "")
    return sentences[0].replace(MARK, "")


def help_of(entry, word=None):
    """A short text about an entry, or about a word in it: of that word's item, if there is one."""
    lines = [content for kind, _, content in entry.blocks if kind == "text"]
    for at, (kind, _, content) in enumerate(entry.blocks):
        if word and kind == "item" and word in [w for head in content for w in first_words(head)]:
            lines = [next((c for k, _, c in entry.blocks[at + 1:] if k == "text"), content[0])]
            return sentence(lines)
    return sentence(lines, word) if lines else " / ".join(text_of(head) for head in entry.heads)


def for_editor(words, places):
    """The page's help, by word."""
    def place(entry):
        return f"language.html#{places.anchor(entry)}"

    statements, properties = {}, {}
    for name in words.statements:
        entry = places.statement(name)
        lines = [text_of(head) for e in places.found if name in e.statements for head in e.heads if name in first_words(head)]
        statements[name] = {"lines": lines, "help": help_of(entry), "place": place(entry)}
    for word in words.words:
        entry = places.word(word)
        if not entry:
            sys.exit(f"language.py: {MANUAL} does not describe {word.word} of {word.path}")
        row = {"of": word.path, "kind": word.kind, "count": word.count, "needed": word.needed,
               "help": help_of(entry, word.word), "place": place(entry)}
        properties.setdefault(word.word, []).append(row)
    return {"statements": statements, "properties": properties}


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    words = scene_words.read(sys.argv[1])
    found = entries(words)
    places = Places(found, words)
    if sys.argv[2:3] == ["--page"]:
        folder = sys.argv[3]
        write(os.path.join(folder, "language.html"), Html(places).page(found, words))
        write(os.path.join(folder, "language.json"), json.dumps(for_editor(words, places), separators=(",", ":")) + "\n")
        os.makedirs(os.path.join(folder, "language"), exist_ok=True)
        for name in [name for entry in found for name in entry.pictures]:
            shutil.copy(os.path.join(ROOT, PICTURES, name + ".png"), os.path.join(folder, "language"))
    else:
        write(os.path.join(*sys.argv[2:3] or [ROOT], "docs/language.md"), Markdown(places).page(found, words))


if __name__ == "__main__":
    main()
