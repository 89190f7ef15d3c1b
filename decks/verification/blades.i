# Blades and spikes: a rigid wedge, or a pointed rigid cone of flat sides, is driven into a soft block by 0.15 m, three fifths of its
# elements, at 3.2 m/s (SI, E = 1 MPa).
#
# Shows that nothing is too sharp: sides that rise at 85 degrees stand beside the top of the block rather than before it, and yet
# the edge or the point between them takes the top along: that goes down below it by the same way, within a quarter of the size of an
# element.
#
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(frame)}
# {frame = 0.05}
# {endif}
begin sierra blades
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e6
      poissons ratio = 0.3
    end
  end

  begin rigid body blade_body
  end
  begin solid section rigid_section
    rigid body = blade_body
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0    0
      0.05 1
    end
  end

  begin finite element model bodies
    database name = blades.g
    begin parameters for block blade
      material = rubber
      model = elastic
      section = rigid_section
    end
    begin parameters for block soft
      material = rubber
      model = elastic
    end
  end

  begin presto procedure cut
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region bodies
        end
      end
      termination time = 0.05
    end

    begin presto region bodies
      use finite element model bodies

      begin fixed displacement
        node set = bottom
        components = x y z
      end
      begin prescribed displacement
        block = blade
        component = z
        function = ramp
        scale factor = -0.16
      end
      begin fixed displacement
        block = blade
        components = x y
      end
      begin fixed rotation
        block = blade
        components = x y z
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          constraint formulation = {form}
        end
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
