{switch(2)}
skipped
{case(1)}
a
{case(2)} b
c
{case(2)}
d
{default}
e
{endswitch}
