# A cube of edge 1 m that meets an analytic plane in equilibrium (SI, E = 1 MPa, nu = 0), friction of 0.3.
#
# Shows analytic planes in load steps.
#   body=elastic  is pushed against a plane at its top by its base, by 0.01 m: it resists with E ln(1 - 0.01), 10050.3 N;
#   body=rigid    nothing but the plane below holds it: its weight of 10000 N brings it down to the plane over a gap, and
#                 where the plane slopes by less than friction holds, the cube comes to lie flat on it.
#
# {ifndef(body)}
# {body = "elastic"}
# {endif}
# {ifndef(slope)}
# {slope = 0}
# {endif}
# {ifndef(gap)}
# {gap = 0}
# {endif}
# {ifndef(search)}
# {search = "newton"}
# {endif}
# {ifndef(frame)}
# {frame = 1}
# {endif}
begin sierra static plane
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0
    end
  end

{if(body == "rigid")}
  begin rigid body brick
  end
  begin solid section rigid_section
    rigid body = brick
  end
{endif}

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model cubes
    database name = static_plane.g
    begin parameters for block cube
      material = rubber
      model = elastic
{if(body == "rigid")}
      section = rigid_section
{endif}
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region cubes
          number of time steps = 4
        end
      end
      termination time = 1
    end

    begin adagio region cubes
      use finite element model cubes

{if(body == "rigid")}
      begin gravity
        include all blocks
        component = z
        function = ramp
        gravitational constant = -10
      end
{else}
      begin fixed displacement
        node set = bottom
        components = x y
      end
      begin prescribed displacement
        node set = bottom
        component = z
        function = ramp
        scale factor = 0.01
      end
{endif}

      begin analytic object wall
        type = plane
{if(body == "rigid")}
        normal direction = {sin(slope)} 0 {cos(slope)}
        origin = 0.5 0 {-gap}
{else}
        normal direction = 0 0 -1
        origin = 0 0 1
{endif}
      end

      begin contact definition
        skin all blocks = on
        contact surface plane contains wall
        begin constant friction model rough
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
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
        block = cube
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
{if(body == "rigid")}
        global displz_brick
        global rotdy_brick
{endif}
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
