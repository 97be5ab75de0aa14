"""mutants.py - reads tests/mutants/*.txt and makes the mutants that they describe. tests/mutants/README.md has the format."""
import glob
import os
import re

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutants")
TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|\.?\d(?:[eEpP][-+]|[\w.])*|\w+|->|<<=|>>=|<<|>>|<=|>=|==|!='
                   r'|&&|\|\||\+\+|--|[-+*/%&|^]=|\S')
COMMENT = re.compile(r"/\*.*?\*/", re.S)


class Wrong(Exception):
    """A mutant that cannot be made, or a line that cannot be read."""


class Mutant:
    """One slip: its name, its file, and either texts (old, new) or an operator on a function."""

    def __init__(self, room, path, what):
        self.room, self.path, self.what = room, path, what
        self.old, self.new, self.operator = [], [], None

    def mutated(self, text):
        """Returns the source with this slip in it."""
        if self.operator:
            return operate(text, *self.operator)
        old = "\n".join(self.old)
        if text.count(old) != 1:
            raise Wrong(f"{self.path} has {old!r} {text.count(old)} times, not once")
        return text.replace(old, "\n".join(self.new))


class Room:
    """A file of mutants, and the tests that are expected to notice them."""

    def __init__(self, path):
        self.name, self.tests, self.mutants = os.path.splitext(os.path.basename(path))[0], [], []
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file.read().splitlines(), 1):
                try:
                    self.add(line)
                except (Wrong, IndexError) as why:
                    raise Wrong(f"{path}:{number}: {why or 'there is no mutant before it'}") from None
        for mutant in self.mutants:
            if not mutant.operator and not mutant.old:
                raise Wrong(f"{path}: {mutant.what}: nothing is changed")

    def add(self, line):
        """Reads a line. Its indentation decides: a file or the tests, the name of a mutant, or a part of one."""
        if not line or line.startswith("#"):
            return
        if line.startswith("tests: "):
            self.tests += line.split()[1:]
        elif not line.startswith(" "):
            self.path = line
        elif line.startswith("    -") or line.startswith("    +"):
            getattr(self.mutants[-1], "old" if line[4] == "-" else "new").append(line[6:])
        elif line.startswith("    "):
            self.mutants[-1].operator = read_operator(line.strip())
        else:
            self.mutants.append(Mutant(self.name, self.path, line.strip()))


def rooms():
    return [Room(path) for path in sorted(glob.glob(os.path.join(FOLDER, "*.txt")))]


# ---- operators: changes of the n-th place of its kind in a function or macro ----

OPERATOR = re.compile(r"(\w+): (?:(drop) (operand|\w+)|(condition|choice|return|call \w+|.+?) becomes (.+?))(?: \((\d+) of (\d+)\))?")


def read_operator(line):
    match = OPERATOR.fullmatch(line)
    if not match:
        raise Wrong(f"{line!r} is no operator")
    name, drop, dropped, changed, new, which, count = match.groups()
    return name, f"drop {dropped}" if drop else changed, new or ";", int(which or 1), int(count or 1)


def function(text, name):
    """Returns the start and end of a function or macro, from its name to the end of its body."""
    found = []
    for start in re.finditer(rf"^#define {name}\b.*(?:\\\n.*)*", text, re.M):
        found.append((start.start() + len("#define "), start.end()))
    for start in re.finditer(rf"^(?![\s#*/]).*\b{name}\(", text, re.M):
        body = re.compile(r"[^;{}]*?(?:\n\{\n.*?^\}|;)", re.M | re.S).match(text, start.end())
        if body and body[0].endswith("}"):
            found.append((start.start(), body.end()))
    if len(found) != 1:
        raise Wrong(f"{name} is there {len(found)} times, not once")
    return found[0]


def tokens(text, start, end):
    """Returns (token, from, to) of each token, without comments."""
    blank = COMMENT.sub(lambda match: " " * len(match[0]), text[start:end])
    return [(match[0], start + match.start(), start + match.end()) for match in TOKEN.finditer(blank)]


