begin a
 begin b
 end c
 begin d
 end a
end b
begin
end
begin = x
end = x
