# A sector of 5 degrees of a rigid cone, 70.3 degrees from its axis to its face, that is pressed 0.4 mm into an elastic-plastic block of
# 12 mm of radius and height and drawn back by 0.008 mm, without friction (mm, N, MPa, t; E 200 GPa, yield 300 MPa, E_T 5000 MPa):
# code_aster's SSNA111, whose own cone is not published.
#
# Shows contact of load steps in a deep indentation, where a node that met one face at the start slides over many others, and unloading of
# what has yielded. Expected: the node at the tip goes by -0.25 mm at half of the time and by -0.392 mm at the end, as code_aster asks, within
# 1 %. A cone has no length of its own: the force grows as the square of the depth (Kick's law), within 3 %; drawn back, it falls by
# 2 E / (1 - nu^2) a a millimetre, a the radius of contact (Sneddon 1965; Oliver and Pharr 1992), which the slope of the cone raises by up
# to a tenth. The innermost 0.02 mm are left out, so that the sector has no elements with an edge on the axis.
#
# {ifndef(steps)}
# {steps = 20}
# {endif}
# {frame = 1 / steps}
begin sierra static cone
  begin material metal
    density = 7.8e-9
    begin parameters for model elastic_plastic
      youngs modulus = 200e3
      poissons ratio = 0.3
      yield stress = 300
      # 1 / (1 / E_T - 1 / E)
      hardening modulus = {5000 / (1 - 5000 / 200e3)}
      beta = 1
    end
    begin parameters for model elastic
      youngs modulus = 200e3
      poissons ratio = 0.3
    end
  end

  begin rigid body cone_body
  end
  begin solid section rigid_section
    rigid body = cone_body
  end

  begin definition for function way
    type = piecewise linear
    begin values
      0    0
      0.8 -0.4
      1   -0.392
    end
  end

  define direction across with vector {-sin(5 * PI / 180)} {cos(5 * PI / 180)} 0

  begin finite element model bodies
    database name = static_cone.g
    begin parameters for block cone
      material = metal
      model = elastic
      section = rigid_section
    end
    begin parameters for block base
      material = metal
      model = elastic_plastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region bodies
          number of time steps = {steps}
        end
      end
      termination time = 1
    end

    begin adagio region bodies
      use finite element model bodies

      begin fixed displacement
        node set = first_plane
        component = y
      end
      begin fixed displacement
        node set = second_plane
        direction = across
      end
      begin fixed displacement
        node set = axis
        component = x
      end
      begin fixed displacement
        node set = bottom
        component = z
      end
      begin fixed displacement
        block = cone
        components = x y
      end
      begin fixed rotation
        block = cone
        components = x y z
      end
      begin prescribed displacement
        block = cone
        component = z
        function = way
      end

      begin contact definition
        contact surface above contains cone
        contact surface below contains seat
        begin interaction press
          surfaces = above below
        end
      end

      begin solver
        begin cg
          begin full tangent preconditioner
          end
        end
      end

      begin heartbeat output
        stream name = %B.csv
        global reactz_cone_body
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
