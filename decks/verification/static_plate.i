# Half of an elastic plate, 0.08 x 0.04 m in plane strain, pressed onto a rigid rough plane by 5e7 Pa from above and by 15e7 Pa
# from both ends (SI): code_aster's SSNV128, a problem of GREDIF.
#
# Shows friction of load steps against an analytic plane: the ends slide inwards, the middle sticks. Expected: displacements along the
# plane of 2.861e-5, 2.722e-5, 2.285e-5, 1.980e-5 and 1.54e-5 m at 0, 1.25, 5, 7.5 and 11.25 mm from the end, within 1 %, by
# 32 x 32 elements of CalculiX; code_aster prints 2.86, 2.72, 2.28, 1.98 and 1.5e-5. 16 x 16 are enough: sliding of such
# friction (coefficient 1) is a stiffness that is far from symmetric.
#
# {ifndef(steps)}
# {steps = 1}
# {endif}
# {frame = 1}
begin sierra static plate
  begin material stiff
    density = 7800
    begin parameters for model elastic
      youngs modulus = 1.3e11
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

  begin finite element model plate
    database name = static_plate.g
    begin parameters for block plate
      material = stiff
      model = elastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region plate
          number of time steps = {steps}
        end
      end
      termination time = 1
    end

    begin adagio region plate
      use finite element model plate

      begin fixed displacement
        node set = middle
        component = x
      end
      begin fixed displacement
        include all blocks
        component = y
      end
      begin pressure
        surface = top
        function = ramp
        scale factor = 5e7
      end
      begin pressure
        surface = end
        function = ramp
        scale factor = 15e7
      end

      begin analytic object plane_z
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        contact surface below contains plane_z
        contact surface above contains foot
        begin constant friction model rough
          friction coefficient = 1
        end
        begin interaction press
          surfaces = above below
          friction model = rough
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
