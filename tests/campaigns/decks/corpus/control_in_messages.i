begin sierra a
{'two
lines' 'of [2J text'}
{endloop	} {endif}
{i	_ = }
{include("rows[31m.inc")}
includefile two	bodies.inc
{if(	1)} joined
{endif}
unknownword
end
