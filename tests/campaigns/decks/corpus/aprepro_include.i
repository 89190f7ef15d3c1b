{n = n + 1}
{if(n < 40)}
{include("self" // tostring(n))}
{endif}
{cinclude(none)}
includefile none
