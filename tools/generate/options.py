#!/usr/bin/env python3
"""Generates files from the commands' tables of options, as printed by --help all: the completions of bash, zsh and fish in
package/complete/, and the headings of the options in man/.

options.py BUILD [FOLDER]: BUILD has the commands; FOLDER gets package/complete/ and man/, by default the source tree.
"""
import os
import re
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
COMMANDS = ("tia", "tia-compare", "tia-compile", "tia-join", "tia-pov", "tia-observe", "tia-radio", "tia-verify")
SCENES = ("tia", "nff", "obj", "stl", "ply", "off", "pgm")
PARTS = ("tiapart",)
PICTURES = ("png", "ppm", "bmp", "565", "pfm", "exr", "y4m", "tiapart", "record")
ROW = re.compile(r"^  (?:-(?P<letter>\w),|   ) --(?P<name>[\w-]+)(?: (?P<argument>\S+))?(?:  +(?P<text>.*))?$")


class Option:
    """A row of --help: its letter or None, its name, its argument or None, its text, the words that its value may be, and
    those that shells complete, of help the themes."""

    def __init__(self, letter, name, argument, text):
        self.letter, self.name, self.argument, self.text = letter, name, argument, text
        self.is_file = bool(argument) and argument.startswith("FILE")
        self.words = words(argument) if argument and "|" in argument else []

    @property
    def completed(self):
        themes = self.text.split(" of a theme: ")[1:] if self.name == "help" else []
        return re.split(", | or ", themes[0]) if themes else self.words

    def brief(self):
        return re.split(r"; | \(", self.text)[0]


def words(argument):
    """Returns the words of an argument that are not placeholders: a and b= for "a|b=X|C"."""
    found = [re.sub("=[A-Z]+$", "=", word) for word in re.sub(r"\[.*?\]", "", argument).split("|")]
    return [word for word in found if not re.search("[A-Z]", word)]


def options(text):
    """Returns the options in the text of --help. A line that is indented more than a row continues the row's text."""
    found = []
    for line in text.splitlines():
        match = ROW.match(line)
        if match:
            found.append(Option(match["letter"], match["name"], match["argument"], match["text"] or ""))
        elif found and line.startswith("         "):
            found[-1].text = f"{found[-1].text} {line.strip()}".strip()
    return found


# ---- manuals ----

def mdoc(argument):
    """Converts an argument to mdoc: capitals are values, brackets enclose optional parts."""
    out, joined = [], False
    for token in re.findall(r"[A-Z][A-Z0-9]*|[|\[\]]|[^A-Z|\[\]]+", argument):
        if joined and token not in "|]":
            out.append("Ns")
        joined = token not in "|["
        out.append({"|": "|", "[": "Oo", "]": "Oc"}.get(token) or
                   (f"Ar {token.lower()}" if token.isupper() else f"Cm {'' if token[0].isalnum() else '&'}{token}"))
    return " ".join(out).replace("&", "\\&")


def mdoc_heading(option):
    letter = f"Fl {option.letter} , " if option.letter else ""
    return f".It {letter}Fl -{option.name}" + (f" {mdoc(option.argument)}" if option.argument else "")


def man_heading(option):
    letter = f"\\-{option.letter}\\fR, \\fB" if option.letter else ""
    argument = re.sub("[A-Z]+", r"\\fI\g<0>\\fB", option.argument or "")
    return f".B {letter}\\-\\-{option.name.replace('-', chr(92) + '-')} {argument}".rstrip()


def manual(name, text, found):
    """Returns the page with new headings of its options. It must have all of them, in the table's order."""
    lines, names = text.split("\n"), []
    is_mdoc = text.startswith(".Dd")
    for number, line in enumerate(lines):
        match = re.match(r"\.It Fl.*?Fl -([\w-]+)|\.It Fl -([\w-]+)", line) if is_mdoc else \
            re.match(r"\.BR? .*?\\-\\-([a-z\\-]+)", line) if number and lines[number - 1] == ".TP" else None
        if not match:
            continue
        names.append((match[1] or match[2]).replace("\\", ""))
        option = next((option for option in found if option.name == names[-1]), None)
        if option:
            lines[number] = mdoc_heading(option) if is_mdoc else man_heading(option)
    if names != [option.name for option in found]:
        wrong = next((pair for pair in zip(names + [""], [option.name for option in found] + [""]) if pair[0] != pair[1]))
        sys.exit(f"man/{name}.1: its option --{wrong[0]} stands where the table has --{wrong[1]}")
    return "\n".join(lines)


