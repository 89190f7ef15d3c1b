# A steel cube of 0.1 m falls by 10 mm onto a held plate of steel and bounces for 0.3 s, more than 30,000 steps (SI).
#
# Shows that contact keeps its books in the long run, without any viscosity: what it takes at a hit it gives back, as the
# elastic penalty, or has lost and tells, as momentum balance; it never gives more. Deformation keeps a part of each flight
# as vibration, which is energy all the same.
# Expected: with ENFORCEMENT = PENALTY contact has no more than 1 % of m g h outside of hits; momentum balance never gives out
# more than 0.1 % of m g h, and what it takes is contact_impact_energy to that share.
#
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 0.03}
begin sierra bouncing block
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin finite element model blocks
    database name = bouncing_block.g
    begin parameters for block cube plate
      material = steel
      model = elastic
      linear bulk viscosity = 0
      quadratic bulk viscosity = 0
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 10000
        end
      end
      termination time = 0.3
    end

    begin presto region blocks
      use finite element model blocks

      begin gravity
        block = cube
        component = z
        gravitational constant = -9.81
      end
      begin fixed displacement
        node set = bottom
        components = x y z
      end

      begin contact definition
        skin all blocks = on
        enforcement = {enforcement}
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_impact_energy as impact_energy
        global contact_force_cube(z) as force
      end
      {include("results.inc")}
    end
  end
end sierra
