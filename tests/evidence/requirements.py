"""requirements.py - requirements.txt: sentences that the documents state, and the tests that fail without them."""
import os
import re

import mutants

FILE = "tests/evidence/requirements.txt"


class Requirement:
    """A sentence of a document, its tests, as (program, cases), its scripts, and the mutants that break it."""

    def __init__(self, document, sentence):
        self.document, self.sentence = document, sentence
        self.tests, self.scripts, self.mutants = [], [], []


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def requirements(text):
    found, document = [], None
    for line in text.splitlines():
        if not line or line.startswith("#"):
            continue
        if not line.startswith(" "):
            document = line
        elif not line.startswith("    "):
            found.append(Requirement(document, line.strip()))
        else:
            word, rest = line.split(None, 1)
            if word == "test":
                program, cases = rest.split(": ", 1)
                found[-1].tests.append((program, cases.split(", ")))
            elif word in ("script", "mutant"):
                getattr(found[-1], word + "s").append(rest)
            else:
                raise ValueError(f"{FILE}: {line.strip()!r} is no line of a requirement")
    return found


def plain(text):
    """Words alone: without line breaks, the asterisks of comments, and what Markdown uses for code."""
    return " ".join(re.sub(r"^\s*(/\*|\*|>)|`", " ", text, flags=re.M).split())


def faults_of(requirement, documents, every):
    """What of a requirement is not there: its sentence, a test, a case, or a mutant."""
    if plain(requirement.sentence) not in documents(requirement.document):
        yield "is no sentence of " + requirement.document
    if not requirement.tests and not requirement.scripts:
        yield "has no test"
    for program, cases in requirement.tests:
        path = f"tests/test_{program}.c"
        if not os.path.exists(path):
            yield f"there is no {path}"
            continue
        text = read(path)
        for case in cases:
            if not re.search(rf"\b(RUN|RUN_LONG)\({case}\)", text):
                yield f"{path} runs no {case}"
    for script in requirement.scripts:
        if not os.path.exists("tests/" + script):
            yield f"there is no tests/{script}"
    for name in requirement.mutants:
        if name not in every:
            yield f"there is no mutant {name!r}"


def faults(wanted=None):
    """What is wrong in requirements.txt, as lines."""
    texts, every = {}, {mutant.what for room in mutants.rooms() for mutant in room.mutants}

    def document(path):
        return texts.setdefault(path, plain(read(path)) if os.path.exists(path) else "")

    return [f"{requirement.sentence[:60]}...: {fault}" for requirement in wanted or requirements(read(FILE))
            for fault in faults_of(requirement, document, every)]


def table():
    """The requirements as a table in Markdown."""
    lines = ["| requirement | tests | slips that they must notice |", "|---|---|---|"]
    for requirement in requirements(read(FILE)):
        tests = [f"test_{program}: {', '.join(cases)}" for program, cases in requirement.tests] + requirement.scripts
        sentence = requirement.sentence.replace("|", "\\|")
        lines.append(f"| {sentence} ({requirement.document}) | {'; '.join(tests)} | {'; '.join(requirement.mutants) or '-'} |")
    return lines
