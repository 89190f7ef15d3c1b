# A stress wave through a bar with one short element: the bar flies against a wall that holds one of its ends.
#
# Shows SUBCYCLE BLOCKS: 199 elements and a tenth of one between them, block "short", whose stable step is a tenth of
# that of the others. The short one and three of its neighbours on either side, in whole batches of eight, are advanced
# in ten parts of each step, all others once. Expected as in wave_in_bar, with and without the line: the wave arrives
# after L/c, the free end has gone v L/c then (1 %); in each step the energy of the bar is that of its start (1 %), and
# the end of the bar is where it is without the line (1 % of v L/c: waves behind the front depend on the size of steps).
# SUBCYCLE BLOCKS = ALL finds the same by itself. Bulk viscosity is off, as in wave_in_bar. Of 60 elements energy is
# kept for 10^5 steps (1 %), and no vibration grows.
# {ifndef(subcycled)}
# {subcycled = 1}
# {endif}
# {ifndef(small)}
# {small = "short"}
# {endif}
# {ifndef(viscosity)}
# {viscosity = 0}
# {endif}
# {ifndef(end_time)}
# {end_time = 6e-6}
# {endif}
begin sierra wave in a graded bar
  begin material metal
    density = 7.8
    begin parameters for model elastic
      bulk modulus = 1e12
      shear modulus = 1.5e12
    end
  end

  begin finite element model bar
    database name = graded_bar.g
    begin parameters for block left short right
      material = metal
      model = elastic
      linear bulk viscosity = {0.06 * viscosity}
      quadratic bulk viscosity = {1.2 * viscosity}
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bar
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region bar
      use finite element model bar
      # {if(subcycled)}
      subcycle blocks = {small}
      # {endif}

      begin fixed displacement
        node set = wall
        components = x y z
      end

      begin initial velocity
        include all blocks
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
        global internal_energy as internal_energy
      end

      begin results output
        database name = %B.e
        at time 0 increment = {end_time / 6}
        nodal variables = displacement velocity
        element variables = stress
      end
    end
  end
end sierra
