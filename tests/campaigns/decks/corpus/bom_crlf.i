begin a
 x = 1, 2	3 # c
 y \#
 z
end a
