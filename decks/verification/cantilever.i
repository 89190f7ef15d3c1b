# The first bending vibration of a cantilever of solid elements, 1 x 0.1 x 0.05 m of steel, set off by a velocity that
# grows with the square of the distance from the clamped end.
#
# Shows bending with one element formulation and hourglass resistance: frequency 1.875104^2 / (2 pi) sqrt(E I / (rho A L^4))
# = 40.9 Hz by Euler and Bernoulli. Expected within 3 % with four elements over the thickness; shear and rotary inertia
# explain 0.1 % of it.
# With -D formulation=selective_deviatoric there is no hourglass resistance in it. -D form=face_face or node_face ties two halves
# of the beam to each other; expected within 1 % of the frequency of one mesh.
#
# With ten-node tetrahedra (-D formulation=composite_tet) the same, nearly incompressible (-D nu=0.499) as well.
#
# {ifndef(formulation)}
# {formulation = "mean_quadrature"}
# {endif}
# {ifndef(nu)}
# {nu = 0.0}
# {endif}
# {ifndef(form)}
# {form = "one"}
# {endif}
begin sierra cantilever
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = {nu}
    end
  end

  begin solid section beam
    formulation = {formulation}
  end

  begin definition for function kick
    type = analytic
    expression variable: x = nodal model_coordinates(x)
    evaluate expression = "0.1 * x * x"
  end

  begin finite element model beam
    database name = cantilever.g
    begin parameters for block
      include all blocks
      material = steel
      model = elastic
      section = beam
    end
  end

  begin presto procedure vibrate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region beam
          step interval = 1000
        end
      end
      termination time = 0.04
    end

    begin presto region beam
      use finite element model beam

      begin fixed displacement
        node set = clamped
        components = x y z
      end

      begin initial velocity
        include all blocks
        component = z
        function = kick
      end

{if(form != "one")}
      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          friction model = tied
          constraint formulation = {form}
        end
      end
{endif}

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 5
        nodal displacement(z) nearest location 1 0 0 as tip
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
