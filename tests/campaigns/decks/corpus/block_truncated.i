begin sierra s
 begin material m
  density = 1
  begin parameters for model elastic
