# Two particles of steel meet head on, the second one at rest (SI; radii 10 and 10 or 20 mm).
#
# Shows particles as balls on a penalty: the contact begins when the centres are as far apart as the sum of the radii,
# lasts pi sqrt(m / K) with m = m1 m2 / (m1 + m2) and K = k (2 r)^2 of the smaller radius, and the velocities are those of an
# elastic hit, (m1 - m2) / (m1 + m2) v and 2 m1 / (m1 + m2) v, friction or not. Expected within 1 %.
#
# {ifndef(rb)}
# {rb = 0.01}
# {endif}
# {frame = 2e-4}
begin sierra two particles
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin particle section small
    radius = 0.01
  end
  begin particle section other
    radius = {rb}
  end

  begin finite element model particles
    database name = two_particles.g
    begin parameters for block flier
      material = steel
      model = elastic
      section = small
    end
    begin parameters for block target
      material = steel
      model = elastic
      section = other
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region particles
          user time step = 1e-6
          step interval = 1000
        end
      end
      termination time = 4e-3
    end

    begin presto region particles
      use finite element model particles

      begin initial velocity
        block = flier
        component = x
        magnitude = 1
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rub
          friction coefficient = 0.5
        end
        begin interaction defaults
          friction model = rub
          general contact = on
          penalty stiffness = 1e9
        end
      end

      begin user output
        block = flier
        compute global force as sum of nodal force_contact(x)
        compute global v_flier as average of nodal velocity(x)
        compute global x_flier as average of nodal coordinates(x)
      end
      begin user output
        block = target
        compute global v_target as average of nodal velocity(x)
        compute global x_target as average of nodal coordinates(x)
      end
      begin heartbeat output
        stream name = %B.csv
        global force v_flier v_target x_flier x_target
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
