# Taylor's test: a copper rod flies against a rigid wall at 227 m/s and mushrooms. A quarter of the rod, 3.2 mm thick and
# 32.4 mm long; the wall is the plane z = 0, where the rod's nodes are held along z and free to slide (SI).
#
# Shows large plastic strain, the energy balance, and results that ParaView opens. Expected after 80 microseconds: a length
# of 21.5 mm and a foot of 7.1 mm radius, each within 3 %; published codes range from 21.4 to 21.7 and 6.9 to 7.3 mm.
# Hourglass resistance follows the elastic shear modulus, which is far too stiff for metal that flows: with the default of
# 0.05 the foot spreads to 6.5 mm only.
begin sierra taylor bar
  begin material copper
    density = 8930
    begin parameters for model elastic_plastic
      youngs modulus = 117e9
      poissons ratio = 0.35
      yield stress = 400e6
      hardening modulus = 100e6
      beta = 1
    end
  end

  begin finite element model rod
    database name = taylor_bar.g
    begin parameters for block core east north
      material = copper
      model = elastic_plastic
      hourglass stiffness = 0.002
    end
  end

  begin presto procedure impact
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rod
          step interval = 200
        end
      end
      termination time = 80e-6
    end

    begin presto region rod
      use finite element model rod

      begin fixed displacement
        node set = wall
        component = z
      end
      begin fixed displacement
        node set = on_x
        component = y
      end
      begin fixed displacement
        node set = on_y
        component = x
      end

      begin initial velocity
        include all blocks
        component = z
        magnitude = -227
      end

      begin results output
        database name = %B.e
        at time 0 increment = 5e-6
        nodal variables = displacement velocity
        element variables = stress von_mises eqps
      end

      begin heartbeat output
        stream name = %B.csv
        at time 0 increment = 1e-6
        nodal coordinates(z) nearest location 0 0 0.0324 as length
        nodal coordinates(x) nearest location 0.0032 0 0 as foot_radius
        global kinetic_energy as kinetic_energy
        global internal_energy as internal_energy
        global hourglass_energy as hourglass_energy
        global energy_error as energy_error
      end
    end
  end
end sierra
