# A thin pipe of shells, radius 1 m, 0.01 m thick, held along its axis, under a pressure of 1 MPa that acts at once; a
# quarter of it, one element long.
#
# Shows pressure on shells and symmetry planes by held rotations. The pipe breathes between rest and twice its static
# expansion p R^2 (1 - nu^2) / (E t), with the frequency sqrt(E / (rho (1 - nu^2))) / R. Expected within 1 %.
begin sierra breathing pipe
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin shell section wall
    thickness = 0.01
    number of integration points = 3
  end

  begin definition for function one
    type = constant
    begin values
      1
    end
  end

  begin finite element model pipe
    database name = breathing_pipe.g
    begin parameters for block pipe
      material = steel
      model = elastic
      section = wall
    end
  end

  begin presto procedure inflate
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region pipe
          step interval = 1000
        end
      end
      termination time = 6e-3
    end

    begin presto region pipe
      use finite element model pipe

      begin fixed displacement
        include all blocks
        component = z
      end
      begin fixed rotation
        include all blocks
        components = x y
      end
      begin fixed displacement
        node set = on_x
        component = y
      end
      begin fixed rotation
        node set = on_x
        component = z
      end
      begin fixed displacement
        node set = on_y
        component = x
      end
      begin fixed rotation
        node set = on_y
        component = z
      end

      begin pressure
        block = pipe
        function = one
        scale factor = -1e6
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 1
        nodal displacement(x) nearest location 1 0 0 as wall
        global energy_error as energy_error
        global external_energy as external_energy
      end
    end
  end
end sierra
