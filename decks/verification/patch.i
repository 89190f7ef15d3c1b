# The patch test of contact: two blocks of unlike meshes, one on the other, pressed together slowly (SI, E = 1 MPa).
#
# Shows that uniform stress passes where nodes do not meet: szz = -100 in every element (Taylor and Papadopoulos 1991;
# El-Abbasi and Bathe 2001), +100 with -D tied=1 -D amount=-100, and the stretch of 1e-4. Expected: FACE_FACE within 0.1 %,
# NODE_FACE that only with meshes that match and otherwise within 3 % (CalculiX's node-to-face contact: 24 % at best), since
# the areas of both sides' nodes are shared out by a few steps of an iteration.
# With -D load=depth the top is lowered instead: against a penalty k per area two cubes of edge 1 and nu = 0 resist by
# depth / (1/E + 1/E + 1/k); code_aster SSNP121 has two of them lowered by 0.1, where strain is logarithmic here.
# Contact is damped, for stiff penalties chatter. The load rises over 30 periods of the lowest mode; values are means over
# what comes after.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(tied)}
# {tied = 0}
# {endif}
# {ifndef(load)}
# {load = "pressure"}
# {endif}
# {ifndef(amount)}
# {amount = 100}
# {endif}
# {ifndef(youngs)}
# {youngs = 1e6}
# {endif}
# {ifndef(nu)}
# {nu = 0.3}
# {endif}
# {ifndef(penalty)}
# {penalty = "auto"}
# {endif}
# {ifndef(frame)}
# {frame = 0.05}
# {endif}
begin sierra patch test
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = {nu}
    end
  end

  begin definition for function slowly
    type = analytic
    evaluate expression = "x < 4 ? 0.5 * (1 - cos(3.141592653589793 * x / 4)) : 1"
  end

  begin finite element model blocks
    database name = patch.g
    begin parameters for block lower upper
      material = rubber
      model = elastic
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 5000
        end
      end
      termination time = 6
    end

    begin presto region blocks
      use finite element model blocks

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
        node set = bottom
        component = z
      end
{if(load == "pressure")}
      begin pressure
        surface = top
        function = slowly
        scale factor = {amount}
      end
{else}
      begin prescribed displacement
        surface = top
        component = z
        function = slowly
        scale factor = {-amount}
      end
{endif}

      begin contact definition
        skin all blocks = on
        begin tied model glue
        end
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          penalty stiffness = {penalty}
          contact damping fraction = 0.1
{if(tied)}
          friction model = glue
{endif}
        end
      end

      begin user output
        block = lower
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
