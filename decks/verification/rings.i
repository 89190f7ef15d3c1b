# Two elastic rings fly against each other at 30 m/s each (outer radius 10, inner 8, width 1; SI).
#
# Shows contact of curved bodies that bend, in contact with themselves too: momentum stays none, energy within 1 %, a head-on
# hit stays its own mirror image within 1e-8 until the rings part (round-off grows later), and no node gets deeper than a
# tenth of an element.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 0.02}
begin sierra rings
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0.3
    end
  end

  begin finite element model rings
    database name = rings.g
    begin parameters for block ring_a ring_b
      material = rubber
      model = elastic
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rings
          step interval = 1000
        end
      end
      termination time = 1.2
    end

    begin presto region rings
      use finite element model rings

      begin initial velocity
        block = ring_a
        component = x
        magnitude = 30
      end
      begin initial velocity
        block = ring_b
        component = x
        magnitude = -30
      end

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
        global contact_penetration_max as penetration
      end
      {include("results.inc")}
    end
  end
end sierra
