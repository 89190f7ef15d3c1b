# Rubber pulled slowly to twice its length, free to narrow: a block of solids and a sheet of shells of Mooney-Rivlin, a cord
# of trusses and one of beams of neo-Hookean rubber (SI).
#
# Shows that the laws follow from the deformation alone and that thickness and cross-section follow with them: the stress
# is that of the formula with the stretch across for which the stress there vanishes, and the force is that stress times
# the area that is left. Without volume change it would be 2 (L^2 - 1/L) (C10 + C01 / L) = 2.45 MPa with C10 = 0.3 MPa
# and C01 = 0.1 MPa, L = 2. Expected: stress and force within 1e-4, energy balance within 0.5 %.
begin sierra rubber
  begin material rubber
    density = 1000
    begin parameters for model mooney_rivlin
      c10 = 0.3e6
      c01 = 0.1e6
      bulk modulus = 1e8
    end
    begin parameters for model neo_hookean
      shear modulus = 0.8e6
      bulk modulus = 1e8
    end
  end

  begin shell section sheet
    thickness = 0.1
    number of integration points = 3
  end
  begin truss section cord
    area = 0.01
  end
  begin beam section cord_beam
    section = bar
    width = 0.1
    height = 0.1
    t axis = 0 0 1
  end

  # From rest to rest without a jerk, over 2 s.
  begin definition for function pull
    type = analytic
    evaluate expression = "x < 2 ? 0.5 * x - sin(3.141592653589793 * x) / 6.283185307179586 : 1"
  end

  begin finite element model rubber
    database name = rubber_pull.g
    begin parameters for block block
      material = rubber
      model = mooney_rivlin
    end
    begin parameters for block sheet
      material = rubber
      model = mooney_rivlin
      section = sheet
    end
    begin parameters for block cord
      material = rubber
      model = neo_hookean
      section = cord
    end
    begin parameters for block beam
      material = rubber
      model = neo_hookean
      section = cord_beam
    end
  end

  begin presto procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rubber
          step interval = 1000
        end
      end
      termination time = 2
    end

    begin presto region rubber
      use finite element model rubber

      begin fixed displacement
        node set = held
        component = x
      end
      begin fixed displacement
        node set = side
        component = y
      end
      begin fixed displacement
        node set = floor
        component = z
      end
      begin fixed rotation
        block = sheet beam
        components = x y z
      end
      begin prescribed displacement
        node set = pulled
        component = x
        function = pull
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = 1
        nodal variables = force_internal
        element variables = stress
      end
    end
  end
end sierra
