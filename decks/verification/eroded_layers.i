# A block rests on a plate whose layers die one after the other (SI).
#
# Shows surfaces that follow ELEMENT DEATH: each layer dies at a set time, the skin of the plate moves down to the next,
# the block falls by a layer and lands on it. Its nodes stay behind as free masses and fly off or are swept (NODAL
# EROSION = ON takes them out of contact, so that they do not lie between the block and the next layer). Expected: at the
# end the block stands two layers lower, within a twentieth of a layer; momentum and energy balance.
#
# {ifndef(erosion)}
# {erosion = "on"} {frame = 0.02}
# {endif}
begin sierra eroded layers
  begin material stiff
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e7
      poissons ratio = 0.2
    end
  end

  begin finite element model blocks
    database name = eroded_layers.g
    begin parameters for block plate layer_1 layer_2 weight
      material = stiff
      model = elastic
    end
  end

  begin presto procedure fall
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = 0.6
    end

    begin presto region blocks
      use finite element model blocks

      begin gravity
        block = weight
        component = z
        gravitational constant = -10
      end
      begin fixed displacement
        node set = rim
        components = x y z
      end

      begin element death first
        block = layer_1
        criterion is global value of time >= 0.05
        nodal erosion = {erosion}
      end
      begin element death second
        block = layer_2
        criterion is global value of time >= 0.3
        nodal erosion = {erosion}
      end

      begin contact definition
        skin all blocks = on
        begin interaction defaults
          general contact = on
          contact damping fraction = 0.3
        end
      end

      begin user output
        block = weight
        compute global force as sum of nodal force_contact(z)
        compute global level as average of nodal displacement(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global force level
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
