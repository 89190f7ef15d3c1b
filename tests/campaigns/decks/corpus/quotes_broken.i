x = "never closed
y = 'open
" " " '
"a\#
\#
b" c
"\#
