# Sheets, beams and particles that lie 0.02 deep in a block or a sheet: INITIAL OVERLAP REMOVAL moves them out (SI).
#
# Expected: sheets and what they lie in part by half the depth each, beams and particles go all the way; nothing moves aside,
# bodies touch afterwards, and contact has neither force nor energy in the steps that follow.
#
# {ifndef(form)}
# {form = "face_face"} {base = "solid"} {top = "sheet"}
# {endif}
# {frame = 1e-4}
begin sierra overlap of lofts
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin shell section sheet
    thickness = 0.1
  end
  begin beam section rod
    section = rod
    width = 0.1
    height = 0.1
    t axis = 0 0 1
  end
  begin particle section ball
    radius = 0.05
  end

  begin finite element model bodies
    database name = overlap_of_lofts.g
    begin parameters for block base
      material = rubber
      model = elastic
{if(base == "sheet")}
      section = sheet
{endif}
    end
    begin parameters for block top
      material = rubber
      model = elastic
      section = {top}
    end
  end

  begin presto procedure rest
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 2e-3
    end

    begin presto region bodies
      use finite element model bodies

      begin contact definition
        skin all blocks = on
        initial overlap removal = on
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
