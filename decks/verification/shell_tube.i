# A square tube of shells, 50 mm wide, 1.5 mm thick, 150 mm long, stands on a rigid plate and is crushed from above by
# another one at 20 m/s (mm, N, MPa, t, s; J2 perfectly plastic, 300 MPa).
#
# Shows folds that lie down on each other: self contact of shells through large plastic turns. Mean force by Abramowicz and
# Jones (1984), 13.06 s t^(5/3) b^(1/3), over the way of three folds; friction of 0.2.
# Expected: mean force within 15 %, energy within 1 %, skins in each other by less than three quarters of the wall, where
# folds are sharpest.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {end_time = 4.5e-3} {frame = end_time / 15}
begin sierra shell tube
  begin material steel
    density = 7.85e-9
    begin parameters for model elastic_plastic
      youngs modulus = 206e3
      poissons ratio = 0.3
      yield stress = 300
      hardening modulus = 0
    end
  end

  begin shell section wall
    thickness = 1.5
    number of integration points = 5
  end
# {loop(2, i, 0)}
  begin rigid body plate_{i}
  end
  begin shell section plate_{i}
    thickness = 1.5
    rigid body = plate_{i}
  end
# {endloop}

  begin definition for function steady
    type = analytic
    evaluate expression = "-2e4 * (x < 2e-4 ? 0.5 * (1 - cos(3.141592653589793 * x / 2e-4)) : 1)"
  end

  begin finite element model bodies
    database name = shell_tube.g
    begin parameters for block tube
      material = steel
      model = elastic_plastic
      section = wall
    end
    begin parameters for block floor
      material = steel
      model = elastic_plastic
      section = plate_0
    end
    begin parameters for block press
      material = steel
      model = elastic_plastic
      section = plate_1
    end
  end

  begin presto procedure crush
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        rigid body = plate_0
        components = x y z
      end
      begin fixed displacement
        rigid body = plate_1
        components = x y
      end
      begin fixed rotation
        rigid body = plate_0 plate_1
        components = x y z
      end
      begin prescribed velocity
        rigid body = plate_1
        component = z
        function = steady
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rub
          friction coefficient = 0.2
        end
        begin interaction defaults
          general contact = on
          self contact = on
          friction model = rub
          constraint formulation = {form}
        end
      end

      begin user output
        block = press
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact contact_normal_gap
        element variables = von_mises eqps
      end
    end
  end
end sierra
