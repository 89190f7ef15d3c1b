# 64 loose particles of 10 mm fall into a box of shells without a lid, in 1000 g (SI; mu = 0.3). The box is held.
#
# Shows particles among themselves, on walls, edges and in corners: all stay in the box, the energy only falls, and in the
# end the box carries their weight within 2 %.
#
# {frame = 5e-4}
begin sierra box of particles
  begin material plastic
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.3
    end
  end

  begin particle section grain
    radius = 0.005
  end
  begin shell section wall
    number of integration points = 3
  end

  begin finite element model bodies
    database name = box_of_particles.g
    begin parameters for block grains
      material = plastic
      model = elastic
      section = grain
    end
    begin parameters for block box
      material = plastic
      model = elastic
      section = wall
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 20e-3
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        block = box
        components = x y z
      end
      begin fixed rotation
        block = box
        components = x y z
      end
      begin gravity
        block = grains
        component = z
        gravitational constant = -9810
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rub
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          self contact = on
          friction model = rub
          contact damping fraction = 0.2
        end
      end

      begin user output
        block = grains
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
