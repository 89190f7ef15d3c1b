# The first vibration of a square plate of shells on simple supports, 1 x 1 x 0.01 m of steel, set off by a velocity of
# the shape of that vibration. Edges are held along z and in the plane, and turn freely.
#
# Shows bending of shells: frequency pi / a^2 sqrt(E t^2 / (12 rho (1 - nu^2))) = 48.1 Hz by Kirchhoff. Expected within
# 1.5 % with 16 x 16 elements, whatever their shape: quadrilaterals, distorted ones, triangles. A third of the error is the
# inertia of the nodes against turning, which is larger than the plate's for the sake of the stable step.
# -D points=n and -D rule="r" choose the integration through the thickness.
#
# {ifndef(points)}
# {points = 3}
# {endif}
# {ifndef(rule)}
# {rule = "gauss"}
# {endif}
begin sierra plate
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section plate
    thickness = 0.01
    integration rule = {rule}
    number of integration points = {points}
  end

  begin definition for function kick
    type = analytic
    expression variable: p = nodal_vector model_coordinates
    evaluate expression = "0.01 * sin(3.141592653589793 * p_x) * sin(3.141592653589793 * p_y)"
  end

  begin finite element model plate
    database name = plate.g
    begin parameters for block plate
      material = steel
      model = elastic
      section = plate
    end
  end

  begin presto procedure vibrate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region plate
          step interval = 1000
        end
      end
      termination time = 0.1
    end

    begin presto region plate
      use finite element model plate

      begin fixed displacement
        node set = rim
        components = x y z
      end

      begin initial velocity
        block = plate
        component = z
        function = kick
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(z) nearest location 0.5 0.5 0 as middle
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
