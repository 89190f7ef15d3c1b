# A shell between two blocks that are slowly pressed together by the way u of each outer end; lateral motion is held (SI).
#
# Shows both sides of a shell at work at once: the pressure is that of the stack, p = 2 u / (2 L/E + 2/k) with nu = 0 and a
# penalty of k per area, what one block pushes the other takes, and nothing is left on the shell, which neither moves nor
# bends, though the meshes of all three differ.
# Expected: pressure within 0.1 %, force and moment on the shell's nodes below 1e-3 of the pressing force.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {end_time = 3e-3} {frame = end_time / 10}
begin sierra pinched shell
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0
    end
  end

  begin shell section sheet
    thickness = 0.02
    number of integration points = 3
  end

  begin definition for function slowly
    type = analytic
    evaluate expression = "x < 1e-3 ? 0.5 * (1 - cos(3141.592653589793 * x)) : 1"
  end

  begin finite element model stack
    database name = pinched_shell.g
    begin parameters for block lower upper
      material = steel
      model = elastic
    end
    begin parameters for block sheet
      material = steel
      model = elastic
      section = sheet
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region stack
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region stack
      use finite element model stack

      begin fixed displacement
        block = lower upper
        components = x y
      end
      begin prescribed displacement
        node set = bottom
        component = z
        function = slowly
        scale factor = 1e-5
      end
      begin prescribed displacement
        node set = top
        component = z
        function = slowly
        scale factor = -1e-5
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          penalty stiffness = 1e13
          contact damping fraction = 0.1
        end
      end

      begin user output
        block = upper
        compute global force as sum of nodal force_contact(z)
      end
      begin user output
        block = lower
        compute global force_below as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force force_below
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
