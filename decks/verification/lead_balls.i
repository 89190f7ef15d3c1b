# 124 balls of lead, 10 mm wide, in an open steel box of shells are crushed by a rigid plate at 10 m/s until they fill most
# of the room below it (mm, N, MPa, t, s; after the Sierra/SM manual, appendix A).
#
# Shows many soft bodies under large plastic strains in contact with shells and with themselves: the run goes through to the
# end, with two thirds of the room filled (-D end_time=3e-3: nine tenths), no ball leaves the box, skins are in each other by
# less than half an element, and the energy balances within 5 %.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(end_time)}
# {end_time = 2.4e-3}
# {endif}
# {frame = end_time / 16}
begin sierra lead balls
  begin material lead
    density = 11.34e-9
    begin parameters for model elastic_plastic
      youngs modulus = 16e3
      poissons ratio = 0.42
      yield stress = 20
      hardening modulus = 20
    end
  end
  begin material steel
    density = 7.85e-9
    begin parameters for model elastic
      youngs modulus = 206e3
      poissons ratio = 0.3
    end
  end

  begin shell section wall
    number of integration points = 3
  end
  begin rigid body press
  end
  begin shell section press
    thickness = 2
    rigid body = press
  end

  begin definition for function steady
    type = analytic
    evaluate expression = "-1e4 * (x < 2e-4 ? 0.5 * (1 - cos(3.141592653589793 * x / 2e-4)) : 1)"
  end

  begin finite element model bodies
    database name = lead_balls.g
    begin parameters for block balls
      material = lead
      model = elastic_plastic
    end
    begin parameters for block box
      material = steel
      model = elastic
      section = wall
    end
    begin parameters for block press
      material = steel
      model = elastic
      section = press
    end
  end

  begin presto procedure crush
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 500
        end
      end
      termination time = {end_time}
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        node set = floor
        components = x y z
      end
      begin fixed displacement
        rigid body = press
        components = x y
      end
      begin fixed rotation
        rigid body = press
        components = x y z
      end
      begin prescribed velocity
        rigid body = press
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

      begin heartbeat output
        stream name = %B.csv
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
