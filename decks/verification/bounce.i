# A nearly rigid cube meets a block that is held, against a penalty of k per area (SI).
#
# Shows what PENALTY STIFFNESS is: thrown, the cube is a mass m on a spring K = k A, in contact for pi sqrt(m / K), with
# the force v sqrt(K m), and leaves as fast as it came (1 kg, 1 m/s, K = 1e8 N/m); with gravity it settles at the depth
# m g / K. Expected within 1 %, the force at rest within 0.1 %.
#
# {ifndef(speed)}
# {speed = 1} {gravity = 0} {damping = 0}
# {endif}
# {ifndef(density)}
# {density = 1000} {youngs = 1e13} {penalty = 1e10} {end_time = 4e-4}
# {endif}
# {ifndef(frame)}
# {frame = end_time / 40}
# {endif}
begin sierra bounce
  begin material stiff
    density = {density}
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = 0
    end
  end

  begin finite element model blocks
    database name = bounce.g
    begin parameters for block cube base
      material = stiff
      model = elastic
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 5000
        end
      end
      termination time = {end_time}
    end

    begin presto region blocks
      use finite element model blocks

      begin initial velocity
        block = cube
        component = z
        magnitude = {-speed}
      end
      begin gravity
        block = cube
        component = z
        gravitational constant = {-gravity}
      end
      begin fixed displacement
        block = base
        components = x y z
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          penalty stiffness = {penalty}
          contact damping fraction = {damping}
        end
      end

      begin user output
        block = cube
        compute global force as sum of nodal force_contact(z)
        compute global level as average of nodal displacement(z)
        compute global v as average of nodal velocity(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force level v
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
