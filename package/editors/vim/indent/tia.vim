" Vim indent file of scenes for tia: blocks up to "end"; written by tools/generate/editors.py.
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
  if line =~# '^\s*\%(intersection\|difference\|repeat\|group\|union\|grid\|mesh\)\S\@!' && line !~# '^\s*\S\+\s\+\S\+\s\+file\S\@!'
    let indent += shiftwidth()
  endif
  if getline(v:lnum) =~# '^\s*end\S\@!'
    let indent -= shiftwidth()
  endif
  return indent
endfunction
