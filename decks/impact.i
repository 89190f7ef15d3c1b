# A steel ball hits an aluminium plate at a slant, with general contact and friction.
#
# The ball (10 mm radius) comes down at 45 degrees and 80 m/s onto a plate of 60 x 40 x 4 mm whose rim is held (SI). The
# plate yields: a scar stays, the ball is thrown back slower and, by friction, spinning. What it shows: a patch of the
# plate (the side set "target") is named before the skins and so owns its faces; every surface meets every other; the
# ball's pair with the patch has its own friction. Expected at the end: energy balance below 0.1 %, the ball's upward
# velocity positive, friction and plastic work both a good part of what the ball has lost.
#   contactsim impact.i impact.g
#
# {ifndef(speed)}
# {speed = 80}
# {endif}
begin sierra ball on plate
  define direction slant with vector 1 0 -1

  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 210e9
      poissons ratio = 0.3
    end
  end

  begin material aluminium
    density = 2700
    begin parameters for model elastic_plastic
      youngs modulus = 70e9
      poissons ratio = 0.33
      yield stress = 250e6
      hardening modulus = 500e6
    end
  end

  begin solid section soft_hourglass
    formulation = mean_quadrature
  end

  begin finite element model parts
    database name = impact.g
    begin parameters for block plate
      material = aluminium
      model = elastic_plastic
      section = soft_hourglass
      hourglass stiffness = 0.02
    end
    begin parameters for block ball
      material = steel
      model = elastic
    end
  end

  begin presto procedure hit
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region parts
          step interval = 200
        end
      end
      termination time = 120e-6
    end

    begin presto region parts
      use finite element model parts

      begin fixed displacement
        node set = rim
        components = x y z
      end
      begin initial velocity
        block = ball
        direction = slant
        magnitude = {speed}
      end

      begin contact definition
        contact surface patch contains target
        skin all blocks = on
        begin constant friction model steel_on_aluminium
          friction coefficient = 0.3
        end
        begin constant friction model dry
          friction coefficient = 0.1
        end
        begin interaction defaults
          general contact = on
          self contact = on
          friction model = dry
        end
        begin interaction ball_on_patch
          surfaces = patch ball
          friction model = steel_on_aluminium
        end
      end

      begin results output
        database name = %B.e
        at time 0 increment = 4e-6
        nodal displacement
        nodal velocity
        nodal force_contact
        nodal contact_status
        nodal contact_normal_traction_magnitude as pressure
        nodal contact_tangential_traction_magnitude as friction_traction
        nodal contact_accumulated_slip as slip
        element von_mises
        element eqps
      end

      begin heartbeat output
        stream name = %B.csv
        at time 0 increment = 2e-6
        global kinetic_energy as kinetic
        global internal_energy as internal
        global friction_energy as friction
        global energy_error as error
        global contact_force_ball as force
        global momentum as momentum
      end
    end
  end
end sierra
