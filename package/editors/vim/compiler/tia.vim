" Vim compiler file: the mistakes of scenes of tia. In a scene, :compiler tia and :make, then :cnext goes to the next one.
if exists('current_compiler')
  finish
endif
let current_compiler = 'tia'

if exists(':CompilerSet') != 2
  command -nargs=* CompilerSet setlocal <args>
endif

let s:cpo_save = &cpo
set cpo&vim

CompilerSet makeprg=tia\ --check\ %:S
" A message, a warning about a line, and the line of the scene below a message.
CompilerSet errorformat=tia:\ %f:%l:%c:\ %m
CompilerSet errorformat+=tia:\ %f:%l:\ %m
CompilerSet errorformat+=%-G%.%#

let &cpo = s:cpo_save
unlet s:cpo_save
