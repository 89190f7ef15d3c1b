{n = 3}
{loop(n, i, 1, 0.5)}
  {loop(2)}
  begin b{i}
 x = {__loop_2}
 end
  {endloop}
{endloop}
{loop(0)}
{1/0}
{endloop}
