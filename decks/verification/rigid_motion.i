# Two rigid bricks of solid elements, 1 x 2 x 3 m, far from each other.
#
# The first one flies and tumbles: thrown at (3, 4, 0) m/s, spun about an axis that is not principal. Its centre goes along
# a parabola under gravity, its angular momentum and its energy stay. The second one hangs on an axle through its centre and
# is turned by forces at one of its ends: angle = 3 F / (m (1 + 4)) t^2 with the arm of 1 m, inertia m (1 + 4) / 12.
# -D steps=n is their number. Expected: energy within 0.1 %, the angle within 1e-4.
#
# {ifndef(steps)}
# {steps = 2000}
# {endif}
begin sierra rigid motion
  define direction down with vector 0 0 -1
  define point flying with coordinates 0.5 1 1.5
  define point ahead with coordinates 1.5 2.5 1.5
  define axis oblique with point flying point ahead

  begin material steel
    density = 1000
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end

  begin rigid body flier
  end
  begin rigid body turner
  end
  begin solid section flier
    rigid body = flier
  end
  begin solid section turner
    rigid body = turner
  end

  begin definition for function one
    type = constant
    begin values
      1
    end
  end

  begin finite element model bricks
    database name = rigid_motion.g
    begin parameters for block flier
      material = steel
      model = elastic
      section = flier
    end
    begin parameters for block turner
      material = steel
      model = elastic
      section = turner
    end
  end

  begin presto procedure move
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bricks
          user time step = {1/steps}
          step interval = 1000
        end
      end
      termination time = 1
    end

    begin presto region bricks
      use finite element model bricks

      begin gravity
        block = flier
        direction = down
        function = one
        gravitational constant = 9.81
      end
      begin initial velocity
        block = flier
        cylindrical axis = oblique
        angular velocity = 6
      end

      begin fixed displacement
        rigid body = turner
        components = x y z
      end
      begin fixed rotation
        block = turner
        components = x y
      end
      begin prescribed force
        node set = end
        component = x
        function = one
        scale factor = -10
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 15
        at step 0 increment = 10
        global displz_flier as height
        global rotdz_turner as angle
        global rreactx_turner as held
        global angular_momentum as momentum
        global kinetic_energy as kinetic_energy
        global external_energy as external_energy
        global energy_error as energy_error
      end
    end
  end
end sierra
