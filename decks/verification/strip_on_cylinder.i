# A strip of steel, 500 x 100 x 2.5 mm, held at one end, is blown by a pressure of 0.1 MPa over a rigid cylinder of 40 mm
# that lies across its middle (mm, N, MPa, t, s; after the Abaqus verification problem; both are of shells).
#
# Shows sliding over a curved shell with large plastic turns (J2 perfectly plastic, 250 MPa): the two halves of the strip's
# width stay each other's image, the skins do not get into each other, and the energy balances.
# Expected: images within 1e-6 of the largest displacement, depth below a tenth of the thickness, energy within 1 %.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {frame = 2.5e-4}
begin sierra strip on cylinder
  begin material steel
    density = 7.85e-9
    begin parameters for model elastic_plastic
      youngs modulus = 206e3
      poissons ratio = 0.3
      yield stress = 250
      hardening modulus = 0
    end
  end

  begin shell section strip
    thickness = 2.5
    number of integration points = 5
  end
  begin rigid body cylinder
  end
  begin shell section cylinder
    thickness = 1
    rigid body = cylinder
  end

  begin definition for function one
    type = constant
    begin values
      1
    end
  end

  begin finite element model bodies
    database name = strip_on_cylinder.g
    begin parameters for block strip
      material = steel
      model = elastic_plastic
      section = strip
    end
    begin parameters for block cylinder
      material = steel
      model = elastic_plastic
      section = cylinder
    end
  end

  begin presto procedure blow
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 2000
        end
      end
      termination time = 12e-3
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        node set = root
        components = x y z
      end
      begin fixed rotation
        node set = root
        components = x y z
      end
      begin fixed displacement
        rigid body = cylinder
        components = x y z
      end
      begin fixed rotation
        rigid body = cylinder
        components = x y z
      end
      begin pressure
        block = strip
        function = one
        scale factor = 0.1
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
        nodal displacement(z) nearest location 500 0 0 as tip
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