def closing(found, at):
    """Returns the index of the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(found)):
        depth += (found[i][0] in "([{") - (found[i][0] in ")]}")
        if depth == 0:
            return i
    raise Wrong("brackets do not close")


def statements_of(found, name):
    """Yields (from, to) of statements that begin with a call of `name` or change it."""
    for i, (token, _, _) in enumerate(found):
        if i and token == name and found[i - 1][0] in (";", "{", "}", ")", "else") and found[i + 1][0] in "(=+-*&|.->[":
            end = i
            while end < len(found) and found[end][0] not in ";{":
                end = closing(found, end) + 1 if found[end][0] in "([" else end + 1
            if end < len(found) and found[end][0] == ";":
                yield found[i][1], found[end][2]


def conditions(found):
    for i, (token, _, _) in enumerate(found):
        if token in ("if", "while") and found[i + 1][0] == "(":
            yield found[i + 1][2], found[closing(found, i + 1)][1]


def expression_end(found, at, stops):
    """Returns the index of the token after the expression that begins at `at`."""
    while at < len(found) and found[at][0] not in stops and found[at][0] not in (",", ";", ")", "]", "}"):
        at = closing(found, at) + 1 if found[at][0] in "([{" else at + 1
    return at


def expression_start(found, at):
    depth = 0
    while at > 0:
        token = found[at - 1][0]
        depth += (token in ")]}") - (token in "([{")
        if depth < 0 or depth == 0 and token in (",", ";", "=", "{", "}", "return", "?", ":", "+=", "&=", "|="):
            break
        at -= 1
    return at


def operands(found):
    """Yields (from, to) of each && or || with its right operand."""
    for i, (token, start, _) in enumerate(found):
        if token in ("&&", "||"):
            stops = ("||", "?", ":") + (("&&",) if token == "&&" else ())
            yield start, found[expression_end(found, i + 1, stops) - 1][2]


def choices(found):
    """Yields, for each ?:, (from, to) of the whole, of its first value and of its second."""
    for i, (token, _, _) in enumerate(found):
        if token == "?":
            middle = i
            depth = 0
            while depth or found[middle][0] != ":":
                depth += (found[middle + 1][0] == "?") - (found[middle][0] == ":")
                middle += 1
                if found[middle][0] in "([{":
                    middle = closing(found, middle)
            end = expression_end(found, middle + 1, (":",)) - 1
            yield (found[expression_start(found, i)][1], found[end][2]), (found[i + 1][1], found[middle - 1][2]), \
                (found[middle + 1][1], found[end][2])


def returns(found):
    for i, (token, _, _) in enumerate(found):
        if token == "return":
            yield found[i + 1][1], found[expression_end(found, i + 1, ()) - 1][2]


def calls(found, name):
    for i, (token, start, _) in enumerate(found[:-1]):
        if i and token == name and found[i + 1][0] == "(":
            yield start, found[closing(found, i + 1)][2]


def sequences(found, wanted):
    names = [token for token, _, _ in found]
    for i in range(len(names) - len(wanted) + 1):
        if names[i:i + len(wanted)] == wanted:
            yield found[i][1], found[i + len(wanted) - 1][2]


def places_of(found, what):
    if what == "condition":
        return list(conditions(found))
    if what == "return":
        return list(returns(found))
    if what == "drop operand":
        return list(operands(found))
    if what.startswith("drop "):
        return list(statements_of(found, what[len("drop "):]))
    if what.startswith("call "):
        return list(calls(found, what[len("call "):]))
    return list(sequences(found, TOKEN.findall(what)))


def operate(text, name, what, new, which, count):
    """Changes place `which` of `count` in the function. Another count is an error: the function has changed."""
    found = tokens(text, *function(text, name))
    values = list(choices(found)) if what == "choice" else []
    places = [whole for whole, _, _ in values] or places_of(found, what)
    if len(places) != count:
        raise Wrong(f"{name}: {what} is there {len(places)} times, not {count}")
    start, end = places[which - 1]
    if new in ("its first", "its second"):
        first, second = values[which - 1][1 + (new == "its second")]
        new = text[first:second]
    elif new == "its opposite":
        new = f"!({text[start:end]})"
    elif what == "drop operand":
        new = ""
    return text[:start] + new + text[end:]
