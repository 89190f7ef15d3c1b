# Two strings of trusses, 1 m long, of 1 mm^2 and 7800 kg/m^3, held at both ends and pulled by 200 N before they swing: one
# from the start on, the other within the first 0.1 ms. A velocity of the shape of the first vibration sets them off.
#
# Shows INITIAL LOAD and PERIOD of trusses: frequency sqrt(T / (rho A)) / (2 l) = 80.1 Hz, for n elements lower by a share of
# (pi / n)^2 / 24. Expected within 0.2 % with 20 elements.
begin sierra string
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin truss section at_once
    area = 1e-6
    initial load = 200
  end
  begin truss section soon
    area = 1e-6
    initial load = 200
    period = 1e-4
  end

  begin definition for function kick
    type = analytic
    expression variable: x = nodal model_coordinates(x)
    evaluate expression = "0.05 * sin(3.141592653589793 * x)"
  end

  begin finite element model string
    database name = string.g
    begin parameters for block at_once
      material = steel
      model = elastic
      section = at_once
    end
    begin parameters for block soon
      material = steel
      model = elastic
      section = soon
    end
  end

  begin presto procedure swing
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region string
          step interval = 10000
        end
      end
      termination time = 0.1
    end

    begin presto region string
      use finite element model string

      begin fixed displacement
        node set = ends
        components = x y z
      end
      begin initial velocity
        include all blocks
        component = z
        function = kick
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 5
        nodal displacement(z) nearest location 0.5 0 0 as at_once
        nodal displacement(z) nearest location 0.5 1 0 as soon
        element stress(xx) nearest location 0.525 0 0 as stress_at_once
        element stress(xx) nearest location 0.525 1 0 as stress_soon
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
