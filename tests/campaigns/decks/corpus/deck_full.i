# {n = 2} {thick = 0.1*n}
begin sierra fuzz me
  title A deck with a bit of everything
  define point p with coordinates 0.0, 0.0, 0.0
  define direction d with vector 0 0 1
  define axis a with point p direction d
  begin definition for function ramp
    type is piecewise linear
    begin values
      0.0 0.0
      1.0, {n}
    end values
  end definition for function ramp
  begin function wave
    type = analytic
    expression variable: t = global time
    evaluate expression is "sin(2 * t); \#
      t ^ 2"
  end
  begin material steel
    density = 7.8e-3
    begin parameters for model elastic
      youngs modulus = 2.0e5
      poissons ratio = 0.3
    end parameters for model elastic
  end material steel
  begin shell section thin
    thickness = {thick}
  end
  begin rigid body rb
  end
  begin finite element model fem
    database name = %B.g
    database type = exodusII
    begin parameters for block block_1 block_2
      material steel
      solid mechanics use model elastic
      section = thin
      hourglass stiffness = 0.05
    end parameters for block block_1
  end finite element model fem
  begin presto procedure p
    begin time control
      begin time stepping block one
        start time = 0.0
        begin parameters for presto region r
          time step scale factor = 0.9
        end
      end
      termination time = 1.0e-3
    end time control
    begin presto region r
      use finite element model fem
      begin fixed displacement
        node set = nodelist_1
        components = x y z
      end
      begin prescribed velocity push
        surface = surface_1
        direction = d
        function = ramp
        scale factor = -1.0
      end
      begin gravity
        include all blocks
        direction = d
        gravitational constant = 9.81
      end
      begin initial velocity
        block = block_2
        component = z
        magnitude = -10
      end
      begin analytic object floor
        type = plane
        normal direction = 0 0 1
        origin = 0 0 -1
      end
      begin contact definition
        skin all blocks = on exclude block_3
        contact surface s contains block_1 surface_2
        contact node set ns contains nodelist_2
        begin contact surface top
          block = block_4
          remove surface = surface_9
          subset up with normal 0 0 1
        end
        restrict contact to subdomain defined by radius 5.0 and point 0 0 0
        begin constant friction model mu
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          self contact = off
          exclude surfaces = s ALL
          friction model = mu
        end interaction defaults
        begin interaction one
          surfaces = s top
          normal tolerance = 1.0e-3
        end
      end contact definition
      begin element death d
        block = block_1
        criterion is max nodal value of coordinates(x) >= 1.0
      end
      begin results output out
        database name = %B.e
        at time 0.0 increment = 1.0e-5
        nodal variables = displacement as displ velocity
        element stress(xx,1) as s1
        global kinetic_energy
      end
      begin heartbeat ouput h
        stream name = h.csv
        timestamp format ''
        global time
      end
    end presto region r
  end presto procedure p
end sierra
