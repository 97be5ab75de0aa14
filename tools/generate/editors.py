#!/usr/bin/env python3
"""Generates the files in package/editors/ that colour scene files in vim, nano, Visual Studio Code, GtkSourceView and
Pygments, from the words that the reader of scene files knows.

editors.py BUILD [FOLDER]: BUILD has tests/scene_words; FOLDER gets package/editors/, by default the source tree.

All of them tell apart: the first word of a line that is a statement, and one in the block of a mesh or grid; properties;
numbers, times among them, and the corners of faces; names of numbers; names of all else, and of files; comments.
"""
import json
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import manifests  # noqa: E402
import words as scene_words  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
MADE = "written by tools/generate/editors.py"
# Expressions that Python, Oniguruma and PCRE read alike.
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?:?|\d+(?:/\d*){1,2}"
CONSTANT = r"-?[A-Z]\S*"


def any_of(words):
    return "|".join(sorted(words, key=lambda word: (-len(word), word)))


# ---- vim ----

VIM_SYNTAX = r'''" Vim syntax file of scenes for tia, tia-scene(5); @MADE@.
if exists("b:current_syntax")
  finish
endif
let s:save = &cpo
set cpo&vim

syn match tiaProperty "\S\@1<!\%(@PROPERTIES@\)\S\@!"
syn match tiaProperty "\S\@1<!\%(@NAMES@\)\S\@!" nextgroup=tiaString,tiaName skipwhite
syn match tiaNumber "\S\@1<![-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%([eE][-+]\=\d\+\)\=:\=\S\@!"
syn match tiaNumber "\S\@1<!\d\+\%(/\d*\)\{1,2}\S\@!"
syn match tiaConstant "\S\@1<!-\=\u\S*"
" The first word of a line, but not of one that continues another.
syn match tiaStatement "\%(^\s*\)\@<=\%(\\\n\s*\)\@<!\%(@FIRST@\)\S\@!"
syn match tiaStatement "\%(^\s*\)\@<=\%(\\\n\s*\)\@<!\%(@FIRST_NAMES@\)\S\@!" nextgroup=tiaString,tiaName skipwhite
syn match tiaName "[^#[:space:]]\S*" contained
syn match tiaString "\"[^\"]*\"" contained
syn match tiaComment "\S\@1<!#.*" contains=@Spell

hi def link tiaStatement Statement
hi def link tiaProperty Type
hi def link tiaNumber Number
hi def link tiaConstant Constant
hi def link tiaName Identifier
hi def link tiaString String
hi def link tiaComment Comment

let b:current_syntax = "tia"
let &cpo = s:save
unlet s:save
'''

VIM_DETECT = '''" Scenes for tia; @MADE@.
au BufRead,BufNewFile *.tia setfiletype tia
'''

VIM_PLUGIN = '''" Vim file type plug-in of scenes for tia; @MADE@.
if exists("b:did_ftplugin")
  finish
endif
let b:did_ftplugin = 1
setlocal commentstring=#\\ %s comments=:# formatoptions-=t
setlocal iskeyword+=-
" The words that CTRL-X CTRL-O completes are those of the syntax file.
setlocal omnifunc=syntaxcomplete#Complete
silent! compiler tia
let b:undo_ftplugin = "setlocal commentstring< comments< formatoptions< iskeyword< omnifunc<"
'''

VIM_INDENT = r'''" Vim indent file of scenes for tia: blocks up to "end"; @MADE@.
if exists("b:did_indent")
  finish
endif
let b:did_indent = 1
setlocal indentexpr=TiaIndent() indentkeys=!^F,o,O,=end
let b:undo_indent = "setlocal indentexpr< indentkeys<"

if exists("*TiaIndent")
  finish
endif

function TiaIndent()
  let above = prevnonblank(v:lnum - 1)
  if above == 0
    return 0
  endif
  let indent = indent(above)
  let line = getline(above)
  if line =~# '^\s*\%(@BLOCKS@\)\S\@!' && line !~# '^\s*\S\+\s\+\S\+\s\+@ELSEWHERE@\S\@!'
    let indent += shiftwidth()
  endif
  if getline(v:lnum) =~# '^\s*end\S\@!'
    let indent -= shiftwidth()
  endif
  return indent
endfunction
'''

