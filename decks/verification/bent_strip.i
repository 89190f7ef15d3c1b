# The end of a clamped strip of 1 mm of aluminium is pulled down by 50 mm in 10 ms, so that it bends over the sharp edge of a held
# block, which stands somewhere within its elements (SI).
#
# Shows that the faces on both sides of an edge hold a sheet that bends over it, until these lean by 45 degrees and more.
# Expected: penetration below a tenth of the thickness, and contact gives out no energy.
#
# {frame = 0.001}
begin sierra bent_strip
  begin function pull
    type = piecewise linear
    begin values
      0    0
      0.01 1
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
  begin shell section thin
    thickness = 0.001
    number of integration points = 3
  end

  begin finite element model bodies
    database name = bent_strip.g
    begin parameters for block strip
      material = aluminium
      model = elastic_plastic
      section = thin
    end
    begin parameters for block block
      material = aluminium
      model = elastic_plastic
    end
  end

  begin presto procedure bend
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 1000
        end
      end
      termination time = 0.01
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        block = block
        components = x y z
      end
      begin fixed displacement
        node set = clamped
        components = x y z
      end
      begin fixed rotation
        node set = clamped
        components = x y z
      end
      begin prescribed displacement
        node set = pulled
        component = z
        function = pull
        scale factor = -0.05
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = face_face
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
