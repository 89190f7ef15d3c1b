""
'' = ''
begin sierra ''
  begin definition for function ""
    type = ''
  end
  title ""
{include("")}
includefile
includefile ''
end
