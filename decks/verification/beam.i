# The first bending vibration of a cantilever of beams, 1 m long, 0.05 m wide along y and 0.02 m high along z, of steel; it
# is set off along y and along z at once by a velocity that grows with the square of the distance from the clamped end.
#
# Shows beams, their sections and the t axis: frequencies 1.875104^2 / (2 pi) sqrt(E I / (rho A L^4)) = 40.9 Hz along y and
# 16.4 Hz along z by Euler and Bernoulli. Expected within 1 % with 10 elements.
begin sierra beam
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin beam section flat
    section = bar
    width = 0.05
    height = 0.02
    t axis = 0 1 0
  end

  begin definition for function kick
    type = analytic
    expression variable: x = nodal model_coordinates(x)
    evaluate expression = "0.1 * x * x"
  end

  begin finite element model beam
    database name = beam.g
    begin parameters for block beam
      material = steel
      model = elastic
      section = flat
    end
  end

  begin presto procedure vibrate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region beam
          step interval = 10000
        end
      end
      termination time = 0.5
    end

    begin presto region beam
      use finite element model beam

      begin fixed displacement
        node set = clamped
        components = x y z
      end
      begin fixed rotation
        node set = clamped
        components = x y z
      end

      begin initial velocity
        block = beam
        components = y z
        function = kick
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 5
        nodal displacement(y) nearest location 1 0 0 as tip_y
        nodal displacement(z) nearest location 1 0 0 as tip_z
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
