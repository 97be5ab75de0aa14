" Scenes for tia; written by tools/generate/editors.py.
au BufRead,BufNewFile *.tia setfiletype tia
