begin
end
begin sierra a
  begin
  end
  begin # function
    type = analytic
  end
  begin ""
  end ""
end
