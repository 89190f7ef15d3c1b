# A block of 1 kg on a spring of 1e4 N/m, which slides on a rough plane: mu = 0.1, g = 10 (SI; code_aster SDND100).
#
# Shows friction that reverses and holds. The block is held while its spring is drawn by 0.85 mm, then let go at 10 ms.
# Each half swing of pi sqrt(m / k) loses 2 mu m g / k = 0.2 mm: it turns at -0.65, 0.45, -0.25 and 0.05 mm, where it stays.
# Expected: places within 5 micrometres, times within 0.5 %.
# {frame = 2e-3}
begin sierra spring and friction
  begin material stiff
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0
    end
  end
  begin material soft
    density = 0.1
    begin parameters for model elastic
      youngs modulus = 1e5
      poissons ratio = 0
    end
  end

  begin definition for function draw
    type = piecewise linear
    begin values
      0 0
      8e-3 -0.85e-3
      1 -0.85e-3
    end
  end

  begin finite element model parts
    database name = spring_and_friction.g
    begin parameters for block slider
      material = stiff
      model = elastic
    end
    begin parameters for block spring
      material = soft
      model = elastic
    end
  end

  begin presto procedure swing
    begin time control
      begin time stepping block drawn
        start time = 0
        begin parameters for presto region parts
          step interval = 5000
        end
      end
      begin time stepping block free
        start time = 0.01
        begin parameters for presto region parts
          step interval = 5000
        end
      end
      termination time = 0.16
    end

    begin presto region parts
      use finite element model parts

      begin fixed displacement
        block = slider
        component = x
        active periods = drawn
      end
      begin prescribed displacement
        node set = wall
        component = x
        function = draw
      end
      begin fixed displacement
        block = spring
        component = y
      end
      begin gravity
        block = slider
        component = z
        gravitational constant = -10
      end

      begin analytic object ground
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        contact surface under contains slider
        contact surface floor contains ground
        begin constant friction model rub
          friction coefficient = 0.1
        end
        begin interaction slide
          surfaces = under floor
          friction model = rub
          contact damping fraction = 0.5
        end
      end

      begin user output
        block = slider
        compute global x as average of nodal displacement(x)
      end
      begin heartbeat output
        stream name = %B.csv
        global x
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
