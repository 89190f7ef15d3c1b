# Two columns of 1 m with a plate between them are pressed by 1 % of their length, slowly for waves, and held (SI).
#
# Shows that what is lighter than both of its neighbours passes on all of the force: a rigid plate of any density that nothing but
# the columns holds (-D plate=rigid), and a thin sheet (-D plate=shell). Without Poisson's ratio the force at the driven end is E A
# times the strain.
# Expected: force within 2 % of it. Missed by sheets as soft as the columns: the lofts' couple turns their directors, which
# one-point shells resist by next to nothing in the mesh's shortest wave; it is told as penetration.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(law)}
# {law = "frictionless"}
# {endif}
# {ifndef(plate)}
# {plate = "rigid"}
# {endif}
# {ifndef(density)}
# {density = 1000}
# {endif}
# {ifndef(youngs)}
# {youngs = 2e9}
# {endif}
# {frame = 0.05}
begin sierra sandwich
  begin function slowly
    type = analytic
    evaluate expression = "x < 0.5 ? 0.5 * (1 - cos(3.141592653589793 * x / 0.5)) : 1"
  end
  begin material soft
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0
    end
  end
  begin material plate
    density = {density}
    begin parameters for model elastic
      youngs modulus = {youngs}
      poissons ratio = 0
    end
  end
  begin rigid body middle
  end
  begin solid section thick
    rigid body = middle
  end
  begin shell section thin
    thickness = 0.01
    number of integration points = 3
  end

  begin finite element model bodies
    database name = sandwich.g
    begin parameters for block below above
      material = soft
      model = elastic
    end
    begin parameters for block plate
      material = plate
      model = elastic
      section = {plate == "rigid" ? "thick" : "thin"}
    end
  end

  begin presto procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
          step interval = 20000
        end
      end
      termination time = 1
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        node set = bottom
        components = x y z
      end
      begin fixed displacement
        node set = top
        components = x y
      end
      begin prescribed displacement
        node set = top
        component = z
        function = slowly
        scale factor = -0.02
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model rub
          friction coefficient = 0.3
        end
        begin interaction defaults
          general contact = on
          friction model = {law}
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global contact_force_below(z) as force
        global contact_penetration_max as penetration
      end
      {include("results.inc")}
    end
  end
end sierra
