# A bar of elastic-plastic steel, 1 x 0.2 x 0.2 m in 5 x 1 x 1 elements, pulled to a logarithmic strain of 1 % and let back (SI).
#
# Shows plasticity in load steps: trials of the search leave no trace in what the material remembers. Expected by hand: true
# stress (yield + H e) / (1 + H / E) at the strain e, and E times the strain less on the way back, within 1e-3 (elastic changes of
# the cross-section take part).
begin sierra static plastic bar
  begin material steel
    density = 7800
    begin parameters for model elastic_plastic
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 400e6
      hardening modulus = 2e9
    end
  end

  begin definition for function there_and_back
    type = piecewise linear
    begin values
      0 0
      1 {exp(0.01) - 1}
      2 {exp(0.009) - 1}
    end
  end

  begin finite element model bar
    database name = static_plastic_bar.g
    begin parameters for block bar
      material = steel
      model = elastic_plastic
    end
  end

  begin adagio procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region bar
          time increment = 0.1
        end
      end
      termination time = 2
    end

    begin adagio region bar
      use finite element model bar

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
        node set = on_z
        component = z
      end
      begin prescribed displacement
        node set = pulled
        component = x
        function = there_and_back
      end

      begin solver
        begin cg
          target relative residual = 1e-8
        end
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        element stress(xx) nearest location 0.5 0.1 0.1 as stress
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
