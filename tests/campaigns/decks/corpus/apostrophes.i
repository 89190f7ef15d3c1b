begin sierra s
 title Bob's run 'n roll 12" pipe
 x = 'a' "b" ''
end sierra
