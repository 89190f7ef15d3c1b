# Ten rigid bricks of 0.2 x 0.1 x 0.1 m stand on each other and on the analytic plane z = 0, under gravity, with friction of
# 0.5 (SI). Every second one is turned across the one below.
#
# Shows that momentum balance carries a stack of bodies that cannot give way: the plane bears the weight of all, each joint
# that of what is above. Expected over one second: the weight within 0.1 %, nothing moves by more than 1e-4 m or faster than
# 1e-2 m/s, no energy appears.
#
# {n = 10} {frame = 0.02}
begin sierra rigid stack
  begin material brick
    density = 2000
    begin parameters for model elastic
      youngs modulus = 1e10
      poissons ratio = 0.2
    end
  end

# {loop(n, i, 1)}
  begin rigid body body_{i}
  end
  begin solid section section_{i}
    rigid body = body_{i}
  end
# {endloop}

  begin finite element model bricks
    database name = rigid_stack.g
# {loop(n, i, 1)}
    begin parameters for block brick_{i}
      material = brick
      model = elastic
      section = section_{i}
    end
# {endloop}
  end

  begin presto procedure stand
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bricks
          step interval = 10000
        end
      end
      termination time = 1
    end

    begin presto region bricks
      use finite element model bricks

      begin gravity
        include all blocks
        component = z
        gravitational constant = -9.81
      end

      begin analytic object plane_z
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        skin all blocks = on
        contact surface ground contains plane_z
        begin constant friction model rough
          friction coefficient = 0.5
        end
        begin interaction defaults
          general contact = on
          friction model = rough
        end
      end

      begin user output
        block = brick_1
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
