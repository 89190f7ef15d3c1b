begin values
 0.0, 0.0 # row
 0.5, 1.0 # row
 1.0, 4.0 # row
 1.5, 9.0 # row
 2.0, 16.0 # row
 2.5, 25.0 # row
 3.0, 36.0 # row
 3.5, 49.0 # row
 4.0, 64.0 # row
 4.5, 81.0 # row
 5.0, 100.0 # row
 5.5, 121.0 # row
 6.0, 144.0 # row
 6.5, 169.0 # row
 7.0, 196.0 # row
 7.5, 225.0 # row
 8.0, 256.0 # row
 8.5, 289.0 # row
 9.0, 324.0 # row
 9.5, 361.0 # row
 includefile rows.txt
 includefile 'a b'
 includefile
end values
