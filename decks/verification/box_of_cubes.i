# 64 loose cubes of 10 mm fall into a box without a lid, in 1000 g (SI; mu = 0.3). The walls are five analytic planes.
#
# Shows many bodies in contact: all stay in the box, the energy only falls, and in the end the floor carries their weight
# within 2 %.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 5e-4}
begin sierra box of cubes
  begin material plastic
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.3
    end
  end

  begin finite element model cubes
    database name = box_of_cubes.g
    begin parameters for block
      include all blocks
      material = plastic
      model = elastic
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cubes
          step interval = 1000
        end
      end
      termination time = 30e-3
    end

    begin presto region cubes
      use finite element model cubes

      begin gravity
        include all blocks
        component = z
        gravitational constant = -9810
      end

      begin analytic object floor_plane
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end
# {loop(2, i, 0)}
      begin analytic object wall_{i}
        type = plane
        normal direction = {1 - 2 * i} 0 0
        origin = {0.05 * i} 0 0
      end
      begin analytic object wall_{i + 2}
        type = plane
        normal direction = 0 {1 - 2 * i} 0
        origin = 0 {0.05 * i} 0
      end
# {endloop}

      begin contact definition
        skin all blocks = on
        contact surface floor contains floor_plane
        contact surface walls contains wall_0 wall_1 wall_2 wall_3
        begin constant friction model rub
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          friction model = rub
          constraint formulation = {form}
          contact damping fraction = 0.2
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
