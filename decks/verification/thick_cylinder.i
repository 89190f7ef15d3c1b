# A thick-walled cylinder, radii 1 and 2 m, under internal pressure p = 1 MPa that is brought up slowly; a quarter of it,
# one element long, held along its axis (plane strain; SI).
#
# Shows pressure on curved faces and stresses by the closed form of Lame: radial displacement of the inner wall
#   u = p a (1 + nu) / E * (a^2 (1 - 2 nu) + b^2) / (b^2 - a^2),
# hoop stress at radius r: p a^2 / (b^2 - a^2) * (1 + b^2 / r^2). Expected: displacement within 1 %, hoop stress in the
# middle of the innermost elements within 3 %. Values are means over the last periods of what still vibrates.
begin sierra thick cylinder
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin definition for function slowly
    type = analytic
    evaluate expression = "x < 0.01 ? 0.5 * (1 - cos(3.141592653589793 * x / 0.01)) : 1"
  end

  begin finite element model pipe
    database name = thick_cylinder.g
    begin parameters for block pipe
      material = steel
      model = elastic
    end
  end

  begin presto procedure inflate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region pipe
          step interval = 500
        end
      end
      termination time = 0.02
    end

    begin presto region pipe
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
        function = slowly
        scale factor = 1e6
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 1 0 0 as inner
        element stress(yy) nearest location 1.0 0.001 0 as hoop
        global energy_error as energy_error
        global external_energy as external_energy
      end

      begin results output
        database name = %B.e
        at time 0 increment = 2e-3
        nodal variables = displacement
        element variables = stress von_mises
      end
    end
  end
end sierra
