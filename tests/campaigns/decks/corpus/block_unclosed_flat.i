begin contact definition
begin interaction a
x
begin interaction b
y
end
end contact definition
