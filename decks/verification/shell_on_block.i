# A square shell, 0.1 m thick, lies down on a block that is held (SI; gravity, contact damping).
#
# Shows the lofted side of a shell: its middle comes to rest half its thickness above the block, less the depth
# rho g t / k that its weight takes with a penalty of k per area. Expected: the height within 1 % of t, the depth within 1 %,
# whichever way the shell's normal points. With NODE_FACE the block is as wide as the shell: each side's nodes
# count for half of the areas around them, whatever of these lies beyond the other's edge.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 5e-3}
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
      termination time = 0.15
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

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          penalty stiffness = 3e7
          contact damping fraction = 0.3
        end
      end

      begin user output
        block = sheet
        compute global force as sum of nodal force_contact(z)
        compute global height as average of nodal coordinates(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force height
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
