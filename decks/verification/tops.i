# Two rigid tops, bricks 0.2 x 0.2 x 0.4 m of 1000 kg/m^3 whose axis leans by 30 degrees from the upright z.
#
# heavy: turns about its centre, which is held; a weight of 5 N hangs at the end of its axis, 0.2 m above. It begins in its
# steady precession with the rate w about z and the spin s about its own axis: with the moments of inertia I about it and J
# across, w (I (s + w cos 30) - J w cos 30) = F l. free: nothing acts on it; it precesses about its angular momentum L at L / J.
# Shows that rigid bodies turn as they should. Expected within 0.1 %, and no more nutation than 1e-3 of the lean.
#
# {I = 16 * 0.04 / 6} {J = 16 * 0.2 / 12} {side = sind(30)} {up = cosd(30)}
# {w_heavy = 2} {s_heavy = (5 * 0.2 / w_heavy + J * w_heavy * up) / I - w_heavy * up}
# {s_free = 10} {w_free = I * s_free / ((J - I) * up)}
begin sierra tops
  define point heavy_centre with coordinates 0 0 0
  define point over_heavy with coordinates {s_heavy * side} 0 {w_heavy + s_heavy * up}
  define axis heavy with point heavy_centre point over_heavy
  define point free_centre with coordinates 2 0 0
  define point over_free with coordinates {2 + s_free * side} 0 {w_free + s_free * up}
  define axis free with point free_centre point over_free

  begin material wood
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.3
    end
  end

  begin rigid body heavy
  end
  begin rigid body free
  end
  begin solid section heavy
    rigid body = heavy
  end
  begin solid section free
    rigid body = free
  end

  begin definition for function one
    type = constant
    begin values
      1
    end
  end

  begin finite element model tops
    database name = tops.g
    begin parameters for block heavy
      material = wood
      model = elastic
      section = heavy
    end
    begin parameters for block free
      material = wood
      model = elastic
      section = free
    end
  end

  begin presto procedure turn
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region tops
          user time step = 2e-4
          step interval = 1000
        end
      end
      termination time = 2
    end

    begin presto region tops
      use finite element model tops

      begin fixed displacement
        rigid body = heavy
        components = x y z
      end
      begin prescribed force
        node set = tip
        component = z
        function = one
        scale factor = -5
      end
      begin initial velocity
        block = heavy
        cylindrical axis = heavy
        angular velocity = {sqrt((s_heavy * side)^2 + (w_heavy + s_heavy * up)^2)}
      end
      begin initial velocity
        block = free
        cylindrical axis = free
        angular velocity = {sqrt((s_free * side)^2 + (w_free + s_free * up)^2)}
      end

      begin heartbeat output
        stream name = %B.csv
        precision = 12
        at step 0 increment = 5
        nodal coordinates(x) nearest location {0.2 * side} 0 {0.2 * up} as heavy_x
        nodal coordinates(y) nearest location {0.2 * side} 0 {0.2 * up} as heavy_y
        nodal coordinates(z) nearest location {0.2 * side} 0 {0.2 * up} as heavy_z
        nodal coordinates(x) nearest location {2 + 0.2 * side} 0 {0.2 * up} as free_x
        nodal coordinates(y) nearest location {2 + 0.2 * side} 0 {0.2 * up} as free_y
        nodal coordinates(z) nearest location {2 + 0.2 * side} 0 {0.2 * up} as free_z
        global energy_error as energy_error
        global kinetic_energy as kinetic_energy
      end
    end
  end
end sierra
