# Small bodies side by side, each of which remembers something else: what a run that goes on from a stored state must know.
#
# A block hits a plastic anvil at a slant (faces on faces, friction, J2 plasticity); another does so nodes on faces; two
# blocks are tied, two are held by a cohesive zone until it tears; a rigid brick falls on a shell sheet, a rod of beams
# across another rod. -D at=t goes on from the state of time t, -D goes_on=1 from the last one there is. Expected: what the
# run writes from there on is the same, bit for bit, as what the straight run writes, with one thread and with two; and
# however often a run is killed, the last state that it has stored is whole.
#
# {ifndef(at)}
# {at = 0}
# {endif}
# {ifndef(goes_on)}
# {goes_on = 0}
# {endif}
# {ifndef(stored)}
# {stored = 20}
# {endif}
# {ifndef(end)}
# {end = 1.2e-4}
# {endif}
begin sierra restart
# {if(goes_on)}
  restart = automatic
# {endif}
# {if(at > 0)}
  restart time = {at}
# {endif}
  define direction down with vector 0 0 -1
  define direction slant with vector 1 0 -1

  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
    begin parameters for model elastic_plastic
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 200e6
      hardening modulus = 1e9
    end
  end

  begin shell section sheet
    thickness = 0.5e-3
    number of integration points = 3
  end
  begin beam section rod
    section = rod
    width = 0.5e-3
    height = 0.5e-3
    t axis = 0 0 1
  end
  begin rigid body brick
  end
  begin solid section brick
    rigid body = brick
  end

  begin definition for function traction
    type = piecewise linear
    begin values
      0 0
      0.1 1
      1 0
    end
  end
  begin definition for function next
    type = analytic
    expression variable: n = global count
    evaluate expression = "n + 1"
  end

  begin finite element model bodies
    database name = restart.g
    begin parameters for block anvil floor
      material = steel
      model = elastic_plastic
    end
    begin parameters for block hammer slider low high left right
      material = steel
      model = elastic
    end
    begin parameters for block sheet
      material = steel
      model = elastic_plastic
      section = sheet
    end
    begin parameters for block brick
      material = steel
      model = elastic
      section = brick
    end
    begin parameters for block rod rail
      material = steel
      model = elastic
      section = rod
    end
  end

  begin presto procedure p
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region r
          step interval = 100
        end
      end
      termination time = {end}
    end

    begin presto region r
      use finite element model bodies

      begin fixed displacement
        node set = held
        components = x y z
      end
      begin initial velocity
        block = hammer slider
        direction = slant
        magnitude = 60
      end
      begin initial velocity
        block = brick rod high
        direction = down
        magnitude = 30
      end
      begin initial velocity
        block = right
        component = x
        magnitude = 40
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rough
          friction coefficient = 0.3
        end
        begin tied model tie
        end
        begin cohesive zone model glue
          traction displacement function = traction
          traction displacement scale factor = 2e7
          critical normal gap = 1e-3
          critical tangential gap = 1e-3
        end
        begin interaction defaults
          general contact = on
          self contact = on
          friction model = rough
        end
        begin interaction
          surfaces = slider floor
          friction model = rough
          constraint formulation = node_face
        end
        begin interaction
          surfaces = high low
          friction model = tie
        end
        begin interaction
          surfaces = left right
          friction model = glue
        end
      end

      begin user variable count
        type = global real length = 1
        initial value = 0
      end
      begin user output
        compute at every step
        compute global count as function next
      end

      begin restart data
        at step 0 increment = {stored}
        cycle count = 80
      end
      begin results output
        database name = %B.e
        at time 0 increment = 5e-6
        nodal displacement
        nodal velocity
        nodal acceleration
        nodal force_contact
        nodal contact_accumulated_slip
        nodal rotational_displacement
        element stress
        element eqps
      end
      begin history output
        database name = %B.h
        at step 0 increment = 1
        global timestep
        global kinetic_energy
        global internal_energy
        global contact_energy
        global friction_energy
        global energy_error
        global count
        global contact_force_hammer
        global contact_force_slider
        global displz_brick
      end
      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global count as count
      end
    end
  end
end sierra
