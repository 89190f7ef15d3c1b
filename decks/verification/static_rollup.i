# A strip of shells, 10 x 1 x 0.1, clamped at one end and bent into a full circle by a moment at the other: E = 1.2e8, nu = 0, so
# that E I = 1e4.
#
# Shows large rotations in load steps, with a factor of the whole stiffness: M = 2 pi E I / L bends the strip into a circle, its
# tip comes back to where it is clamped. Expected: within 1 % of the length with 20 elements and 40 steps; half of the moment
# bends it into a half circle of diameter 2 L / pi. Source: Sze, Liu and Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, 3.1.
#
# {ifndef(steps)}
# {steps = 40}
# {endif}
begin sierra static rollup
  begin material strip
    density = 1
    begin parameters for model elastic
      youngs modulus = 1.2e8
      poissons ratio = 0
    end
  end

  begin shell section strip
    thickness = 0.1
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model strip
    database name = static_rollup.g
    begin parameters for block strip
      material = strip
      model = elastic
      section = strip
    end
  end

  begin adagio procedure bend
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region strip
          number of time steps = {steps}
        end
      end
      termination time = 1
    end

    begin adagio region strip
      use finite element model strip

      begin fixed displacement
        node set = clamped
        components = x y z
      end
      begin fixed rotation
        node set = clamped
        components = x y z
      end
      # Two nodes share the moment.
      begin prescribed moment
        node set = tip
        component = y
        function = ramp
        scale factor = {-0.5 * 2 * PI * 1e4 / 10}
      end

      begin solver
        begin cg
          target relative residual = 1e-6
          reference = internal
          begin full tangent preconditioner
          end
        end
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 10 0 0 as tip_x
        nodal displacement(z) nearest location 10 0 0 as tip_z
        global energy_error as energy_error
        global internal_energy as internal_energy
      end

      begin results output
        database name = %B.e
        at time 0 increment = 0.1
        nodal variables = displacement
      end
    end
  end
end sierra
