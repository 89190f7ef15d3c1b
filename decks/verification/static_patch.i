# The patch test of patch.i in equilibrium: two blocks of unlike meshes, one on the other, in one load step (SI, E = 1 MPa).
#
# Shows contact of load steps: the penalty made exact by multipliers. A pressure of 100 on the top presses every element by
# szz = -100 (Taylor and Papadopoulos 1991; El-Abbasi and Bathe 2001), with -D tied=1 -D amount=-100 it pulls by 100 and
# stretches the blocks by 1e-4. With -D load=depth the top is lowered: two cubes of edge 1 and nu = 0 with -D penalty=1e9
# resist by E ln(1 - depth/2) with multipliers, and by that behind the spring without (-D updates=0). Blocks of unlike meshes,
# 2 high and lowered by 0.1, have their interface at -0.05 and a stress of E log(0.95) (code_aster's SSNP121). A step takes as its
# strain the motion over the length between its ends, 2 (1 - 0.95)/(1 + 0.95): off by 2.1e-4 in one step, by 5.3e-5 with
# -D steps=2. An upper cube that is meshed 0.02 into the lower is pushed out by the whole of it (CalculiX's example contact3).
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
# {ifndef(updates)}
# {updates = 100}
# {endif}
# {ifndef(steps)}
# {steps = 1}
# {endif}
# {ifndef(search)}
# {search = "newton"}
# {endif}
# {ifndef(target)}
# {target = 1e-4}
# {endif}
# {frame = 1}
begin sierra static patch test
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = {nu}
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
    database name = static_patch.g
    begin parameters for block lower upper
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
        function = ramp
        scale factor = {amount}
      end
{else}
      begin prescribed displacement
        surface = top
        component = z
        function = ramp
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
{if(tied)}
          friction model = glue
{endif}
        end
      end

      begin solver
        begin cg
          target relative residual = {target}
{if(search == "newton")}
          begin full tangent preconditioner
          end
{endif}
        end
        begin control contact
          maximum iterations = {updates}
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
