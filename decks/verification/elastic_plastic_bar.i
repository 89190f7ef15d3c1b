# An elastic-plastic plane wave: as confined_bar.i, but pushed at 100 m/s, far beyond yield.
#
# Shows the two fronts of a bilinear material in uniaxial strain (SI; E 200e9, nu 0.3, yield 400e6, hardening modulus
# H 10e9). The elastic precursor runs at sqrt((K + 4/3 G)/rho) and carries the yield stress s_e = Y (K + 4/3 G)/(2 G); the
# plastic front runs at sqrt((K + 4/3 G H/(3 G + H))/rho), behind it the stress is s_e + rho c_p (v - v_e), with
# v_e = s_e / (rho c_e). Expected: both arrivals at 0.5 m within 2 %, the stress within 1 %.
# Source: Davison, Fundamentals of Shock Wave Propagation in Solids (2008), elastic-plastic waves.
begin sierra elastic-plastic wave
  begin material steel
    density = 7800
    begin parameters for model elastic_plastic
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 400e6
      hardening modulus = 10e9
      beta = 1
    end
  end

  begin definition for function push
    type = constant
    begin values
      100.0
    end
  end

  begin finite element model bar
    database name = elastic_plastic_bar.g
    begin parameters for block bar
      material = steel
      model = elastic_plastic
    end
  end

  begin presto procedure push
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bar
        end
      end
      termination time = 1.6e-4
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
        element eqps nearest location 0.3 0 0 as eqps
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
