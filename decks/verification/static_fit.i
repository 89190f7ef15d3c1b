# A quarter of two steel rings in equilibrium, 10 and 20.0025 mm, 20 and 30 mm, plane strain (mm, N, MPa, t): the inner one is too
# wide by 0.0025 mm, which comes in over the load steps.
#
# Shows OVERLAP RAMP TIME in load steps, a press fit. Expected: Lame's pressure, E' d / b / ((b^2 + a^2) / (b^2 - a^2) + (c^2 + b^2) /
# (c^2 - b^2)) with E' = E / (1 - nu^2), within 1 % on the mean, and within 0.3 % where the surfaces are taken as round. With
# -D free_length=1 the length is free (plane stress), E' = E: CalculiX issue 98, 5.8594 MPa.
#
# {ifndef(free_length)}
# {free_length = 0}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(smoothing)}
# {smoothing = "off"}
# {endif}
# {frame = 1}
begin sierra static fit
  begin material steel
    density = 7.8e-9
    begin parameters for model elastic
      youngs modulus = 200e3
      poissons ratio = 0.3
    end
  end

  begin finite element model rings
    database name = static_fit.g
    begin parameters for block inner outer
      material = steel
      model = elastic
    end
  end

  begin adagio procedure fit
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region rings
          number of time steps = 2
        end
      end
      termination time = 1
    end

    begin adagio region rings
      use finite element model rings

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
{if(free_length)}
        node set = on_z
{else}
        include all blocks
{endif}
        component = z
      end

      begin contact definition
        contact surface inner_side contains inner_side
        contact surface outer_side contains outer_side
        begin interaction fit
          surfaces = inner_side outer_side
          constraint formulation = {form}
          smoothing = {smoothing}
          overlap ramp time = 1
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact contact_area
        nodal variables = contact_normal_traction_magnitude
        element variables = stress
      end
    end
  end
end sierra
