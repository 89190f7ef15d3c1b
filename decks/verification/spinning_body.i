# A free block of unequal sides spins about an axis that is none of its own, through ten turns.
#
# Shows that rotation makes no strain and no angular momentum: of the motion of a free body the momentum, the angular
# momentum about the origin and the energy stay what they were, and stresses stay those that hold it together. A bar of
# length L that turns about its middle has rho omega^2 L^2 / 8 = 15 MPa there, and twice that as it is set off at once
# (SI); the stress of one spurious per cent of strain would be 2000 MPa. Expected: angular momentum within 1e-9, energy
# within 0.1 %, von Mises stress below 31 MPa.
begin sierra spinning body
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  define point centre with coordinates 0.1 0.05 0.025
  define direction skew with vector 1 2 3
  define axis spin with point centre direction skew

  begin finite element model body
    database name = spinning_body.g
    begin parameters for block body
      material = steel
      model = elastic
    end
  end

  begin presto procedure spin
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region body
          step interval = 20000
        end
      end
      termination time = 0.1
    end

    begin presto region body
      use finite element model body

      begin initial velocity
        block = body
        cylindrical axis = spin
        angular velocity = 628.3185307
      end

      begin results output
        database name = %B.e
        at time 0 increment = 0.02
        nodal variables = displacement velocity mass
        element variables = von_mises
        global variables = kinetic_energy internal_energy energy_error
      end
    end
  end
end sierra
