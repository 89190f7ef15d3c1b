# A sphere of 0.2 m flies at 800 m/s into a free plate of 0.1 x 0.5 x 0.5 m, both neo-Hookean (SI; after NimbleSM's
# sphere_plate_contact).
#
# Shows contact under strains of 30 %, the same to the last bit on one thread and on two. Expected after 0.1 ms, within
# 10 %: displacements along x of 7.392 mm (plate) and 73.371 mm (sphere) in the mean, what NimbleSM has stored; none aside.
# Its meshes are finer and its penalty is stiffer, which is why the penalty is four times the automatic one here.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 1e-5}
begin sierra sphere and plate
  begin material metal
    density = 7800
    begin parameters for model neo_hookean
      bulk modulus = 1.6e11
      shear modulus = 0.8e11
    end
  end

  begin finite element model bodies
    database name = sphere_and_plate.g
    begin parameters for block
      include all blocks
      material = metal
      model = neo_hookean
    end
  end

  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 1e-4
    end

    begin presto region bodies
      use finite element model bodies

      begin initial velocity
        block = core east west north south top bottom
        component = x
        magnitude = 800
      end

      begin contact definition
        contact surface sphere contains core east west north south top bottom
        contact surface wall contains plate
        begin interaction hit
          surfaces = sphere wall
          constraint formulation = {form}
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
