# Point masses of 1 kg on springs between them and the ground, let go by velocities along the springs.
#
# Shows point masses, springs and dampers. plain: k = 1e4 N/m, so that the frequency is 100 / (2 pi) Hz. kinked: by a
# function, 1e4 N/m in tension and 4e4 N/m in compression, so that half the period is that of either. damped: beside the spring
# a damper of c = E A / l = 10 N s/m: frequency sqrt(100^2 - 5^2) / (2 pi) Hz, and amplitudes that fall by exp(-5 t).
# Expected within 0.1 %.
begin sierra springs
  begin spring section plain
    default stiffness = 1e4
  end
  begin spring section kinked
    force strain function = kinked
  end
  begin material oil
    density = 1e-6
    begin parameters for model elastic
      youngs modulus = 100
      poissons ratio = 0
    end
  end
  begin damper section damper
    area = 0.01
  end
  begin point mass section kilogram
    mass = 1
  end

  begin definition for function kinked
    type = piecewise linear
    begin values
      -1 -4e3
       0  0
       1  1e3
    end
  end

  begin finite element model springs
    database name = springs.g
    begin parameters for block plain
      section = plain
    end
    begin parameters for block damped
      section = plain
    end
    begin parameters for block kinked
      section = kinked
    end
    begin parameters for block damper
      material = oil
      model = elastic
      section = damper
    end
    begin parameters for block mass
      section = kilogram
    end
  end

  begin presto procedure swing
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region springs
          time step scale factor = 0.01
          step interval = 1000
        end
      end
      termination time = 1
    end

    begin presto region springs
      use finite element model springs

      begin fixed displacement
        node set = ground
        components = x y z
      end
      begin initial velocity
        node set = masses
        component = x
        magnitude = 0.1
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 0.1 0 0 as plain
        nodal displacement(x) nearest location 0.1 1 0 as kinked
        nodal displacement(x) nearest location 0.1 2 0 as damped
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
