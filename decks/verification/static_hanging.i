# A block, or -D stack=2 blocks in a row, that nothing holds, hangs above another one at a gap of 0.05 each, a tenth of its height,
# and is pressed down by a pressure of 1000 on its top, E = 1e6 (SI), without friction.
#
# Shows CONTACT STABILIZATION: what contact alone will hold comes to rest against it in ten load steps or in one, and nothing of the
# stabilization is left as the time stepping block ends. Expected: force and displacement of the same blocks that are held along the axis
# (-D guided=1 -D stabilization=0) within 1e-4, to which forces are balanced, whatever the coefficient.
#
# {ifndef(stack)}
# {stack = 1}
# {endif}
# {ifndef(guided)}
# {guided = 0}
# {endif}
# {ifndef(stabilization)}
# {stabilization = 1}
# {endif}
# {ifndef(steps)}
# {steps = 10}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 1}
begin sierra hanging blocks
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model blocks
    database name = static_hanging.g
{if(stack == 2)}
    begin parameters for block lower between upper
{else}
    begin parameters for block lower upper
{endif}
      material = rubber
      model = elastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region blocks
          number of time steps = {steps}
        end
      end
      termination time = 1
    end

    begin adagio region blocks
      use finite element model blocks

      begin fixed displacement
        node set = bottom
        components = x y z
      end
{if(guided)}
      begin fixed displacement
        node set = axis
        components = x y
      end
      begin fixed displacement
        node set = beside
        component = y
      end
{endif}
      begin pressure
        surface = top
        function = ramp
        scale factor = 1000
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          contact stabilization = {stabilization}
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin user output
        block = lower
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        nodal displacement(z) nearest location 0.5 0.5 2 as way
        nodal displacement(x) nearest location 0.5 0.5 2 as aside
        global contact_stabilization_energy as stabilized
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
