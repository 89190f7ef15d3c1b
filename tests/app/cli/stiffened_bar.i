# A bar of hexahedra with a sheet of shells on it, clamped at one end, hangs on a spring at the other and is bent in load steps
# until some of it dies: what ranks share of load steps (SI).
#
# {ifndef(solver)}
# {solver = "direct"}
# {endif}
# {ifndef(most_cutbacks)}
# {most_cutbacks = 4}
# {endif}
# {ifndef(way)}
# {way = -0.02}
# {endif}
# {ifndef(end)}
# {end = 1}
# {endif}
# {ifndef(restart)}
# {restart = 0}
# {endif}
begin sierra stiffened bar
{if(restart)}
  restart = automatic
{endif}
  begin material bar
    density = 7800
    begin parameters for model elastic
      youngs modulus = 200e9
      poissons ratio = 0.3
    end
  end
  begin material sheet
    density = 7800
    begin parameters for model elastic_plastic
      youngs modulus = 200e9
      poissons ratio = 0.3
      yield stress = 80e6
      hardening modulus = 1e9
    end
  end
  begin shell section sheet
    thickness = 0.05
  end
  begin spring section stay
    default stiffness = 1e9
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model bar
    database name = stiffened_bar.g
    begin parameters for block bar
      material = bar
      model = elastic
    end
    begin parameters for block sheet
      material = sheet
      model = elastic_plastic
      section = sheet
    end
    begin parameters for block stay
      section = stay
    end
  end

  begin adagio procedure bend
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region bar
          time increment = 0.25
        end
      end
      termination time = {end}
    end

    begin adagio region bar
      use finite element model bar
      begin fixed displacement
        node set = clamped
        components = x y z
      end
      begin fixed rotation
        node set = clamped
        components = x y z
      end
      begin fixed displacement
        node set = ground
        components = x y z
      end
      begin prescribed displacement
        node set = tip
        component = z
        function = ramp
        scale factor = {way}
      end
      begin element death worn
        block = bar
        criterion is element value of von_mises >= 110e6
      end

      begin solver
        begin cg
{if(solver != "nodal")}
          begin full tangent preconditioner
            linear solver = {solver}
          end
{endif}
        end
        begin control failure
          maximum iterations = 20
        end
      end
      begin adaptive time stepping
        maximum failure cutbacks = {most_cutbacks}
      end

      begin restart data
        database name = stiffened_bar.rsout
        at step 0 increment = 2
      end
      begin heartbeat output
        stream name = %B.csv
        precision = 17
        at step 0 increment = 1
        global internal_energy
        global external_energy
        global hourglass_energy
        global dead_elements
        element von_mises nearest location 0 0 0 as stress
      end
      begin results output
        database name = %B.e
        at step 0 increment = 1
        nodal variables = displacement reaction
        element variables = stress death_status
      end
    end
  end
end sierra
