{x = 2}
{if(x == 1)} a
one
{elseif(x == 2)}
two {x}
{else}
many
{endif}
{ifdef(y)}
b
{endif}
{Ifndef(y)}
c
{Endif}
