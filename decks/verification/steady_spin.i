# A free cube of 20 mm spins about an axis that is none of its own at 1000 rad/s, through twenty turns.
#
# Shows that stresses and hourglass forces turn with the material without doing work: what they are off by while they turn
# is a circulatory force, that makes vibrations grow out of nothing. Set off at once, the cube breathes by the stress that
# holds it together, rho omega^2 L^2 / 8 = 0.135 MPa (SI); that holds 4e-5 of its energy. Expected: kinetic + internal
# energy as at the start within 0.1 %, the internal energy below 0.1 % of it and never below zero by as much.
# {ifndef(formulation)}
# {formulation = "mean_quadrature"}
# {endif}
begin sierra steady spin
  begin material light
    density = 2700
    begin parameters for model elastic
      youngs modulus = 7e9
      poissons ratio = 0.3
    end
  end

  define point centre with coordinates 0.01 0.01 0.01
  define direction skew with vector 1 2 3
  define axis spin with point centre direction skew

  begin solid section cube
    formulation = {formulation}
  end

  begin finite element model cube
    database name = steady_spin.g
    begin parameters for block cube
      material = light
      model = elastic
      section = cube
    end
  end

  begin presto procedure spin
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cube
          step interval = 20000
        end
      end
      termination time = 0.126
    end

    begin presto region cube
      use finite element model cube

      begin initial velocity
        block = cube
        cylindrical axis = spin
        angular velocity = 1000
      end

      begin results output
        database name = %B.e
        at step 0 increment = 10
        global variables = kinetic_energy internal_energy energy_error
      end
    end
  end
end sierra
