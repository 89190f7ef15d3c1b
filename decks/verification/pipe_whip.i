# Pipe whip: a steel pipe that turns about one end at 75 rad/s hits another, which is held at both ends, across its middle;
# the half x > 0 of both (in, lbf, s; after the Abaqus benchmark and Ferencz 1989).
#
# Shows large plastic deformation of shells in contact: both pipes are dented for good and nothing gets lost. Pipes of
# 6.625 in, wall 0.432 in, 50 in long, J2 perfectly plastic; they cross at their middles.
# Expected: kinetic energy at the start m L^2 w^2 / 6 + m R^2 w^2 / 4 of a whole pipe, half of it here, within 1 %; energy
# within 3 %; skins in each other by less than a tenth of the wall; both pipes flattened by more than a
# tenth of their width, with NODE_FACE as with FACE_FACE within 5 %.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 5e-4}
begin sierra pipe whip
  define point pin with coordinates 0 -25 6.675
  define direction turning with vector -1 0 0
  define axis pin_axis with point pin direction turning

  begin material steel
    density = 7.324e-4
    begin parameters for model elastic_plastic
      youngs modulus = 30e6
      poissons ratio = 0.3
      yield stress = 45e3
      hardening modulus = 0
    end
  end

  begin shell section wall
    thickness = 0.432
    number of integration points = 5
  end

  begin rigid body hinge
    include nodes in = pinned
  end

  begin finite element model pipes
    database name = pipe_whip.g
    begin parameters for block held whip
      material = steel
      model = elastic_plastic
      section = wall
    end
  end

  begin presto procedure whip
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region pipes
          step interval = 1000
        end
      end
      termination time = 15e-3
    end

    begin presto region pipes
      use finite element model pipes

      begin fixed displacement
        node set = ends
        components = x y z
      end
      begin fixed rotation
        node set = ends
        components = x y z
      end
      begin fixed displacement
        rigid body = hinge
        components = x y z
      end
      begin fixed rotation
        rigid body = hinge
        components = y z
      end
      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed rotation
        node set = on_x
        components = y z
      end

      begin initial velocity
        block = whip
        cylindrical axis = pin_axis
        angular velocity = 75
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          self contact = on
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      begin results output
        database name = %B.e
        at time 0 increment = {frame}
        nodal variables = displacement coordinates velocity mass force_contact moment_contact contact_normal_gap
        element variables = von_mises eqps
      end
    end
  end
end sierra
