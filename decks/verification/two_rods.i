# An elastic rod strikes another at rest, end on: nu = 0, cross-section A, length L each (SI).
#
# Shows what a contact passes on: until the wave c = sqrt(E/rho) is back from the free end after 2 L/c the force between
# the rods is rho c v A / 2, and then the struck rod has all of the velocity, the other none (St. Venant). With meshes
# that match or not, along the axes or across them (-D vx, vy, vz), mirrored, in other units (-D density, youngs).
# -D thickness=t makes the rods sheets of shells, edge on edge.
# -D held=1 holds the far end of the struck rod, which changes nothing before its wave is back (code_aster SDNL111).
# Bulk viscosity is off: it would keep 0.7 % of the momentum in the striking rod.
# Expected: duration within 5 %, mean force within 1 %, impulse within 0.5 %, 99.5 % of the velocity (0.1 m rods).
#
# {ifndef(enforcement)}
# {enforcement = "momentum_balance"}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(vx)}
# {vx = 10} {vy = 0} {vz = 0}
# {endif}
# {ifndef(density)}
# {density = 8000} {youngs = 200e9} {end_time = 60e-6}
# {endif}
# {ifndef(thickness)}
# {thickness = 0}
# {endif}
# {ifndef(held)}
# {held = 0}
# {endif}
# {ifndef(frame)}
# {frame = end_time / 60}
# {endif}
begin sierra two rods
  begin material steel
    density = {density}
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = 0
    end
  end

{if(thickness > 0)}
  begin shell section sheet
    thickness = {thickness}
    number of integration points = 3
  end
{endif}

  begin finite element model rods
    database name = two_rods.g
    begin parameters for block rod_a rod_b
      material = steel
      model = elastic
{if(thickness > 0)}
      section = sheet
{endif}
      linear bulk viscosity = 0
      quadratic bulk viscosity = 0
    end
  end

  begin presto procedure strike
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rods
          step interval = 1000
        end
      end
      termination time = {end_time}
    end

    begin presto region rods
      use finite element model rods

{if(vx != 0)}
      begin initial velocity
        block = rod_a
        component = x
        magnitude = {vx}
      end
{endif}
{if(vy != 0)}
      begin initial velocity
        block = rod_a
        component = y
        magnitude = {vy}
      end
{endif}
{if(vz != 0)}
      begin initial velocity
        block = rod_a
        component = z
        magnitude = {vz}
      end
{endif}
{if(held)}
      begin fixed displacement
        node set = far_end
        components = x y z
      end
{endif}

      begin contact definition
        skin all blocks = on
        enforcement = {enforcement}
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
        end
      end

      begin user output
        block = rod_b
        compute global force_x as sum of nodal force_contact(x)
        compute global force_y as sum of nodal force_contact(y)
        compute global force_z as sum of nodal force_contact(z)
      end

      begin heartbeat output
        stream name = %B.csv
        global force_x force_y force_z
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
