# A rigid punch on an elastic block of 1 x 1 x 0.5 m in equilibrium (SI, E = 1 MPa).
#
# Shows rigid bodies of load steps. The punch covers the top of the block, whose nodes at the bottom are held along z, those
# at x = 0 and y = 0 along x and y. With nu = 0, it is
#   load=depth    lowered by 0.01 m, as its conditions say: the block resists with E ln(1 - 0.02), 20202.7 N;
#   load=weight   pressed by its weight of 20202.7 N, free along z: lowered by 0.01 m;
#   load=free     the same, nothing of it held: however it leans at the start, it comes to lie flat.
# join=contact has it touch, join=tied stick to the block, join=nodes share the block's nodes at the top, which leaves no
# contact. Free bodies that only rest on something have friction of 0.3.
#
# {ifndef(load)}
# {load = "depth"}
# {endif}
# {ifndef(join)}
# {join = "contact"}
# {endif}
# {ifndef(search)}
# {search = "newton"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(mu)}
# {mu = 0.3}
# {endif}
# {ifndef(nu)}
# {nu = 0.0}
# {endif}
# {ifndef(steps)}
# {steps = 4}
# {endif}
# {ifndef(target)}
# {target = 1e-4}
# {endif}
# {ifndef(frame)}
# {frame = 1}
# {endif}
begin sierra static rigid punch
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = {nu}
    end
  end
  begin material steel
    density = 8000
    begin parameters for model elastic
      youngs modulus = 2e11
      poissons ratio = 0.3
    end
  end

  begin rigid body punch_body
  end
  begin solid section rigid_section
    rigid body = punch_body
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model blocks
    database name = static_rigid.g
    begin parameters for block lower
      material = rubber
      model = elastic
    end
    begin parameters for block punch
      material = steel
      model = elastic
      section = rigid_section
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
{if(load != "free")}
      begin fixed displacement
        block = punch
        components = x y
      end
      begin fixed rotation
        block = punch
{if(load == "tilting")}
        component = z
{else}
        components = x y z
{endif}
      end
{endif}
{if(load == "depth")}
      begin prescribed displacement
        block = punch
        component = z
        function = ramp
        scale factor = -0.01
      end
{else}
      begin gravity
        block = punch
        component = z
        function = ramp
        # 8000 kg/m^3 times 0.5 m^3
        gravitational constant = {-20202.7073175/4000}
      end
{endif}

{if(join != "nodes")}
      begin contact definition
        skin all blocks = on
        begin tied model glue
        end
        begin constant friction model rough
          friction coefficient = {mu}
        end
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
{if(join == "tied")}
          friction model = glue
{endif}
{if(join == "contact" && load == "free" && mu > 0)}
          friction model = rough
{endif}
        end
      end
{endif}

      begin solver
        begin cg
          target relative residual = {target}
{if(search == "newton")}
          begin full tangent preconditioner
          end
{endif}
        end
      end

      begin user output
        node set = bottom
        compute global force as sum of nodal reaction(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        global displz_punch_body
        global reactz_punch_body
        global rotdx_punch_body
        global rotdy_punch_body
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
