" Vim file type plug-in of scenes for tia; written by tools/generate/editors.py.
if exists("b:did_ftplugin")
  finish
endif
let b:did_ftplugin = 1
setlocal commentstring=#\ %s comments=:# formatoptions-=t
setlocal iskeyword+=-
" The words that CTRL-X CTRL-O completes are those of the syntax file.
setlocal omnifunc=syntaxcomplete#Complete
silent! compiler tia
let b:undo_ftplugin = "setlocal commentstring< comments< formatoptions< iskeyword< omnifunc<"
