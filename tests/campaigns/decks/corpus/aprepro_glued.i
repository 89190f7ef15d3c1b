#{include(self1)}
#{if(1)}
x
#{endif}
// {loop(2)}
y
## {endloop}
{#} {a
