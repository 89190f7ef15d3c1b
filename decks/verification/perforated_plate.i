# A steel rod goes through an aluminium plate, whose elements die as they yield too far (SI).
#
# A robustness case: elements die by plastic strain, by turning inside out and with their last neighbour; the surfaces
# of plate and rod follow, and nodes that are left alone fly on as masses in contact. Expected: the rod gets through
# with a speed below its own, no energy appears (the balance stays within 2 %), momentum is kept, and one and two
# threads write the same.
#
# {ifndef(speed)}
# {speed = 500} {limit = 0.4} {erosion = "off"} {death_steps = 1} {frame = 5e-6}
# {endif}
begin sierra perforated plate
  begin material steel
    density = 7800
    begin parameters for model elastic
      youngs modulus = 210e9
      poissons ratio = 0.3
    end
  end
  begin material aluminium
    density = 2700
    begin parameters for model elastic_plastic
      youngs modulus = 70e9
      poissons ratio = 0.33
      yield stress = 250e6
      hardening modulus = 500e6
    end
  end

  begin finite element model parts
    database name = perforated_plate.g
    begin parameters for block plate
      material = aluminium
      model = elastic_plastic
    end
    begin parameters for block rod
      material = steel
      model = elastic
    end
  end

  begin presto procedure hit
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region parts
          step interval = 500
        end
      end
      termination time = 60e-6
    end

    begin presto region parts
      use finite element model parts

      begin initial velocity
        block = rod
        component = z
        magnitude = {-speed}
      end

      begin element death of_plate
        include blocks with material = aluminium
        criterion is element value of eqps >= {limit}
        death on inversion = on
        death on ill defined contact = on
        aggressive contact cleanup = on
        death steps = {death_steps}
        nodal erosion = {erosion}
        summary output step interval = 500
      end

      begin contact definition
        skin all blocks = on
        begin constant friction model dry
          friction coefficient = 0.1
        end
        begin interaction defaults
          general contact = on
          self contact = on
          friction model = dry
        end
      end

      begin user output
        block = rod
        compute global rod_speed as average of nodal velocity(z)
        compute global rod_place as average of nodal displacement(z)
      end
      begin user output
        block = plate
        compute global living as sum of element death_status
      end
      begin heartbeat output
        stream name = %B.csv
        global rod_speed rod_place living
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
