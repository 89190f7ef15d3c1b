# A round rod of beam elements, 0.1 m thick and 1 m long, lies across its way on the ground and slides off at 2 m/s without
# turning; friction of 0.5 makes it roll (SI). The ground is the analytic plane z = 0, or with -D ground=plate a held block.
#
# Shows that friction turns rods, by the polar inertia m r^2 / 2 of a round one. Friction takes mu g of the speed and gives
# 2 mu g / r of the angular velocity, until what touches the ground is at rest: the rod rolls at 2/3 of the speed, 1.333 m/s,
# from v / (3 mu g) = 0.136 s on. Expected: speed and circumferential speed within 0.2 % of that, at rest against each other.
#
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"} {ground = "plane"}
# {endif}
# {frame = 0.01}
begin sierra rolling rod
  begin material wood
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0.3
    end
  end

  begin beam section round
    section = rod
    width = 0.1
    height = 0.1
    t axis = 0 0 1
  end

  begin finite element model parts
    database name = rolling_rod.g
    begin parameters for block rod
      material = wood
      model = elastic
      section = round
    end
    begin parameters for block base
      material = wood
      model = elastic
    end
  end

  begin presto procedure slide
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region parts
          step interval = 1000
        end
      end
      termination time = 0.25
    end

    begin presto region parts
      use finite element model parts

      begin initial velocity
        block = rod
        component = x
        magnitude = 2
      end
      begin gravity
        block = rod
        component = z
        gravitational constant = -9.81
      end
      begin fixed displacement
        block = base
        components = x y z
      end

      begin analytic object plane_z
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        enforcement = {enforcement}
        contact surface rod contains rod
        contact surface ground contains {ground == "plane" ? "plane_z" : "base"}
        begin interaction roll
          surfaces = rod ground
          friction coefficient = 0.5
        end
      end

      begin user output
        block = rod
        compute global speed as average of nodal velocity(x)
        compute global turning as average of nodal rotational_velocity(y)
      end
      begin heartbeat output
        stream name = %B.csv
        global speed turning
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact
        nodal variables = rotational_velocity rotational_mass
      end
    end
  end
end sierra
