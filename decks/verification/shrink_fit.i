# Two elastic rings of 24 and 36 elements round, the inner one 0.001 too wide for the outer (radii 0.5, 1, 1.5, width 0.2, SI):
# the interference comes in over many periods of their breathing.
#
# Shows SMOOTHING in a run at default settings. Expected: the pressure of thick cylinders after Lame, E d / b (b^2 - a^2)
# (c^2 - b^2) / (2 b^2 (c^2 - a^2)), within 3 % on the mean and at every node; without smoothing facets press at corners
# alone, and their overlap by up to 8 times the interference comes in too. With NODE_FACE single nodes carry up to 3.2 % less:
# their forces bend the elastic faces between them.
# {ifndef(smoothing)}
# {smoothing = "auto"}
# {endif}
# {ifndef(form)}
# {form = "face_face"} {enforcement = "momentum_balance"}
# {endif}
# {frame = 0.02}
begin sierra shrink fit
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.3
    end
  end

  begin finite element model rings
    database name = shrink_fit.g
    begin parameters for block inner outer
      material = rubber
      model = elastic
    end
  end

  begin presto procedure fit
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rings
          step interval = 1000
        end
      end
      termination time = 0.2
    end

    begin presto region rings
      use finite element model rings

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          enforcement = {enforcement}
          smoothing = {smoothing}
          overlap ramp time = 0.1
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