# ---- nano: the last line that fits wins, and what stands before a word fits as well ----

NANO = r'''## Scenes for tia, tia-scene(5); @MADE@.
syntax "tia" "\.tia$"
comment "#"
tabgives "    "

# properties
color yellow "(^|[[:space:]])(@PROPERTIES@)\>"
# numbers, times and the corners of faces; names of numbers
color magenta "(^|[[:space:]])[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?:?"
color magenta "(^|[[:space:]])[0-9]+(/[0-9]*){1,2}"
color brightmagenta "(^|[[:space:]])-?[A-Z][^[:space:]]*"
color yellow "(^|[[:space:]])[0-9]x[0-9]\>"
# names, and the words before them
color cyan "(^|[[:space:]])(@NAMES@)[[:space:]]+[^[:space:]#][^[:space:]]*"
color cyan "^[[:space:]]*(@FIRST_NAMES@)[[:space:]]+[^[:space:]#][^[:space:]]*"
color yellow "(^|[[:space:]])(@NAMES@)\>"
# statements, and the first words in the blocks of meshes and grids
color brightblue "^[[:space:]]*(@FIRST@)\>"
# files with blanks in their names, and comments
color green "\"[^"]*\""
color brightblack "(^|[[:space:]])#.*"
'''

# ---- GtkSourceView ----

GTK = r'''<?xml version="1.0" encoding="UTF-8"?>
<!-- Scenes for tia, tia-scene(5); @MADE@. -->
<language id="tia" name="tia scene" version="2.0" _section="Other">
  <metadata>
    <property name="mimetypes">text/x-tia</property>
    <property name="globs">*.tia</property>
    <property name="line-comment-start">#</property>
  </metadata>
  <styles>
    <style id="statement" name="Statement" map-to="def:keyword"/>
    <style id="property" name="Property" map-to="def:type"/>
    <style id="number" name="Number" map-to="def:number"/>
    <style id="constant" name="Name of Numbers" map-to="def:constant"/>
    <style id="name" name="Name" map-to="def:identifier"/>
    <style id="string" name="File" map-to="def:string"/>
    <style id="comment" name="Comment" map-to="def:comment"/>
  </styles>
  <definitions>
    <context id="comment" style-ref="comment" end-at-line-end="true" class="comment">
      <start>(?&lt;!\S)#</start>
      <include><context ref="def:in-comment"/></include>
    </context>
    <context id="first-name">
      <match>^\s*(@FIRST_NAMES@)\s+(?:("[^"]*")|([^#\s]\S*))</match>
      <include>
        <context sub-pattern="1" style-ref="statement"/>
        <context sub-pattern="2" style-ref="string"/>
        <context sub-pattern="3" style-ref="name"/>
      </include>
    </context>
    <context id="first">
      <match>^\s*(@FIRST@)(?!\S)</match>
      <include><context sub-pattern="1" style-ref="statement"/></include>
    </context>
    <context id="name">
      <match>(?&lt;!\S)(@NAMES@)\s+(?:("[^"]*")|([^#\s]\S*))</match>
      <include>
        <context sub-pattern="1" style-ref="property"/>
        <context sub-pattern="2" style-ref="string"/>
        <context sub-pattern="3" style-ref="name"/>
      </include>
    </context>
    <context id="property" style-ref="property">
      <match>(?&lt;!\S)(?:@PROPERTIES@)(?!\S)</match>
    </context>
    <context id="number" style-ref="number">
      <match>(?&lt;!\S)(?:@NUMBER@)(?!\S)</match>
    </context>
    <context id="constant" style-ref="constant">
      <match>(?&lt;!\S)@CONSTANT@</match>
    </context>
    <context id="rest">
      <include>
        <context ref="comment"/>
        <context ref="name"/>
        <context ref="property"/>
        <context ref="number"/>
        <context ref="constant"/>
      </include>
    </context>
    <!-- A line that continues another has no statement. -->
    <context id="continued">
      <start>\\$</start>
      <end>(?&lt;!\\)$</end>
      <include><context ref="rest"/></include>
    </context>
    <context id="tia">
      <include>
        <context ref="continued"/>
        <context ref="comment"/>
        <context ref="first-name"/>
        <context ref="first"/>
        <context ref="rest"/>
      </include>
    </context>
  </definitions>
</language>
'''

