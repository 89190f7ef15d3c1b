# A steel brick, one of its edges ahead, flies at 10 m/s across the edge of another one, at a right angle, both free (SI).
#
# Shows sharp edges at the default FEATURE ANGLE: they meet as lines, at once, where faces alone would first let them pass through each other;
# what the contact has taken it gives back. Expected: first touch after 1 mm within 5 %, energy left in contact below 1 %.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 2e-5}
begin sierra crossed edges
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin finite element model bricks
    database name = crossed_edges.g
    begin parameters for block flier target
      material = steel
      model = elastic
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bricks
          step interval = 1000
        end
      end
      termination time = 6e-4
    end

    begin presto region bricks
      use finite element model bricks

      begin initial velocity
        block = flier
        component = z
        magnitude = -10
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
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
