# c
$ d
###
x # y
z$w
\# joined
q \$ 
r # s \#
t