# ---- Pygments ----

PYGMENTS = r'''"""A lexer of Pygments for scenes of tia, tia-scene(5); @MADE@.

    pygmentize -x -l tia_pygments.py:TiaLexer scene.tia
"""
from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Number, String, Text, Whitespace

__all__ = ("TiaLexer",)

FIRST = (@FIRST_LIST@)
FIRST_NAMES = (@FIRST_NAMES_LIST@)
PROPERTIES = (@PROPERTIES_LIST@)
NAMES = (@NAMES_LIST@)
END = r"(?!\S)"
NAMED = r'([^\S\n]+)(?:("[^"\n]*")|([^#\s]\S*))'


def any_of(names):
    return "((?:" + "|".join(names) + ")" + END + ")"


def before_name(names, kind):
    return any_of(names) + NAMED, bygroups(kind, Whitespace, String, Name.Variable)


class TiaLexer(RegexLexer):
    """Scenes of the ray tracer tia."""

    name = "tia scene"
    aliases = ["tia"]
    filenames = ["*.tia"]
    mimetypes = ["text/x-tia"]

    tokens = {
        "root": [
            (r"[^\S\n]+|\n", Whitespace),
            (r"#.*", Comment.Single),
            (*before_name(FIRST_NAMES, Keyword), "rest"),
            (any_of(FIRST), Keyword, "rest"),
            (r"(?=.)", Text, "rest"),
        ],
        "rest": [
            (r"\n", Whitespace, "#pop"),
            (r"\\\n", Text),
            (r"[^\S\n]+", Whitespace),
            (r"#.*", Comment.Single),
            before_name(NAMES, Keyword.Type),
            (any_of(PROPERTIES), Keyword.Type),
            (r"(?:@NUMBER@)(?=\s|$)", Number),
            (r"@CONSTANT@", Name.Constant),
            (r"\S+?(?=\s|$|\\\n)", Text),
        ],
    }
'''

PYPROJECT = '''# @MADE@: python3 -m pip install .
[build-system]
requires = ["setuptools>=61"]
build-backend = "setuptools.build_meta"

[project]
name = "tia-pygments"
version = "0.1.0"
description = "A lexer for scenes of the ray tracer tia"
dependencies = ["pygments"]

[project.entry-points."pygments.lexers"]
tia = "tia_pygments:TiaLexer"

[tool.setuptools]
py-modules = ["tia_pygments"]
'''


# ---- Visual Studio Code, and what else reads TextMate's grammars ----

def textmate(words):
    """The grammar: scopes as the themes of these editors know them."""
    def scope(name):
        return {"name": f"{name}.tia"}

    named = r"\s+(?:(\"[^\"]*\")|([^#\s]\S*))"
    statement, prop, string, name = (scope(kind) for kind in
                                     ("keyword.control", "support.type.property-name", "string.quoted.double", "variable.other"))
    rest = [{**scope("comment.line.number-sign"), "match": r"(?<!\S)#.*$"},
            {"match": rf"(?<!\S)({any_of(words.names)}){named}", "captures": {"1": prop, "2": string, "3": name}},
            {**prop, "match": rf"(?<!\S)(?:{any_of(words.properties)})(?!\S)"},
            {**scope("constant.numeric"), "match": rf"(?<!\S)(?:{NUMBER})(?!\S)"},
            {**scope("variable.other.constant"), "match": rf"(?<!\S){CONSTANT}"}]
    first = [{"match": rf"^\s*({any_of(words.first_names)}){named}", "captures": {"1": statement, "2": string, "3": name}},
             {"match": rf"^\s*({any_of(words.first)})(?!\S)", "captures": {"1": statement}}]
    return {"$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
            "comment": MADE, "name": "tia scene", "scopeName": "source.tia", "fileTypes": ["tia"],
            "patterns": [{"comment": "a line that continues another has no statement", "begin": r"\\$", "end": r"(?<!\\)\n",
                          "patterns": [{"include": "#rest"}]}, *first, {"include": "#rest"}],
            "repository": {"rest": {"patterns": rest}}}


