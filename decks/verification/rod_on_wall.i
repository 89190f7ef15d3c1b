# An elastic rod flies along its axis against a rigid wall, the analytic plane x = 0 (SI, or any other units).
#
# Shows contact with a plane: for 2 L / c the wall pushes with rho c v A, then the rod leaves as fast as it came. With
# nu = 0 c = sqrt(E / rho) (Abaqus benchmark "Truss impact on a rigid wall"; ANSYS VM265 after Carpenter et al. 1991 with
# -D in inches); -D confined=1 holds it laterally, then c is that of plane waves. -D gravity lets it fall from rest.
# The penalty is -D scale=2 times the automatic one: softer springs lengthen the contact, stiffer ones make its start ring.
# Expected: impact within a step, duration within 2.5 %, force within 0.5 %, velocity within 1 % by 50 elements. The confined
# rod keeps its duration within 1 % by 200: on its way a front widens to some elements, and contact ends with the last of
# it, so that 50 elements give 1.4 % more, 100 1.0 % and 200 0.8 %.
#
# {ifndef(density)}
# {density = 7800} {youngs = 200e9} {end_time = 1.6e-3}
# {endif}
# {ifndef(nu)}
# {nu = 0}
# {endif}
# {ifndef(confined)}
# {confined = 0}
# {endif}
# {ifndef(speed)}
# {speed = 1.5}
# {endif}
# {ifndef(gravity)}
# {gravity = 0}
# {endif}
# {ifndef(scale)}
# {scale = 2}
# {endif}
# {ifndef(frame)}
# {frame = end_time / 100}
# {endif}
begin sierra rod on a wall
  begin material metal
    density = {density}
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = {nu}
    end
  end

  begin finite element model rod
    database name = rod_on_wall.g
    begin parameters for block rod
      material = metal
      model = elastic
      linear bulk viscosity = 0
      quadratic bulk viscosity = 0
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rod
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region rod
      use finite element model rod

      begin initial velocity
        block = rod
        component = x
        magnitude = {-speed}
      end
{if(gravity != 0)}
      begin gravity
        include all blocks
        component = x
        gravitational constant = {-gravity}
      end
{endif}
{if(confined)}
      begin fixed displacement
        block = rod
        components = y z
      end
{endif}

      begin analytic object plane_x
        type = plane
        normal direction = 1 0 0
        origin = 0 0 0
      end

      begin contact definition
        skin all blocks = on
        contact surface wall contains plane_x
        begin interaction defaults
          general contact = on
          penalty scale = {scale}
        end
      end

      begin user output
        block = rod
        compute global force_x as sum of nodal force_contact(x)
      end

      begin heartbeat output
        stream name = %B.csv
        global force_x
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
