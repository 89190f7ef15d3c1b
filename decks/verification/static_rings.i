# A quarter of two rings, one in the other, radii 0.5, 1 and 1.5 m, pressed from outside by 1e5 + 1e4 cos 2a Pa at the angle a, without
# friction (SI, plane strain, E = 1 GPa, nu = 0.2): as code_aster's SSNP167, at a hundredth of its pressure, so that theory of
# small motion holds.
#
# Shows contact pressure that varies over curved surfaces. Expected: Lame's pressure between the rings and the cos 2a part after
# Michell, within 2 %, also at every node.
#
# number  elements round
#
# {ifndef(number)}
# {number = 32}
# {endif}
# {ifndef(form)}
# {form = "face_face"}
# {endif}
# {ifndef(smoothing)}
# {smoothing = "off"}
# {endif}
# {frame = 1}
begin sierra static rings
  begin material rubber
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.2
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model rings
    database name = static_rings.g
    begin parameters for block inner outer
      material = rubber
      model = elastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region rings
          number of time steps = 1
        end
      end
      termination time = 1
    end

    begin adagio region rings
      use finite element model rings

      begin fixed displacement
        node set = on_x
        component = x
      end
      begin fixed displacement
        node set = on_y
        component = y
      end
      begin fixed displacement
        include all blocks
        component = z
      end
# The mean of cos 2a over each element.
# {i = 0} {angle = PI / 2 / number}
# {loop(number)}
# {i = i + 1}
      begin pressure
        surface = outside_{i}
        function = ramp
        scale factor = {1e5 + 1e4 * cos((2 * i - 1) * angle) * sin(angle) / angle}
      end
# {endloop}

      begin contact definition
        contact surface inner_side contains inner_side
        contact surface outer_side contains outer_side
        begin interaction press
          surfaces = inner_side outer_side
          constraint formulation = {form}
          smoothing = {smoothing}
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
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
