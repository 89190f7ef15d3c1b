# Plies that are stretched by 1e-4 along x and held along y and z: a shell whose fibres lie at 30 degrees to x, and a brick
# that is wound about the z axis through its middle in x, so that x runs around it (SI).
#
# Shows orthotropic moduli, coordinate systems and the directions of a material: with
# Q11 = E11 / (1 - NU12 NU21), Q22, Q12 and G12 turned by the angle the shell has
#   xx = (Q11 c^4 + 2 (Q12 + 2 G12) s^2 c^2 + Q22 s^4) 1e-4, yy = ((Q11 + Q22 - 4 G12) s^2 c^2 + Q12 (s^4 + c^4)) 1e-4,
#   xy = ((Q11 - Q12 - 2 G12) s c^3 + (Q12 - Q22 + 2 G12) s^3 c) 1e-4,
# and the brick the column of its direction 2. Expected: stresses within 0.02 %, which is the strain.
begin sierra off axis
  define point origin with coordinates 0 0 0
  define point above with coordinates 0 0 1
  define point along_fibres with coordinates {cosd(30)} {sind(30)} 0
  define coordinate system fibres rectangular with point origin point above point along_fibres
  define point centre with coordinates 0.5 0 0
  define point over_centre with coordinates 0.5 0 1
  define point beside with coordinates 1.5 0 0
  define coordinate system winding cylindrical with point centre point over_centre point beside

# {loop(2, i, 0)}
  begin material {i == 0 ? "ply" : "wound"}
    density = 1600
    begin parameters for model elastic_orthotropic
      e11 = 140e9
      e22 = 10e9
      e33 = 9e9
      nu12 = 0.3
      nu13 = 0.25
      nu23 = 0.4
      g12 = 5e9
      g13 = 4e9
      g23 = 3.5e9
      coordinate system = {i == 0 ? "fibres" : "winding"}
    end
  end
# {endloop}

  begin shell section sheet
    thickness = 0.01
    number of integration points = 3
  end

  begin definition for function pull
    type = analytic
    evaluate expression = "x < 5e-4 ? 0.5 * (1 - cos(6283.185307179586 * x)) : 1"
  end

  begin finite element model plies
    database name = off_axis.g
    begin parameters for block ply
      material = ply
      model = elastic_orthotropic
      section = sheet
    end
    begin parameters for block wound
      material = wound
      model = elastic_orthotropic
    end
  end

  begin presto procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region plies
          step interval = 1000
        end
      end
      termination time = 1e-3
    end

    begin presto region plies
      use finite element model plies

      begin fixed displacement
        include all blocks
        components = y z
      end
      begin fixed displacement
        node set = held
        component = x
      end
      begin fixed rotation
        block = ply
        components = x y z
      end
      begin prescribed displacement
        node set = pulled
        component = x
        function = pull
        scale factor = 1e-4
      end

      begin results output
        database name = %B.e
        at time 0 increment = 1e-3
        element variables = stress
      end
    end
  end
end sierra
