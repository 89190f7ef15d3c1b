# {n = 3} {dt = 1e-6*n^2}
begin sierra {"s" // tostring(n)}
 x = {sqrt(n)} {[n/2]} {n % 2} {n > 2 ? 1 : -1} {-n ** 2} {n ~ 2}
end
