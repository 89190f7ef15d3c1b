# A square shell, 0.1 m thick, lies down on a block that is held (SI; gravity, contact damping).
#
# Shows the lofted side of a shell: its middle comes to rest half its thickness above the block, less the depth
# rho g t / k that its weight takes with a penalty of k per area. Expected: the height within 1 % of t, the depth within 1 %,
# whichever way the shell's normal points. With NODE_FACE the block is as wide as the shell: each side's nodes
# count for half of the areas around them, whatever of these lies beyond the other's edge.
#
# -D speed=v throws it along x over the block, with friction of 0.5 at its lower side: it stops after v^2 / (2 mu g), within
# 1 %, and all its energy is lost to friction.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(speed)}
# {speed = 0} {end_time = 0.15}
# {endif}
# {frame = end_time / 30}
begin sierra shell on block
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section sheet
    thickness = 0.1
    number of integration points = 3
  end

  begin finite element model bodies
    database name = shell_on_block.g
    begin parameters for block sheet
      material = steel
      model = elastic
      section = sheet
    end
    begin parameters for block block
      material = steel
      model = elastic
    end
  end

  begin presto procedure rest
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 5000
        end
      end
      termination time = {end_time}
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        block = block
        components = x y z
      end
      begin gravity
        block = sheet
        component = z
        gravitational constant = -9.81
      end

{if(speed != 0)}
      begin initial velocity
        block = sheet
        component = x
        magnitude = {speed}
      end
{endif}

      begin contact definition
        skin all blocks = on
        begin constant friction model rub
          friction coefficient = 0.5
        end
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          penalty stiffness = 3e7
{if(speed != 0)}
          friction model = rub
{endif}
          contact damping fraction = 0.3
        end
      end

      begin user output
        block = sheet
        compute global force as sum of nodal force_contact(z)
        compute global height as average of nodal coordinates(z)
        compute global way as average of nodal displacement(x)
      end
      begin heartbeat output
        stream name = %B.csv
        global force height way
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
