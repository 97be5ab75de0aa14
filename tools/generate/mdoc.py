"""Reads the part of mdoc that tia's manuals use.

A page is a list of blocks, (kind, depth, content) each:

    section   the title
    item      of a list with tags: [heads], each a line of parts; items without text between them are one
    bullet    ""
    text      a line of parts
    code      lines
    list      "tag" or "bullet": a list begins

A line of parts is a list of (style, text): "text" with its blanks, "word" (.Cm), "value" (.Ar), "file" (.Pa),
"code" (.Li, .Ql), "option" (.Fl), "section" (.Sx), "manual" (.Xr). `depth` is the number of lists around the block.
"""
import re
import shlex

STYLES = {"Cm": "word", "Ar": "value", "Pa": "file", "Li": "code", "Ql": "code", "Fl": "option", "Nm": "word", "Em": "value"}
BRACKETS = {"Oo": ("[", ""), "Oc": ("", "]"), "Bro": ("{", ""), "Brc": ("", "}"), "Xo": ("", ""), "Xc": ("", "")}
TO_END = {"Op": ("[", "]"), "Pq": ("(", ")")}
CLOSING = (".", ",", ":", ";", ")", "]", "?", "!")
ESCAPES = {r"\-": "-", r"\e": "\\", r"\(mu": "×", r"\(+-": "±", r"\(S2": "²", r"\&": ""}


def plain(text):
    return re.sub(r"\\\(..|\\.", lambda match: ESCAPES[match[0]], text)


class Line:
    """Parts with the blanks between them."""

    def __init__(self):
        self.parts, self.glued = [], True

    def add(self, style, text, blank=True):
        if not self.glued and blank and text not in CLOSING:
            self.parts.append(("text", " "))
        self.glued = False
        self.parts.append((style, text))

    def glue(self):
        self.glued = True

    def macro(self, words):
        """Adds what a line of macros and their arguments says."""
        style, ends, joined = None, [], None
        while words:
            word = words.pop(0)
            if word in STYLES:
                style = STYLES[word]
                if style == "option" and (not words or words[0] in CLOSING):
                    self.add(style, "-")
            elif word in ("Sx", "Xr"):
                joined = "section" if word == "Sx" else "manual"
                taken = []
                while words and words[0] not in CLOSING and words[0] not in STYLES:
                    taken.append(words.pop(0))
                self.add(joined, " ".join(taken) if word == "Sx" else f"{taken[0]}({taken[1]})")
            elif word == "Ns":
                self.glue()
            elif word in BRACKETS:
                before, after = BRACKETS[word]
                if before:
                    self.add("text", before)
                    self.glue()
                elif after:
                    self.glue()
                    self.add("text", after)
                style = None
            elif word in TO_END:
                self.add("text", TO_END[word][0])
                self.glue()
                ends.append(TO_END[word][1])
            else:
                self.word(style, plain(word))
        for end in reversed(ends):
            self.glue()
            self.add("text", end)

    def word(self, style, word):
        if word in CLOSING:
            self.add("text", word)
        elif style is None or not re.search(r"\w", word):
            self.add("text", word)
            if word == "(":
                self.glue()
        else:
            self.add(style, "-" + word if style == "option" else word)


def words_of(line):
    return shlex.split(line) if '"' in line else line.split()


class Page:
    """Reads a page; `blocks` are described above."""

    def __init__(self, source):
        self.blocks, self.lists, self.line, self.code, self.head = [], [], None, None, None
        for line in source.split("\n"):
            if self.code is not None and line != ".Ed":
                self.code.append(plain(line))
            elif line.startswith("."):
                self.macro(*(line[1:].split(" ", 1) + [""])[:2])
            elif line:
                self.open().add("text", plain(line))
        self.flush()

    def open(self):
        self.line = self.line or Line()
        return self.line

    def flush(self):
        if self.line:
            self.blocks.append(("text", len(self.lists), self.line.parts))
        self.line = None

    def macro(self, name, rest):
        if self.head is not None:
            return self.more_head(name, rest)
        if name in ("Dd", "Dt", "Os", '\\"'):
            return None
        handler = getattr(self, "on_" + name, None)
        if handler:
            self.flush()
            return handler(rest)
        if name == "Nd":
            self.open().add("text", "- " + plain(rest))
        else:
            self.open().macro([name] + words_of(rest))
        return None

    def on_Sh(self, rest):
        self.blocks.append(("section", 0, plain(rest)))

    def on_Pp(self, _):
        pass

    def on_Bl(self, rest):
        self.lists.append("tag" if rest.startswith("-tag") else "bullet")
        self.blocks.append(("list", len(self.lists), self.lists[-1]))

    def on_El(self, _):
        self.lists.pop()

    def on_Bd(self, _):
        self.code = []

    def on_Ed(self, _):
        self.blocks.append(("code", len(self.lists), self.code))
        self.code = None

    def on_Dl(self, rest):
        self.blocks.append(("code", len(self.lists), [plain(rest)]))

    def on_It(self, rest):
        if self.lists[-1] == "bullet":
            self.blocks.append(("bullet", len(self.lists), ""))
            return
        line, words = Line(), words_of(rest)
        if words[:1] == ["Xo"]:
            self.head = line
        line.macro(words)
        if self.head is None:
            self.put_head(line)

    def more_head(self, name, rest):
        if name == "Xc":
            line, self.head = self.head, None
            self.put_head(line)
        else:
            self.head.macro([name] + words_of(rest))

    def put_head(self, line):
        last = self.blocks[-1]
        if last[0] == "item" and last[1] == len(self.lists):
            last[2].append(line.parts)
        else:
            self.blocks.append(("item", len(self.lists), [line.parts]))
