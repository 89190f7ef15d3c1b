# A rubber ball of 10 mm radius is pressed flat on a steel plate: an eighth of the ball, whose middle plane comes down by 3 mm (mm,
# N, MPa, t).
#
# Shows load steps with large strain, and contact that grows from a point. At first the force follows Hertz, F = 4/3 E / (1 - nu^2)
# sqrt(R) d^1.5, of which a quarter is 1.52 N at 0.375 mm (1.60 with these elements); later the ball is stiffer. The force by step
# is in pressed_ball.csv; contact_normal_traction_magnitude is the pressure.
#
# depth     how far the middle plane comes down
# friction  between rubber and steel
#
# {ifndef(depth)}
# {depth = 3}
# {endif}
# {ifndef(friction)}
# {friction = 0}
# {endif}
begin sierra pressed ball
  begin material rubber
    density = 1e-9
    begin parameters for model neo_hookean
      youngs modulus = 5
      poissons ratio = 0.45
    end
  end
  begin material steel
    density = 7.8e-9
    begin parameters for model elastic
      youngs modulus = 200e3
      poissons ratio = 0.3
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model bodies
    database name = pressed_ball.g
    begin parameters for block ball
      material = rubber
      model = neo_hookean
    end
    begin parameters for block plate
      material = steel
      model = elastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region bodies
          number of time steps = 8
        end
      end
      termination time = 1
    end

    begin adagio region bodies
      use finite element model bodies

      # Planes of symmetry, the ground, and the press.
      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
        node set = ground
        component = z
      end
      begin prescribed displacement
        node set = middle
        component = z
        function = ramp
        scale factor = {-depth}
      end

      begin contact definition
        contact surface ball contains ball
        contact surface plate contains plate
        begin constant friction model dry
          friction coefficient = {friction}
        end
        begin interaction press
          surfaces = ball plate
          friction model = dry
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin user output
        block = plate
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        at step 0 increment = 1
        nodal displacement(z) nearest location 0 0 10 as depth
        global force
      end
      begin results output
        database name = %B.e
        at step 0 increment = 1
        nodal variables = displacement force_contact contact_normal_traction_magnitude
        element variables = stress von_mises
      end
    end
  end
end sierra
