# Two cubes of edge 1 that are free, the upper one lowered by 0.02 into the lower: the overlap comes in over 20 periods of
# their lengthwise vibration, is taken as just touching, or counts as a clearance (SI).
#
# Shows OVERLAP RAMP TIME, IGNORE INITIAL OVERLAP and INITIAL CLEARANCE in a run. Expected: pressed apart by the ramp, by the
# 0.02 at least and with less than 1 % of the 49.7 J of an overlap that counts at once, its work told as external; at rest for
# good where the overlap is ignored, or is a clearance.
# {ifndef(start)}
# {start = "overlap ramp time = 2.5"} {end_time = 2.5}
# {endif}
# {ifndef(form)}
# {form = "face_face"} {enforcement = "momentum_balance"}
# {endif}
# {frame = 0.05}
begin sierra press fit
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin finite element model cubes
    database name = press_fit.g
    begin parameters for block lower upper
      material = rubber
      model = elastic
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cubes
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region cubes
      use finite element model cubes

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          enforcement = {enforcement}
          {start}
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
