begin sierra Puck Game
  begin presto procedure p
    begin presto region r
      begin contact definition
        contact surface s1 contains block_1, surface_2
        begin interaction
          surfaces = s1 s2
        end interaction
      end
    end presto region
  end presto procedure p
end sierra
