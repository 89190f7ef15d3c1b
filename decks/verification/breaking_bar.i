# Bars of steel in uniaxial stress that are pulled at 10 m/s until their material fails: a hexahedron, a shell and a truss
# of 1 m (SI).
#
# Shows failure by a law itself and MATERIAL CRITERION: in uniaxial stress the triaxiality is 1/3 from the first flow on, so
# that Johnson-Cook breaks at the plastic strain e = D1 + D2 exp(D3 / 3), at the length exp(e + (A + B e^N) / E) times that
# at rest. Expected: death within 0.2 % of the time at which that length is reached; damage 1 there; momentum and
# energy are kept after it.
begin sierra breaking bar
  begin material steel
    density = 7800
    begin parameters for model johnson_cook
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 300e6
      hardening constant = 400e6
      hardening exponent = 0.5
      d1 = 0.05
      d2 = 0.3
      d3 = -2
    end
  end

  begin shell section sheet
    thickness = 0.1
    number of integration points = 3
  end
  begin truss section wire
    area = 0.01
  end

  begin definition for function steady
    type = constant
    begin values
      1.0
    end
  end

  begin finite element model bars
    database name = breaking_bar.g
    begin parameters for block bar
      material = steel
      model = johnson_cook
    end
    begin parameters for block sheet
      material = steel
      model = johnson_cook
      section = sheet
    end
    begin parameters for block wire
      material = steel
      model = johnson_cook
      section = wire
    end
  end

  begin presto procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bars
          step interval = 10000
        end
      end
      termination time = 0.03
    end

    begin presto region bars
      use finite element model bars

      begin fixed displacement
        node set = held
        component = x
      end
      begin fixed displacement
        node set = side
        component = y
      end
      begin fixed displacement
        node set = floor
        component = z
      end
      begin fixed rotation
        block = sheet
        components = x y z
      end
      begin prescribed velocity
        node set = pulled
        component = x
        function = steady
        scale factor = 10
      end

      begin element death broken
        include all blocks
        material criterion = on
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        element death_status nearest location 0.5 0.05 0.05 as bar
        element death_status nearest location 0.5 0.05 3 as sheet
        element death_status nearest location 0.5 0 5 as wire
        element damage nearest location 0.5 0.05 0.05 as damage
      end
    end
  end
end sierra
