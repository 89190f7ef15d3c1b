# A cube of edge 0.4 moves at 1 m/s from 0.1 m above the face of a held sheet of 1.2 m, 0.1 thick, down to it, or from 0.1 m below
# its other face up to it (SI).
#
# Shows at default settings when the sides of a pair meet: SIDES, CONTACT OFFSET, INITIAL CLEARANCE, SEARCH DISTANCE, TRACKING
# DISTANCE. Expected: with TOP the cube from above meets the sheet after 0.1 m, the one from below passes it without a force;
# with an offset of 0.04 after 0.06, with a clearance of 0.15 after 0.15; with a search distance of 0.11 after 0.1, of 0.09
# never.
# {ifndef(line)}
# {line = "sides = top"} {direction = -1}
# {endif}
# {ifndef(form)}
# {form = "face_face"} {enforcement = "momentum_balance"}
# {endif}
# {frame = 0.005}
begin sierra cube on sheet
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0.3
    end
  end
  begin shell section sheet
    thickness = 0.1
  end

  begin finite element model bodies
    database name = cube_on_sheet.g
    begin parameters for block sheet
      material = rubber
      model = elastic
      section = sheet
    end
    begin parameters for block cube
      material = rubber
      model = elastic
    end
  end

  begin presto procedure meet
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 0.3
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        block = sheet
        components = x y z
      end
      begin fixed rotation
        block = sheet
        components = x y z
      end
      begin initial velocity
        block = cube
        component = z
        magnitude = {direction}
      end

      begin contact definition
        skin all blocks = on
        begin interaction
          side a = sheet
          side b = cube
          constraint formulation = {form}
          enforcement = {enforcement}
          {line}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        nodal displacement(z) nearest location 0.6 0.6 {direction < 0 ? 0.15 : -0.15} as way
        global contact_force_cube(z) as force
      end
      {include("results.inc")}
    end
  end
end sierra
