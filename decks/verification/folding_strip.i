# The legs of a hairpin are thrown against each other (SI).
#
# Shows self contact: with it the legs meet and part again, no deeper than half an element, with forces and
# momentum in balance; with -D self=off they pass through each other. -D thickness=t makes the hairpin of shells.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(self)}
# {self = "on"}
# {endif}
# {ifndef(thickness)}
# {thickness = 0}
# {endif}
# {frame = 2e-3}
begin sierra folding strip
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0.3
    end
  end

{if(thickness > 0)}
  begin shell section sheet
    thickness = {thickness}
    number of integration points = 3
  end
{endif}

  begin finite element model strip
    database name = folding_strip.g
    begin parameters for block strip
      material = rubber
      model = elastic
{if(thickness > 0)}
      section = sheet
{endif}
    end
  end

  begin presto procedure fold
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region strip
          step interval = 1000
        end
      end
      termination time = 0.12
    end

    begin presto region strip
      use finite element model strip

      begin initial velocity
        node set = upper
        component = y
        magnitude = -20
      end
      begin initial velocity
        node set = lower
        component = y
        magnitude = 20
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = off
          self contact = {self}
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
