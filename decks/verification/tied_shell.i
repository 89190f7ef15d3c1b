# A sheet of shells is tied to a block, or to another sheet, with meshes that do not match, and the two turn as one about a
# skew axis (SI).
#
# Shows a tie at the side of a shell, half its thickness off its nodes: nothing is strained but by the turning, the sheet
# stays where it is on the block, angular momentum stays, and the tie neither takes nor makes energy.
# Expected: sheet and block no farther apart than at the start by 1e-3 of the thickness, energy of contact below 1e-5 of the
# kinetic energy, also after many turns of the vibrations, out of which skins that do not turn with their nodes would draw
# energy.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(base)}
# {base = "block"}
# {endif}
# {ifndef(end_time)}
# {end_time = 20e-3}
# {endif}
# {frame = end_time / 20}
begin sierra tied shell
  define point centre with coordinates 0 0 0
  define direction skew with vector 1 2 3
  define axis spin_axis with point centre direction skew

  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section sheet
    thickness = 0.02
    number of integration points = 3
  end

  begin finite element model bodies
    database name = tied_shell.g
    begin parameters for block sheet
      material = steel
      model = elastic
      section = sheet
    end
    begin parameters for block base
      material = steel
      model = elastic
{if(base == "sheet")}
      section = sheet
{endif}
    end
  end

  begin presto procedure turn
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region bodies
      use finite element model bodies

      begin initial velocity
        include all blocks
        cylindrical axis = spin_axis
        angular velocity = 50
      end

      begin contact definition
        contact surface above contains sheet
        contact surface below contains base
        begin interaction hold
          surfaces = above below
          friction model = tied
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact
        nodal variables = rotational_velocity rotational_mass
      end
    end
  end
end sierra
