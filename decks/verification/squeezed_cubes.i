# The halves of a cube of 8 m run into each other at 1 m/s; each is of four blocks of unlike meshes that move along z only
# (SI; after NimbleSM's cubes_contact).
#
# Shows contact across meshes that do not match anywhere. Until the waves are back the force is rho cp v / 2 over 64 m2.
# Expected within 15 %; NimbleSM's own number, 1.62841e9 N after 10 microseconds, is its penalty's on elements of a metre.
# {frame = 5e-5}
begin sierra squeezed cubes
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin finite element model cubes
    database name = squeezed_cubes.g
    begin parameters for block
      include all blocks
      material = steel
      model = elastic
    end
  end

  begin presto procedure squeeze
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cubes
          step interval = 5000
        end
      end
      termination time = 1.2e-3
    end

    begin presto region cubes
      use finite element model cubes

      begin fixed displacement
        include all blocks
        components = x y
      end
      begin initial velocity
        block = upper_1 upper_2 upper_3 upper_4
        component = z
        magnitude = -1
      end

      begin contact definition
        contact surface above contains upper_1 upper_2 upper_3 upper_4
        contact surface below contains lower_1 lower_2 lower_3 lower_4
        begin interaction squeeze
          surfaces = above below
        end
      end

      begin user output
        block = lower_1 lower_2 lower_3 lower_4
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
