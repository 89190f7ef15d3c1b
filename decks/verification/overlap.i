# Two cubes of edge 1, the upper one lowered by 0.02 into the lower: INITIAL OVERLAP REMOVAL moves it out (SI).
#
# Expected: a gap of no less than -1e-6 of an element, nodes that moved along the normal only, by 0.02 in all, and no stress
# and no force afterwards.
# {frame = 1e-4}
begin sierra overlap
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin finite element model cubes
    database name = overlap.g
    begin parameters for block lower upper
      material = rubber
      model = elastic
    end
  end

  begin presto procedure rest
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cubes
          step interval = 1000
        end
      end
      termination time = 2e-3
    end

    begin presto region cubes
      use finite element model cubes

      begin contact definition
        skin all blocks = on
        initial overlap removal = on
        begin interaction defaults
          general contact = on
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
