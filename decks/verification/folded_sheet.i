# A steel cube of 0.05 m flies onto a held sheet, flat or folded, at -D speed (SI): face, edge or vertex first, as the mesh has it.
#
# Shows that contact neither lets a body through a thin sheet or the outside of a sharp fold, whatever it is in a step, nor makes
# energy. Expected: the cube turns round, no faster than it came, and contact gives out no energy.
#
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(thickness)}
# {thickness = 0.02}
# {endif}
# {ifndef(speed)}
# {speed = 5}
# {endif}
# {frame = 0.0075 / speed}
begin sierra folded sheet
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section wall
    thickness = {thickness}
    number of integration points = 3
  end

  begin finite element model bodies
    database name = folded_sheet.g
    begin parameters for block sheet
      material = steel
      model = elastic
      section = wall
    end
    begin parameters for block probe
      material = steel
      model = elastic
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
      termination time = {0.15 / speed}
    end

    begin presto region bodies
      use finite element model bodies

      begin initial velocity
        block = probe
        component = z
        magnitude = {-speed}
      end
      begin fixed displacement
        block = sheet
        components = x y z
      end
      begin fixed rotation
        block = sheet
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
        global contact_penetration_max as penetration
      end
      {include("results.inc")}
    end
  end
end sierra
