# The thick-walled cylinder of thick_cylinder.i in equilibrium step by step: radii 1 and 2 m, pressure p = 1 MPa inside, a
# quarter of it, one element long, held along its axis (plane strain; SI).
#
# Shows load steps and the search for equilibrium with nodal blocks. Expected: the closed form of Lame, u = p a (1 + nu) / E *
# (a^2 (1 - 2 nu) + b^2) / (b^2 - a^2) at the inner wall within 1 %, and the explicit run within 0.1 %. A third of the pressure in
# the first step makes a third of the displacement within 1e-4.
#
# solver  "nodal" (default): nodal blocks; "amg" or "direct": LINEAR SOLVER of the full tangent
# {ifndef(solver)}
# {solver = "nodal"}
# {endif}
begin sierra static cylinder
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      3 1
    end
  end

  begin finite element model pipe
    database name = static_cylinder.g
    begin parameters for block pipe
      material = steel
      model = elastic
    end
  end

  begin adagio procedure inflate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region pipe
          time increment = 1
        end
      end
      termination time = 3
    end

    begin adagio region pipe
      use finite element model pipe

      begin fixed displacement
        include all blocks
        component = z
      end
      begin fixed displacement
        node set = on_x
        component = y
      end
      begin fixed displacement
        node set = on_y
        component = x
      end

      begin pressure
        surface = inside
        function = ramp
        scale factor = 1e6
      end

      begin solver
        begin cg
          target relative residual = 1e-6
          reference = belytschko
{if(solver != "nodal")}
          begin full tangent preconditioner
            linear solver = {solver}
          end
{endif}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 1 0 0 as inner
        element stress(yy) nearest location 1.0 0.001 0 as hoop
        global energy_error as energy_error
        global internal_energy as internal_energy
        global external_energy as external_energy
      end

      begin results output
        database name = %B.e
        at time 0 increment = 1
        nodal variables = displacement
        element variables = stress von_mises
      end
    end
  end
end sierra
