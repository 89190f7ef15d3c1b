# Bars of steel in uniaxial stress that are pulled at 10 m/s until they are torn apart: a hexahedron, a shell and a truss of
# 1 m (SI).
#
# Shows hardening along a curve, tearing and MATERIAL CRITERION: in uniaxial stress the tearing parameter is the plastic
# strain p, so that a crack begins to open at p = 0.15, at the strain p + S(p) / E with S(p) the flow stress. Then the stress
# falls with the strain across the crack, and nothing is left 0.06 later, at the length exp(0.21 + S(0.15) / E) times that
# at rest. Expected: the flow stress at p = 0.1, half of it when the crack is half open, and death within 0.2 % of the time at
# which the last length is reached; energy is kept after it. The sheet has no viscosity: it would push across the pull, to
# which the tearing parameter answers with the fourth power.
begin sierra tearing bar
  begin definition for function hardening
    type = piecewise linear
    begin values
      0.00  0.0
      0.05  60e6
      0.20 120e6
      1.00 200e6
    end
  end

  begin material steel
    density = 7800
    begin parameters for model ml_ep_fail
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 300e6
      beta = 1.0
      hardening function = hardening
      critical tearing parameter = 0.15
      critical crack opening strain = 0.06
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
    database name = tearing_bar.g
    begin parameters for block bar
      material = steel
      model = ml_ep_fail
    end
    begin parameters for block sheet
      material = steel
      model = ml_ep_fail
      section = sheet
      linear bulk viscosity = 0
    end
    begin parameters for block wire
      material = steel
      model = ml_ep_fail
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
        element stress(xx) nearest location 0.5 0.05 0.05 as bar_stress
        element memb_stress(xx) nearest location 0.5 0.05 3 as sheet_stress
        element stress(xx) nearest location 0.5 0 5 as wire_stress
        element damage nearest location 0.5 0.05 0.05 as damage
        element tearing_parameter nearest location 0.5 0.05 0.05 as tearing
        element eqps nearest location 0.5 0.05 0.05 as eqps
      end
    end
  end
end sierra
