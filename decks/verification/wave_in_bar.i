# A stress wave in a bar: an elastic bar flies against a wall that holds one of its ends.
#
# Shows the wave speed and the energy balance without contact. The free end goes on at v until the wave arrives after
# L/c = 3.22490e-6 s, so that its largest displacement is v L/c = 3.22490e-3 cm, c = sqrt(E/rho) (cm-g-s; nu = 0).
# Bulk viscosity is off: it would round the tip of that triangle. Expected within 1 %. Source: NimbleSM, wave_in_bar.
begin sierra wave in a bar
  begin material metal
    density = 7.8
    begin parameters for model elastic
      bulk modulus = 1e12
      shear modulus = 1.5e12
    end
  end

  begin finite element model bar
    database name = wave_in_bar.g
    begin parameters for block bar
      material = metal
      model = elastic
      linear bulk viscosity = 0
      quadratic bulk viscosity = 0
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bar
          step interval = 50
        end
      end
      termination time = 6e-6
    end

    begin presto region bar
      use finite element model bar

      begin fixed displacement
        node set = wall
        components = x y z
      end

      begin initial velocity
        block = bar
        component = x
        magnitude = 1000
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 2 0 0 as tip
        global energy_error as energy_error
        global external_energy as external_energy
        global kinetic_energy as kinetic_energy
      end

      begin results output
        database name = %B.e
        at time 0 increment = 5e-7
        nodal variables = displacement velocity
        element variables = stress
      end
    end
  end
end sierra
