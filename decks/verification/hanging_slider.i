# A cube of 1000 kg and edge 1 is thrown up at a held ceiling of 6 x 3 m, 1 mm above it, along which it moves at 1 m/s, under
# gravity (SI).
#
# Shows SEPARATION = OFF at default settings: what has touched hangs, and slides freely. Expected: it hangs by its weight, 9810
# N, and is 2 m farther after two seconds; with SEPARATION = ON it falls.
# {ifndef(form)}
# {form = "face_face"} {enforcement = "momentum_balance"} {separation = "off"}
# {endif}
# {frame = 0.05}
begin sierra hanging slider
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0.3
    end
  end

  begin finite element model bodies
    database name = hanging_slider.g
    begin parameters for block ceiling cube
      material = rubber
      model = elastic
    end
  end

  begin presto procedure hang
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 10000
        end
      end
      termination time = 2
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        block = ceiling
        components = x y z
      end
      begin initial velocity
        block = cube
        component = x
        magnitude = 1
      end
      begin initial velocity
        block = cube
        component = z
        magnitude = 0.2
      end
      begin gravity
        block = cube
        component = z
        gravitational constant = -9.81
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
          enforcement = {enforcement}
          separation = {separation}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_force_cube(z) as force
      end
      {include("results.inc")}
    end
  end
end sierra
