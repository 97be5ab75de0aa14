" Vim syntax file of scenes for tia, tia-scene(5); written by tools/generate/editors.py.
if exists("b:current_syntax")
  finish
endif
let s:save = &cpo
set cpo&vim

syn match tiaProperty "\S\@1<!\%(orthographic\|transmission\|attenuation\|directional\|perspective\|restitution\|tessellated\|zpass-plain\|lightfield\|refraction\|direction\|footprint\|map-exact\|occlusion\|page-down\|rectangle\|bilinear\|constant\|distance\|emission\|exponent\|material\|specular\|vanishes\|velocity\|ambient\|appears\|checker\|fresnel\|frustum\|octaves\|opacity\|page-up\|poisson\|samples\|texture\|whitted\|camera\|capped\|centre\|colour\|corner\|facing\|filter\|height\|linear\|mirror\|normal\|offset\|radius\|repeat\|rotate\|smooth\|sphere\|traced\|window\|above\|depth\|focus\|image\|index\|inner\|level\|light\|major\|minor\|noise\|outer\|plane\|point\|radii\|right\|scale\|sides\|slope\|until\|width\|zfail\|zpass\|axis\|base\|bias\|bump\|cell\|disc\|down\|even\|file\|from\|high\|left\|look\|mass\|name\|near\|none\|path\|pcss\|rays\|size\|spot\|srgb\|3x3\|5x5\|7x7\|eye\|fov\|low\|map\|max\|min\|odd\|top\|ao\|at\|to\|up\|a\|b\|c\)\S\@!"
syn match tiaProperty "\S\@1<!\%(material\|opacity\|texture\|image\|bump\|file\|name\)\S\@!" nextgroup=tiaString,tiaName skipwhite
syn match tiaNumber "\S\@1<![-+]\=\%(\d\+\.\=\d*\|\.\d\+\)\%([eE][-+]\=\d\+\)\=:\=\S\@!"
syn match tiaNumber "\S\@1<!\d\+\%(/\d*\)\{1,2}\S\@!"
syn match tiaConstant "\S\@1<!-\=\u\S*"
" The first word of a line, but not of one that continues another.
syn match tiaStatement "\%(^\s*\)\@<=\%(\\\n\s*\)\@<!\%(intersection\|background\|difference\|integrator\|cylinder\|exposure\|instance\|material\|triangle\|animate\|gravity\|include\|rounded\|samples\|shadows\|texture\|camera\|define\|filter\|normal\|repeat\|sphere\|vertex\|depth\|group\|light\|plane\|torus\|union\|cone\|disc\|face\|fall\|grid\|lens\|mesh\|tone\|box\|end\|fog\|key\|row\|spp\|uv\)\S\@!"
syn match tiaStatement "\%(^\s*\)\@<=\%(\\\n\s*\)\@<!\%(instance\|material\|animate\|include\|texture\|define\|fall\|grid\|mesh\|key\)\S\@!" nextgroup=tiaString,tiaName skipwhite
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
