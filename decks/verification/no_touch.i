# Bodies that do not touch: a plate one element thick and cubes that share an edge, in contact with themselves, and two
# blocks that are 1e-9 of an element apart, at rest or in flight, turning as one (SI).
#
# Shows that no force comes from nothing. Expected: none at all.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(spin)}
# {spin = 0}
# {endif}
# {frame = 1e-3}
begin sierra nothing touches
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  define point centre with coordinates 0 0 0
  define direction skew with vector 1 2 3
  define axis spin_axis with point centre direction skew

  begin finite element model bodies
    database name = no_touch.g
    begin parameters for block
      include all blocks
      material = steel
      model = elastic
    end
  end

  begin presto procedure rest
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 5000
        end
      end
      termination time = 0.01
    end

    begin presto region bodies
      use finite element model bodies

{if(spin != 0)}
      begin initial velocity
        include all blocks
        cylindrical axis = spin_axis
        angular velocity = {spin}
      end
{endif}

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          self contact = on
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
