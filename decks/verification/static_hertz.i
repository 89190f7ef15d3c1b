# Hertz in equilibrium, the balls and cylinders of hertz.i: a quarter of one on an analytic plane, on its mirror image or on a
# block.
#
# Shows a contact that grows step by step. Balls: F = 4/3 E* sqrt(R*) d^1.5, a = sqrt(R* d), p0 = 3 F / (2 pi a^2) at the
# approach d; cylinders: a = sqrt(4 F R* / (pi E* L)), p0 = 2 F / (pi a L). With another block below (NAFEMS CGS-1) and friction
# of 0.1 the cylinder comes down by 0.9 % less than code_aster's. On a plane the cylinder's
# force is that of CalculiX with the same mesh within 0.2 %, and 1.5 % below the limit of another series of meshes, as is
# CalculiX's. With -D shift=d whole cylinders that are pressed are shifted by d in a second unit of time: they stick up to
# c = a sqrt(1 - Q / (mu P)) from the middle (Cattaneo 1938, Mindlin 1949), within an element. All settings of contact and of
# the search are the default ones; hourglass resistance as in hertz.i. Units: mm, N, MPa, t.
#
# {ifndef(youngs)}
# {youngs = 1000} {nu = 0.3} {density = 1e-9}
# {endif}
# {ifndef(base_youngs)}
# {base_youngs = youngs}
# {endif}
# {ifndef(base)}
# {base = "plane"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(drive)}
# {drive = "approach"}
# {endif}
# {ifndef(amount)}
# {amount = 0.12742}
# {endif}
# {ifndef(plane_strain)}
# {plane_strain = 0}
# {endif}
# {ifndef(friction)}
# {friction = 0}
# {endif}
# {ifndef(shift)}
# {shift = 0}
# {endif}
# {ifndef(search)}
# {search = "newton"}
# {endif}
# {frame = 1}
begin sierra static hertz
  begin material soft
    density = {density}
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = {nu}
    end
  end

  begin material below
    density = {density}
    begin parameters for model elastic
      youngs modulus = {base_youngs}
      poissons ratio = {nu}
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
      2 1
    end
  end
  begin definition for function later
    type = piecewise linear
    begin values
      0 0
      1 0
      2 1
    end
  end

  begin finite element model bodies
    database name = static_hertz.g
    begin parameters for block ball
      material = soft
      model = elastic
      hourglass stiffness = 0.005
    end
{if(base != "plane")}
    begin parameters for block base
      material = below
      model = elastic
      hourglass stiffness = 0.005
    end
{endif}
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region bodies
          number of time steps = {shift == 0 ? 4 : 8}
        end
      end
      termination time = {shift == 0 ? 1 : 2}
    end

    begin adagio region bodies
      use finite element model bodies

      begin fixed displacement
        node set = {shift == 0 ? "on_x" : "bottom"}
        component = x
      end
{if(shift != 0)}
      begin prescribed displacement
        surface = top
        component = x
        function = later
        scale factor = {shift}
      end
{endif}
{if(plane_strain)}
      begin fixed displacement
        include all blocks
        component = y
      end
{else}
      begin fixed displacement
        node set = on_y
        component = y
      end
{endif}
{if(base == "body")}
      begin fixed displacement
        node set = bottom
        component = z
      end
{endif}
{if(drive == "approach")}
      begin prescribed displacement
        surface = top
        component = z
        function = ramp
        scale factor = {-amount}
      end
{else}
      begin pressure
        surface = top
        function = ramp
        scale factor = {amount}
      end
{endif}

      begin analytic object plane_z
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        contact surface above contains ball
{if(base == "plane")}
        contact surface below contains plane_z
{else}
        contact surface below contains base
{endif}
        begin constant friction model rough
          friction coefficient = {friction}
        end
        begin interaction press
          surfaces = above below
          constraint formulation = {form}
          friction model = rough
        end
      end

      begin solver
        begin cg
{if(search == "newton")}
          begin full tangent preconditioner
          end
{endif}
        end
      end

      begin user output
        block = ball
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
