# A ball of steel, R = 10 mm, falls at 1 m/s on the middle of a square plate of shells on simple supports; a quarter (SI).
#
# Shows impact on a shell whose bending takes up the blow. The ball's modulus is half of steel's: the surface of a shell
# does not give way under the ball, so that all of Hertz's approach has to be the ball's.
# -D side, -D thickness: 200 x 200 x 8 mm by default (Karas' case); 300 x 300 x 2 mm is so thin that the ball is hit again by
# the plate that swings back.
# Expected, from the plate's first few thousand vibrations by Kirchhoff with Hertz's law between: impulse within 3 %
# (thin: 5 %), largest force within 10 %, speed of the rebound within 5 %, one contact (thin: two).
#
# {ifndef(side)}
# {side = 0.2} {thickness = 0.008}
# {endif}
# {ifndef(end_time)}
# {end_time = 90e-6}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(scale)}
# {scale = 10}
# {endif}
# {frame = end_time / 30}
begin sierra ball on plate
  begin material steel
    density = 7850
    begin parameters for model elastic
      youngs modulus = 206e9
      poissons ratio = 0.3
    end
  end
  begin material soft_steel
    density = 7850
    begin parameters for model elastic
      youngs modulus = 103e9
      poissons ratio = 0.3
    end
  end

  begin shell section plate
    thickness = {thickness}
    number of integration points = 3
  end

  begin finite element model bodies
    database name = ball_on_plate.g
    begin parameters for block plate
      material = steel
      model = elastic
      section = plate
    end
    begin parameters for block ball
      material = soft_steel
      model = elastic
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 5000
        end
      end
      termination time = {end_time}
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed rotation
        node set = plate_on_x
        components = y z
      end
      begin fixed rotation
        node set = plate_on_y
        components = x z
      end
      begin fixed displacement
        node set = rim
        component = z
      end

      begin initial velocity
        block = ball
        component = z
        magnitude = -1
      end

      begin contact definition
        contact surface flier contains ball
        contact surface target contains plate
        begin interaction hit
          surfaces = flier target
          constraint formulation = {form}
          penalty scale = {scale}
        end
      end

      begin user output
        block = ball
        compute global force as sum of nodal force_contact(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force
        nodal displacement(z) nearest location 0 0 0 as middle
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
