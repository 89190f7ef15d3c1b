a<=b>=c==d<e>f=g=== <<>> =<
criterion is max nodal value of coordinates(x)>=1.0e-3
