# A blank of 1 mm of aluminium is drawn into a square die by a rigid punch, by 60 mm in 20 ms (SI). Its elements are 21 mm wide, so
# that it bends over the sharp edges of die and punch within single elements, and wrinkles.
#
# Shows that sharp edges do not cut into a sheet that bends over them, with faces (-D form=face_face) as with nodes on faces.
# Expected: penetration below a part of the thickness, contact never gives out energy, the sheet stays below the punch.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 0.001}
begin sierra drawn_cup
  begin function stroke
    type = piecewise linear
    begin values
      0    0
      0.02 1
    end
  end
  begin material aluminium
    density = 2700
    begin parameters for model elastic_plastic
      youngs modulus = 70e9
      poissons ratio = 0.3
      yield stress = 2e8
      hardening modulus = 5e8
    end
  end
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end
  begin rigid body die
  end
  begin rigid body punch
  end
  begin solid section die
    rigid body = die
  end
  begin solid section punch
    rigid body = punch
  end
  begin shell section thin
    thickness = 0.001
    number of integration points = 3
  end

  begin finite element model press
    database name = drawn_cup.g
    begin parameters for block blank
      material = aluminium
      model = elastic_plastic
      section = thin
    end
    begin parameters for block die
      material = steel
      model = elastic
      section = die
    end
    begin parameters for block punch
      material = steel
      model = elastic
      section = punch
    end
  end

  begin presto procedure draw
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region press
          step interval = 1000
        end
      end
      termination time = 0.02
    end

    begin presto region press
      use finite element model press

      begin fixed displacement
        block = die
        components = x y z
      end
      begin fixed rotation
        block = die
        components = x y z
      end
      begin prescribed displacement
        block = punch
        component = z
        function = stroke
        scale factor = -0.06
      end
      begin fixed displacement
        block = punch
        components = x y
      end
      begin fixed rotation
        block = punch
        components = x y z
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model oiled
          friction coefficient = 0.1
        end
        begin interaction defaults
          general contact = on
          friction model = oiled
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_penetration_max as penetration
      end
      {include("results.inc")}
    end
  end
end sierra
