begin function f
 type is analytic
 expression variable: x = global time
 evaluate expression = "x < 1 ? 0.0 : \#
  pow(x, 2); # no comment"
end function f
