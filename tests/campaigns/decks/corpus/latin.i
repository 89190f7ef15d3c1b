title Müller â‚¬ ÿþ {é} €
begin Ã©
end Ã‰
