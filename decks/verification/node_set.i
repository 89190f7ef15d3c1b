# Nodes of shells, lines and particles fly at a block as a CONTACT NODE SET (SI).
#
# Shows that nodes without outside faces meet faces as masses of their own, without lofts: the kind of the elements, or their
# size, is nothing to them. Expected: they fly back as fast as they came, within 2 % where nothing can vibrate; the contact
# force and momentum balance. With `erosion` their elements die on the way: the nodes fly on as free masses, which meet the
# block ("off") or do not ("on").
# ENFORCEMENT = PENALTY: nodes alone bounce by the elastic penalty; momentum balance takes the motion of what meets.
#
# {ifndef(section)}
# {section = "ball"} {erosion = ""} {frame = 2e-4}
# {endif}
begin sierra node set
  begin material stiff
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.2
    end
  end
  begin shell section sheet
    thickness = 0.1
  end
  begin beam section rod
    section = rod
    width = 0.1
    height = 0.1
    t axis = 0 0 1
  end
  begin particle section ball
    radius = 0.05
  end
  begin finite element model blocks
    database name = node_set.g
    begin parameters for block base
      material = stiff
      model = elastic
    end
    begin parameters for block top
      material = stiff
      model = elastic
      section = {section}
    end
  end
  begin presto procedure fly
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = 0.01
    end
    begin presto region blocks
      use finite element model blocks

      begin initial velocity
        block = top
        component = z
        magnitude = -10
      end
{if(erosion != "")}
      begin element death on_the_way
        block = top
        criterion is always true
        death start time = 1e-4
        nodal erosion = {erosion}
      end
{endif}
      begin contact definition
        enforcement = penalty
        contact surface base contains base
        contact node set nodes contains top
        begin interaction meeting
          side a = base
          side b = nodes
          constraint formulation = node_face
        end
      end
      begin user output
        block = top
        compute global speed as average of nodal velocity(z)
      end
      begin heartbeat output
        stream name = %B.csv
        global speed
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
