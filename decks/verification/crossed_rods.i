# Round rods of beam elements across each other, closing at 1 m/s, both free; radii of 10 and 15 mm (SI).
#
# Shows contact of edges: it begins when the axes are as far apart as the sum of the radii, whether the rods cross at a right
# angle or not, at nodes or between them; neither side is the master, so that rods alike are each other's image all the time;
# momentum and angular momentum are kept, and the contact gives back what it has taken.
# -D element=truss takes trusses of the same areas. -D turning=w turns the flier about its own axis, with friction of 0.3.
# Expected: distance within 1 % of the smaller radius, images within 1e-9, energy left in contact below 2 %; the force of a
# given depth, k (2 r)^2 with the smaller radius, the same wherever the rods cross.
# ENFORCEMENT = PENALTY: beams as coarse as these have no elements behind what meets, and a hit by momentum balance takes the
# motion of their nodes against each other; the elastic penalty gives it back.
#
# {ifndef(element)}
# {element = "beam"}
# {endif}
# {ifndef(ra)}
# {ra = 0.01} {rb = 0.015}
# {endif}
# {ifndef(va)}
# {va = -1} {vb = 0}
# {endif}
# {ifndef(turning)}
# {turning = 0}
# {endif}
# {ifndef(penalty)}
# {penalty = "auto"}
# {endif}
# {ifndef(end_time)}
# {end_time = 3e-3}
# {endif}
# {frame = end_time / 60} {pi = 3.141592653589793}
begin sierra crossed rods
  define point middle with coordinates 0 0 {ra + rb + 1e-4}
  define direction along with vector 1 0 0
  define axis of_flier with point middle direction along

  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

# {loop(2, i, 0)}
{if(element == "beam")}
  begin beam section section_{i}
    section = rod
    width = {2 * (i == 0 ? ra : rb)}
    height = {2 * (i == 0 ? ra : rb)}
    t axis = 0 0 1
  end
{else}
  begin truss section section_{i}
    area = {pi * (i == 0 ? ra * ra : rb * rb)}
  end
{endif}
# {endloop}

  begin finite element model rods
    database name = crossed_rods.g
    begin parameters for block flier
      material = steel
      model = elastic
      section = section_0
    end
    begin parameters for block target
      material = steel
      model = elastic
      section = section_1
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rods
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region rods
      use finite element model rods

{if(turning == 0)}
      begin initial velocity
        block = flier
        component = z
        magnitude = {va}
      end
{endif}
      begin initial velocity
        block = target
        component = z
        magnitude = {vb}
      end
{if(turning != 0)}
      begin initial velocity
        block = flier
        cylindrical axis = of_flier
        angular velocity = {turning}
      end
{endif}

      begin contact definition
        enforcement = penalty
        contact surface one contains flier
        contact surface other contains target
        begin interaction cross
          surfaces = one other
          penalty stiffness = {penalty}
{if(turning != 0)}
          friction coefficient = 0.3
{endif}
        end
      end

      begin user output
        block = flier
        compute global force as sum of nodal force_contact(z)
        compute global height as average of nodal coordinates(z)
      end
      begin user output
        block = target
        compute global height_below as average of nodal coordinates(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force height height_below
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact
        nodal variables = rotational_velocity rotational_mass
      end
    end
  end
end sierra
