# Taylor's test against an analytic plane: a copper rod, 32.4 mm long and 3.2 mm thick, mushrooms on a frictionless wall
# (a quarter of it; SI). The rod of ../taylor_bar.i with its wall by contact, at three speeds, and perfectly plastic.
#
# Expected after 80 microseconds: at 227 m/s 21.5 +- 0.3 mm long with a foot of 7.15 +- 0.25 mm (Kamoulakos 1990, Zhu and
# Cescotto 1995, Camacho and Ortiz 1997); at 130 and 146 m/s the lengths of a finer axisymmetric mesh within 1 %, its feet
# within 3 %; perfectly plastic (Abaqus benchmark "Impact of a copper rod") 19.36 mm within 2 %.
# Hourglass resistance follows the elastic shear modulus and is lowered, as there.
#
# {ifndef(speed)}
# {speed = 227}
# {endif}
# {ifndef(yield)}
# {density = 8930} {youngs = 117e9} {nu = 0.35} {yield = 400e6} {hardening = 100e6}
# {endif}
# {frame = 5e-6}
begin sierra taylor bar on a wall
  begin material copper
    density = {density}
    begin parameters for model elastic_plastic
      youngs modulus = {youngs}
      poissons ratio = {nu}
      yield stress = {yield}
      hardening modulus = {hardening}
      beta = 1
    end
  end

  begin finite element model rod
    database name = taylor_wall.g
    begin parameters for block core east north
      material = copper
      model = elastic_plastic
      hourglass stiffness = 0.002
    end
  end

  begin presto procedure impact
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region rod
          step interval = 5000
        end
      end
      termination time = 80e-6
    end

    begin presto region rod
      use finite element model rod

      begin fixed displacement
        node set = on_x
        component = y
      end
      begin fixed displacement
        node set = on_y
        component = x
      end
      begin initial velocity
        include all blocks
        component = z
        magnitude = {-speed}
      end

      begin analytic object plane_z
        type = plane
        normal direction = 0 0 1
        origin = 0 0 0
      end

      begin contact definition
        contact surface rod contains core east north
        contact surface wall contains plane_z
        begin interaction impact
          surfaces = rod wall
        end
      end

      begin heartbeat output
        stream name = %B.csv
        nodal displacement(z) nearest location 0 0 0.0324 as end_displacement
        nodal coordinates(x) nearest location 0.0032 0 0 as foot_radius
        nodal coordinates(z) nearest location 0 0 0 as foot_level
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
