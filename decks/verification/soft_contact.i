# A rigid cube of 1000 kg and edge 1 falls at a speed on a held one, by a pressure that is a function of the overclosure (SI).
#
# Shows PRESSURE FUNCTION and EXPONENTIAL PRESSURE. A table (0, 0) (0.01 m, 200 Pa) (0.02 m, 1000 Pa) stores 7 J at 0.02, which
# is what the cube has at 0.1183 m/s: expected to be stopped there by 1000 N, and to leave as fast as it came. The exponential
# law with 100 Pa at touch and a clearance of 0.01 m stores 3.718 J at a depth of 0.01 m: at 0.08624 m/s it is stopped there by
# 743.7 N.
# {ifndef(speed)}
# {speed = 0.118321595661992} {form = "face_face"} {law = "pressure function"} {lines = "function = table"}
# {endif}
# {frame = 0.02}
begin sierra soft contact
  begin function table
    type = piecewise linear
    begin values
      0    0
      0.01 200
      0.02 1000
    end
  end

  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin rigid body cube
  end
  begin solid section rigid
    rigid body = cube
  end

  begin finite element model cubes
    database name = soft_contact.g
    begin parameters for block lower
      material = rubber
      model = elastic
    end
    begin parameters for block upper
      material = rubber
      model = elastic
      section = rigid
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
      termination time = 1.5
    end

    begin presto region cubes
      use finite element model cubes

      begin fixed displacement
        block = lower
        components = x y z
      end
      begin initial velocity
        block = upper
        component = z
        magnitude = {-speed}
      end

      begin contact definition
        skin all blocks = on
        begin {law} model soft
          {lines}
        end
        begin interaction defaults
          general contact = on
          friction model = soft
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_penetration_max as deepest
        global contact_force_upper(z) as force
      end
      {include("results.inc")}
    end
  end
end sierra
