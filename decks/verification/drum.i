# A round membrane of steel, of radius 1 m and 1 mm thick, held at its rim and blown up by a slowly growing pressure.
#
# Shows membranes: flat they resist nothing across them, stretched they do. The deflection of the middle over the radius is
# 0.653 cbrt(q a / (E t)) for nu = 0.3 by Hencky, for slopes that are small. Expected within 0.5 % with 16 elements across.
begin sierra drum
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin membrane section skin
    thickness = 0.001
  end

  begin definition for function blow
    type = analytic
    evaluate expression = "0.5 * (1 - cos(3.141592653589793 * min(x / 0.15, 1)))"
  end

  begin finite element model drum
    database name = drum.g
    begin parameters for block skin
      material = steel
      model = elastic
      section = skin
    end
  end

  begin presto procedure blow
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region drum
          step interval = 10000
        end
      end
      termination time = 0.2
    end

    begin presto region drum
      use finite element model drum

      begin fixed displacement
        node set = rim
        components = x y z
      end

      begin pressure
        surface = below
        function = blow
        scale factor = 8e4
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 10
        nodal displacement(z) nearest location 0 0 0 as middle
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