# ---- completions ----

def bash(commands):
    lines = ["# tia.bash - written by tools/generate/options.py.", "", "_tia() {",
             "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} words= ends=",
             "    # Words of one option are split at a colon and an equals sign.",
             "    case $prev in [:=]) COMPREPLY=(); return ;; esac",
             "    case ${1##*/} in"]
    for name, found in commands:
        lines.append(f"    {name})")
        lines.append("        case $prev in")
        for option in found:
            if not option.argument:
                continue
            names = "|".join(([f"-{option.letter}"] if option.letter else []) + [f"--{option.name}"])
            then = "compopt -o default; COMPREPLY=()" if option.is_file else \
                f"mapfile -t COMPREPLY < <(compgen -W '{' '.join(option.completed)}' -- \"$cur\")" if option.completed else "COMPREPLY=()"
            if any(word.endswith("=") for word in option.words):
                then += "; compopt -o nospace"
            lines.append(f"        {names}) {then}; return ;;")
        every = " ".join(f"--{option.name}" for option in found)
        lines += ["        esac", f"        words='{every}' ends='{' '.join(arguments(name))}' ;;"]
    lines += ["    esac",
              "    if [[ $cur == -* ]]; then mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\"); return; fi",
              "    # Folders, and files of the right kind.",
              "    local IFS=$'\\n' end",
              "    compopt -o filenames",
              "    COMPREPLY=($(compgen -d -- \"$cur\"))",
              "    for end in ${ends// /$IFS}; do COMPREPLY+=($(compgen -f -X \"!*.$end\" -- \"$cur\")); done",
              "}", f"complete -F _tia {' '.join(name for name, _ in commands)}", ""]
    return "\n".join(lines)


def arguments(name):
    return PARTS if name == "tia-join" else (*PICTURES, *SCENES) if name == "tia-verify" else SCENES


def quoted(text):
    return text.replace("'", "'\\''")


def zsh(commands):
    lines = [f"#compdef {' '.join(name for name, _ in commands)}",
             "# _tia - written by tools/generate/options.py.", "", "case $service in"]
    for name, found in commands:
        lines.append(f"{name})")
        lines.append("    _arguments -s \\")
        for option in found:
            what = re.sub(r"([\[\]:])", r"\\\1", quoted(option.brief()))
            value = "" if not option.argument else ":file:_files" if option.is_file else \
                f":value:({' '.join(option.completed)})" if option.completed else ":value: "
            value = f":{value}" if value and option.name == "help" else value
            names = f"(-{option.letter} --{option.name})'{{-{option.letter},--{option.name}}}'" if option.letter else f"--{option.name}"
            lines.append(f"        '{names}[{what}]{value}' \\")
        lines.append(f"        '*:file:_files -g \"*.({'|'.join(arguments(name))})\"' ;;")
    return "\n".join(lines + ["esac", ""])


def fish(commands):
    lines = ["# tia.fish - written by tools/generate/options.py.", ""]
    for name, found in commands:
        ends = arguments(name)
        lines.append(f"complete -c {name} -f -a '({'; '.join(f'__fish_complete_suffix .{end}' for end in ends)})'")
        for option in found:
            value = "" if not option.argument else " -r -F" if option.is_file else \
                f" -x -a '{' '.join(option.completed)}'" if option.completed else " -x"
            letter = f" -s {option.letter}" if option.letter else ""
            lines.append(f"complete -c {name}{letter} -l {option.name}{value} -d '{quoted(option.brief())}'".replace("'\\''", "\\'"))
    return "\n".join(lines + [""])


def write(folder, name, text):
    os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
    with open(os.path.join(folder, name), "w", encoding="utf-8") as out:
        out.write(text)


def main():
    build, folder = sys.argv[1], (sys.argv[2:] + [ROOT])[0]
    commands = []
    for name in COMMANDS:
        said = subprocess.run([os.path.join(build, name), "--help", "all"], capture_output=True, text=True, check=True).stdout
        commands.append((name, options(said)))
    for file, completed in (("tia.bash", bash), ("_tia", zsh), ("tia.fish", fish)):
        write(folder, f"package/complete/{file}", completed(commands))
    for name, found in commands:
        with open(os.path.join(ROOT, f"man/{name}.1"), encoding="utf-8") as page:
            text = page.read()
        write(folder, f"man/{name}.1", manual(name, text, found))


if __name__ == "__main__":
    main()
