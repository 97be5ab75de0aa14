"""The words of scene files, as the reader knows them: what the program scene_words prints, in sets."""
import os
import subprocess
from collections import namedtuple

# A word that can follow others: what stands before it ("light spot"); what it is: "numbers", "lengths", "whole",
# "spread", "vector", "colour", "flag", "name" or "file" for a field of that kind, "word" for one that chooses, "line"
# for the first word of a line in the block of a statement; the number of values, as far as the table has one.
Word = namedtuple("Word", "path word kind count needed")
NAMES = ("name", "file")
# The word after this one is a key of the keyboard: a letter, a digit or a word.
KEY = "key"
# Statements whose lines up to `end` are indented, and that which is not if its next word but one is this.
BLOCKS = ("group", "repeat", "union", "intersection", "difference", "grid", "mesh")
BLOCK_ELSEWHERE = "file"


class Words:
    """All words. `statements`: the first words of lines; `lines`: those in the blocks of meshes and grids;
    `properties`: all words that follow; `first_names`, `names`: statements and properties before a name or file."""

    def __init__(self, text):
        rows = [line.split("\t") for line in text.splitlines()]
        rows = [(path, word, *kind.split()) for path, word, kind in rows]
        named = [row for row in rows if row[1] == "-"]
        self.statements = [row[1] for row in rows if row[2] == "statement"]
        self.words = [Word(row[0], row[1], row[2], int(row[3]) if len(row) > 3 else 0, "needed" in row)
                      for row in rows if row[0] and row[1] != "-"]
        self.lines = once(word.word for word in self.words if word.kind == "line" and word.word not in self.statements)
        self.properties = once(word.word for word in self.words if word.kind != "line")
        self.first_names = once([row[0] for row in named if " " not in row[0]] + [KEY])
        self.names = once([row[0].split()[-1] for row in named if " " in row[0]] +
                          [word.word for word in self.words if word.kind in NAMES])
        self.first = self.statements + self.lines + [word.word for word in self.words if word.kind == "line" and
                                                     word.word not in self.statements + self.lines]

    def of(self, statement):
        """The words that can follow a statement, in all of its forms."""
        return [word for word in self.words if word.path.split()[0] == statement]


def once(words):
    return list(dict.fromkeys(words))


def read(build):
    return Words(subprocess.run([os.path.join(build, "tests", "scene_words")], check=True, capture_output=True,
                                text=True).stdout)
