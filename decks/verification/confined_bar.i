# A plane wave: the end of a bar that cannot widen is pushed at a constant velocity v = 1 m/s.
#
# Shows the speed of pressure waves, c = sqrt((K + 4/3 G) / rho) = 5875.2 m/s in steel (SI): the front passes the middle
# of the bar of 1 m after 0.5 m / c, and the stress behind it is -rho c v. Expected: arrival within 1 %, stress within
# 1 %. The mesh is confined_bar.g; refined meshes show both converge.
begin sierra plane wave
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin definition for function push
    type = constant
    begin values
      1.0
    end
  end

  begin finite element model bar
    database name = confined_bar.g
    begin parameters for block bar
      material = steel
      model = elastic
    end
  end

  begin presto procedure push
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bar
        end
      end
      termination time = 1.5e-4
    end

    begin presto region bar
      use finite element model bar

      begin fixed displacement
        include all blocks
        components = y z
      end

      begin prescribed velocity
        node set = pushed
        component = x
        function = push
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal velocity(x) nearest location 0.5 0 0 as middle_velocity
        element stress(xx) nearest location 0.3 0 0 as stress
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
