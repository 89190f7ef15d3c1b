# A free soft cube of eight elements, two faces of which are struck across, tumbles and vibrates at any amplitude it likes:
# nothing damps it but bulk viscosity.
#
# Shows that steps which follow the stable step of vibrating elements do not feed the vibration, and that the energies told
# are those that central differences conserve: near the stable step kinetic and strain energy of fast vibrations do not
# sum to a constant, by up to a tenth of it here. Expected: kinetic + internal energy as at the start within 1 %.
begin sierra twisted cube
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0.3
    end
  end

  begin finite element model cube
    database name = twisted_cube.g
    begin parameters for block cube
      material = rubber
      model = elastic
    end
  end

  begin presto procedure twist
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cube
          step interval = 20000
        end
      end
      termination time = 0.5
    end

    begin presto region cube
      use finite element model cube

      begin initial velocity
        node set = right
        component = y
        magnitude = 2
      end
      begin initial velocity
        node set = left
        component = y
        magnitude = -2
      end

      begin results output
        database name = %B.e
        at step 0 increment = 1
        global variables = kinetic_energy internal_energy energy_error
      end
    end
  end
end sierra
