# A steel bracket is tied to a wall, as if welded along its back. A block is lowered onto its arm by 0.1 mm and then pushed outwards
# along it (mm, N, MPa, t).
#
# Shows ties between unlike meshes and sliding with friction in load steps. Expected: the arm gives way the more the farther out
# the block is, so that the force it presses with (weight in bracket.csv) falls, and friction holds it back by about a quarter of
# that (drag): the arm slopes.
#
# friction  between block and arm
#
# {ifndef(friction)}
# {friction = 0.25}
# {endif}
begin sierra bracket
  begin material steel
    density = 7.8e-9
    begin parameters for model elastic
      youngs modulus = 200e3
      poissons ratio = 0.3
    end
  end

  begin definition for function lowered
    type = piecewise linear
    begin values
      0 0
      1 1
      3 1
    end
  end
  begin definition for function way
    type = piecewise linear
    begin values
      0 0
      1 0
      3 15
    end
  end

  begin finite element model parts
    database name = bracket.g
    begin parameters for block wall bracket load
      material = steel
      model = elastic
    end
  end

  begin adagio procedure push
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region parts
          time increment = 0.25
        end
      end
      termination time = 3
    end

    begin adagio region parts
      use finite element model parts

      begin fixed displacement
        node set = held
        components = x y z
      end
      begin prescribed displacement
        node set = pushed
        component = z
        function = lowered
        scale factor = -0.1
      end
      begin prescribed displacement
        node set = pushed
        component = x
        function = way
      end
      begin fixed displacement
        node set = pushed
        component = y
      end

      begin contact definition
        contact surface wall contains wall_side
        contact surface back contains back
        contact surface arm contains arm
        contact surface foot contains foot
        begin constant friction model dry
          friction coefficient = {friction}
        end
        begin interaction weld
          surfaces = wall back
          friction model = tied
        end
        begin interaction rub
          surfaces = foot arm
          friction model = dry
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin user output
        block = load
        compute global drag as sum of nodal force_contact(x)
        compute global weight as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        at step 0 increment = 1
        nodal displacement(z) nearest location 60 0 0 as tip
        nodal displacement(x) nearest location 10 0 17 as way
        global drag
        global weight
      end
      begin results output
        database name = %B.e
        at time 0 increment = 0.25
        nodal variables = displacement force_contact
        element variables = stress von_mises
      end
    end
  end
end sierra