def vscode(words):
    """Returns the files of the extension by their names."""
    blocks = any_of(scene_words.BLOCKS)
    package = {"name": "tia-scene", "displayName": "tia scenes", "description": "Colours and indents scenes of the ray tracer tia",
               "version": "0.1.0", "publisher": "tia", "license": "MIT", "engines": {"vscode": "^1.60.0"},
               "categories": ["Programming Languages"],
               "contributes": {"languages": [{"id": "tia", "aliases": ["tia scene"], "extensions": [".tia"],
                                              "configuration": "./language-configuration.json"}],
                               "grammars": [{"language": "tia", "scopeName": "source.tia",
                                             "path": "./syntaxes/tia.tmLanguage.json"}]}}
    configuration = {"comments": {"lineComment": "#"}, "wordPattern": r"[^\s#]+",
                     "indentationRules": {"increaseIndentPattern": rf"^\s*(?!mesh\s+\S+\s+{scene_words.BLOCK_ELSEWHERE}\b)(?:{blocks})(?!\S)",
                                          "decreaseIndentPattern": r"^\s*end(?!\S)"}}
    return {"package.json": package, "language-configuration.json": configuration, "syntaxes/tia.tmLanguage.json": textmate(words)}


def listed(words):
    """A tuple of Python's in lines of at most 120 columns."""
    lines = [""]
    for word in words:
        if len(lines[-1]) + len(word) > 110:
            lines.append("")
        lines[-1] += f'"{word}", '
    return "\n    ".join([""] + [line.rstrip() for line in lines])


def files(words):
    """Returns the text of each file by its name below package/editors/."""
    sets = {"FIRST": words.first, "FIRST_NAMES": words.first_names, "PROPERTIES": words.properties, "NAMES": words.names,
            "BLOCKS": scene_words.BLOCKS}

    def filled(text, escape=lambda part: part, bar="|"):
        for name, values in sets.items():
            text = text.replace(f"@{name}@", any_of(values).replace("|", bar)).replace(f"@{name}_LIST@", listed(values))
        for name, value in (("NUMBER", NUMBER), ("CONSTANT", CONSTANT), ("ELSEWHERE", scene_words.BLOCK_ELSEWHERE)):
            text = text.replace(f"@{name}@", escape(value))
        return text.replace("@MADE@", MADE)

    found = {f"vim/{folder}/tia.vim": filled(text, bar=r"\|") for folder, text in
             (("syntax", VIM_SYNTAX), ("ftdetect", VIM_DETECT), ("ftplugin", VIM_PLUGIN), ("indent", VIM_INDENT))}
    found["nano/tia.nanorc"] = filled(NANO)
    found["gtksourceview/tia.lang"] = filled(GTK)
    found["pygments/tia_pygments.py"] = filled(PYGMENTS)
    found["pygments/pyproject.toml"] = filled(PYPROJECT)
    for name, value in vscode(words).items():
        found[f"vscode/{name}"] = json.dumps(value, indent=2) + "\n"
    for name in ("pygments/pyproject.toml", "vscode/package.json"):
        found[name] = manifests.filled(f"package/editors/{name}", found[name], manifests.home())
    return found


def main():
    build, folder = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ROOT
    for name, text in files(scene_words.read(build)).items():
        path = os.path.join(folder, "package/editors", name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
