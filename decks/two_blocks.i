# Order decides who owns a face.
#
# Two bricks that share nodes at their joint, a patch of eight faces on top across the joint (a side set), and a
# shell that lies on half of the right brick's top. Expected, with the patch named first (order = 1, as it stands):
#   top    the 8 faces of the patch, 4 of each brick
#   left   56 skin faces less 4    (a 4x4x2 brick has 64 faces, the 8 at the joint are interior)
#   right  48 skin faces less 4    (8 more are covered by the shell, which always lies outside)
#   cladding  8 lofted shells: 8 top, 8 bottom and 12 side facets
# With the skins first (-D order=2) the patch comes too late and gets nothing, which is warned about:
#   contactsim two_blocks.i two_blocks.g --check -D order=2
#
# {ifndef(order)}
# {order = 1}
# {endif}

begin sierra two blocks and a patch

  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section sheet
    thickness = 0.1
  end

  begin finite element model bricks
    database name = two_blocks.g
    begin parameters for block left right
      material = steel
      model = elastic
    end
    begin parameters for block cladding
      material = steel
      model = elastic
      section = sheet
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all_of_it
        start time = 0
        begin parameters for presto region bricks
        end
      end
      termination time = 1e-3
    end

    begin presto region bricks
      use finite element model bricks

      begin contact definition
{if(order == 1)}
        contact surface top contains patch
        skin all blocks = on
{else}
        skin all blocks = on
        contact surface top contains patch
{endif}
        begin constant friction model rub
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          friction model = rub
        end
      end

      begin results output out
        database name = %B.e
        at time 0 increment = 1e-4
        nodal variables = displacement as displ
      end
    end
  end
end
