# A steel block hits a plate one element thick at 300 m/s; the plate is held (SI).
#
# Shows that nothing tunnels: the block turns round, and no node of it gets through the plate.
# -D thickness=t makes the plate of shells. -D flier=plate throws the plate at the block, which is held in its place.
#
# {ifndef(thickness)}
# {thickness = 0}
# {endif}
# {ifndef(speed)}
# {flier = "block"} {target = "plate"} {speed = -300}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 1e-6}
begin sierra fast block
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

{if(thickness > 0)}
  begin shell section plate
    thickness = {thickness}
    number of integration points = 3
  end
{endif}

  begin finite element model bodies
    database name = fast_block.g
    begin parameters for block block
      material = steel
      model = elastic
    end
    begin parameters for block plate
      material = steel
      model = elastic
{if(thickness > 0)}
      section = plate
{endif}
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 20e-6
    end

    begin presto region bodies
      use finite element model bodies

      begin initial velocity
        block = {flier}
        component = z
        magnitude = {speed}
      end
      begin fixed displacement
        block = {target}
        components = x y z
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
