begin contact definition c
  contact surface a contains block_1
  contact surface a contains block_1
  contact surface x contacts y
  begin contact surface empty
  end
  begin interaction
    master = a
    slave = b, c, a
    friction model = nothere
    normal tolerence = -1
  end interaction
  search = acme
end contact definition c
