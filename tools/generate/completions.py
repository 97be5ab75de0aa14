#!/usr/bin/env python3
"""Writes what bash, zsh and fish complete, package/complete/, from what the commands' --help says.

completions.py BUILD [FOLDER]: BUILD has the commands; FOLDER is package/complete unless given.
"""
import os
import re
import subprocess
import sys

COMMANDS = ("tia", "tia-compare", "tia-compile", "tia-join", "tia-pov", "tia-observe", "tia-radio")
SCENES = ("tia", "nff", "obj")
PARTS = ("tiapart",)
OPTION = re.compile(r"^ +(?:-(?P<short>\w), )?--(?P<long>[\w-]+)(?: (?P<value>\S*[^\s,]))?(?:, -\w, --[\w-]+)?(?:  +(?P<what>.*))?$")
CHOICE = r"[\w.=-]+"


class Option:
    """One option: its names, what it says, and how its value is completed: None (it has none), "file" or words."""

    def __init__(self, short, long, value, what):
        self.short, self.long, self.what = short, long, re.sub(r"[;,]$", "", what)
        self.value = None if value is None else "file" if value.startswith("FILE") else words(value, what)


def words(value, what):
    """The words that a value can be, as far as --help lists them."""
    given = [word for word in value.split("|") if not re.search(r"[A-Z]", word)]
    plain = re.sub(r" \([^)]*\)", "", what).split(": ")[-1]
    listed = re.match(rf"({CHOICE}, )*{CHOICE} or {CHOICE}", plain) or \
        value == "FORMAT" and re.match(rf"({CHOICE},? )+{CHOICE}(?=,)", plain)
    if listed:
        found = re.findall(CHOICE, listed[0].replace(" or ", " "))
        found = [word for word in found if not re.search(r"[A-Z]", word.split("=")[0])]
        given += [word + "=" for word in found] if "KIND=" in value else [re.sub("=[A-Z]+$", "=", word) for word in found]
    return given


def options(text):
    found = []
    for line in text.splitlines():
        match = OPTION.match(line)
        if match:
            found.append(Option(match["short"], match["long"], match["value"], match["what"] or ""))
            if re.search(r"--help, -V, --version", line):
                found.append(Option("V", "version", None, ""))
    return found


def spoken(command, text):
    return {"h": f"what {command} can be told", "V": "its version"}.get(text.short, text.what)


def bash(commands):
    lines = ["# tia.bash - written by tools/generate/completions.py from what --help says.", "", "_tia() {",
             "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} words= ends=",
             "    # Words of one option are split at a colon and an equals sign.",
             "    case $prev in [:=]) COMPREPLY=(); return ;; esac",
             "    case ${1##*/} in"]
    for name, found in commands:
        lines.append(f"    {name})")
        lines.append("        case $prev in")
        for option in found:
            if option.value is None:
                continue
            names = "|".join(([f"-{option.short}"] if option.short else []) + [f"--{option.long}"])
            then = "compopt -o default; COMPREPLY=()" if option.value == "file" else \
                f"mapfile -t COMPREPLY < <(compgen -W '{' '.join(option.value)}' -- \"$cur\")"
            if option.value != "file" and any(word.endswith("=") for word in option.value):
                then += "; compopt -o nospace"
            lines.append(f"        {names}) {then}; return ;;")
        every = " ".join(f"--{option.long}" for option in found)
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
    return PARTS if name == "tia-join" else SCENES


def quoted(text):
    return text.replace("'", "'\\''")


def zsh(commands):
    lines = [f"#compdef {' '.join(name for name, _ in commands)}",
             "# _tia - written by tools/generate/completions.py from what --help says.", "", "case $service in"]
    for name, found in commands:
        lines.append(f"{name})")
        lines.append("    _arguments -s \\")
        for option in found:
            what = re.sub(r"([\[\]:])", r"\\\1", quoted(spoken(name, option)))
            value = "" if option.value is None else ":file:_files" if option.value == "file" else \
                f":value:({' '.join(option.value)})" if option.value else ":value: "
            names = f"(-{option.short} --{option.long})'{{-{option.short},--{option.long}}}'" if option.short else f"--{option.long}"
            lines.append(f"        '{names}[{what}]{value}' \\")
        lines.append(f"        '*:file:_files -g \"*.({'|'.join(arguments(name))})\"' ;;")
    return "\n".join(lines + ["esac", ""])


def fish(commands):
    lines = ["# tia.fish - written by tools/generate/completions.py from what --help says.", ""]
    for name, found in commands:
        ends = arguments(name)
        lines.append(f"complete -c {name} -f -a '({'; '.join(f'__fish_complete_suffix .{end}' for end in ends)})'")
        for option in found:
            value = "" if option.value is None else " -r -F" if option.value == "file" else \
                f" -x -a '{' '.join(option.value)}'" if option.value else " -x"
            short = f" -s {option.short}" if option.short else ""
            lines.append(f"complete -c {name}{short} -l {option.long}{value} -d '{quoted(spoken(name, option))}'".replace("'\\''", "\\'"))
    return "\n".join(lines + [""])


def main():
    build, folder = sys.argv[1], (sys.argv[2:] + ["package/complete"])[0]
    commands = []
    for name in COMMANDS:
        said = subprocess.run([os.path.join(build, name), "--help"], capture_output=True, text=True, check=True).stdout
        commands.append((name, options(said)))
    for file, write in (("tia.bash", bash), ("_tia", zsh), ("tia.fish", fish)):
        with open(os.path.join(folder, file), "w", encoding="utf-8") as out:
            out.write(write(commands))


if __name__ == "__main__":
    main()
