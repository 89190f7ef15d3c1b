# Two cubes of steel of 0.1 m, one on the other, held together by one cohesive element without thickness, are pulled apart by
# 0.2 mm and pressed together again by 0.02 mm; or slid on each other and back (-D mode=slide) (SI).
#
# Shows COHESIVE SECTION with TVERGAARD_HUTCHINSON: the traction rises to its peak of 1 MPa, stays until half of the separation
# at failure, which is 0.1 mm against opening and 0.2 mm against sliding, and falls to nothing; sliding has half the peak and
# the same toughness, 1 MPa x 0.1 mm (1 - 0.05 + 0.5) / 2 = 72.5 J/m^2, 0.725 J on 0.01 m^2. The failed element dies, the cubes
# are free, and then meet by contact: to it the cohesive element is as if absent, and each cube owns its six faces from the
# start. Expected: peak and energy within 1 %, force of the press within 2 % of E A times 0.02 mm over 0.2 m.
#
# {ifndef(mode)}
# {mode = "open"}
# {endif}
# {frame = 1e-4}
begin sierra cohesive pull
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.0
    end
  end
  begin material glue
    begin parameters for model tvergaard_hutchinson
      peak traction = 1e6
      lambda_1 = 0.05
      lambda_2 = 0.5
      normal length scale = 1e-4
      tangential length scale = 2e-4
    end
  end

  begin cohesive section joint
  end

  begin definition for function there_and_back
    type = analytic
    evaluate expression = "x < 4e-3 ? 0.5 * (1 - cos(3.141592653589793 * x / 4e-3)) : 1 - 1.1 * 0.5 * (1 - cos(3.141592653589793 * min((x - 4e-3) / 4e-3, 1)))"
  end

  begin finite element model cubes
    database name = cohesive_pull.g
    begin parameters for block below above
      material = steel
      model = elastic
    end
    begin parameters for block joint
      material = glue
      model = tvergaard_hutchinson
      section = joint
    end
  end

  begin presto procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region cubes
          step interval = 10000
        end
      end
      termination time = 9e-3
    end

    begin presto region cubes
      use finite element model cubes

      begin fixed displacement
        node set = bottom
        components = x y z
      end
      begin fixed displacement
        node set = top
        components = {mode == "open" ? "x y" : "y z"}
      end
      begin prescribed displacement
        node set = top
        component = {mode == "open" ? "z" : "x"}
        function = there_and_back
        scale factor = {mode == "open" ? 2e-4 : 4e-4}
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
        end
      end

      begin element death failed
        block = joint
        criterion is element value of cohesive_damage >= 1
      end

      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        element cohesive_traction(1) nearest location 0.05 0.05 0.1 as normal
        element cohesive_traction(2) nearest location 0.05 0.05 0.1 as tangential
        element cohesive_dissipation nearest location 0.05 0.05 0.1 as dissipated
        element death_status nearest location 0.05 0.05 0.1 as life
        element stress(zz) nearest location 0.05 0.05 0.05 as stress
      end
      {include("results.inc")}
    end
  end
end sierra
