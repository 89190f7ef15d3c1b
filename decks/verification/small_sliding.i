# A block of edge 0.25 that lies on the first of four faces in a row slides along them by 0.7, without friction (SI).
#
# Shows INTERACTION BEHAVIOR = INFINITESIMAL_SLIDING: the block meets the face that it lay on, and the plane of that face
# where it has slid off it. Expected: its nodes stay within 0.001 of the plane, it keeps its speed of 1 m/s within 0.1 %, and
# its weight of 153.28 N rests on the row within 1 % on the average.
# {ifndef(form)}
# {form = "face_face"} {enforcement = "momentum_balance"} {behavior = "infinitesimal_sliding"} {damping = 0}
# {endif}
# {frame = 0.07}
begin sierra small sliding
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin finite element model blocks
    database name = small_sliding.g
    begin parameters for block row slider
      material = rubber
      model = elastic
    end
  end

  begin presto procedure slide
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = 0.7
    end

    begin presto region blocks
      use finite element model blocks

      begin initial velocity
        block = slider
        component = x
        magnitude = 1
      end
      begin gravity
        block = slider
        component = z
        gravitational constant = -9.81
      end
      begin fixed displacement
        block = row
        components = x y z
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          enforcement = {enforcement}
          interaction behavior = {behavior}
          contact damping fraction = {damping}
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
