# One node is moved into the middle of a face, onto the edge of two faces, or onto the corner of four (SI).
#
# Shows that a node meets one surface there, not two or four faces. Expected: the same force everywhere, within 1e-12.
# ENFORCEMENT = PENALTY: the forces that the deck expects are stiffness times penetration.
# {frame = 0.1}
begin sierra one node
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin definition for function down
    type = piecewise linear
    begin values
      0 0
      1 -0.04
    end
  end

  begin finite element model blocks
    database name = one_node.g
    begin parameters for block base cube
      material = rubber
      model = elastic
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 5000
        end
      end
      termination time = 1
    end

    begin presto region blocks
      use finite element model blocks

      begin fixed displacement
        block = base
        components = x y z
      end
      begin fixed displacement
        block = cube
        components = x y
      end
      begin prescribed displacement
        block = cube
        component = z
        function = down
      end

      begin contact definition
        enforcement = penalty
        contact surface below contains base
        contact node set above contains tip
        begin interaction press
          side a = below
          side b = above
          constraint formulation = node_face
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
