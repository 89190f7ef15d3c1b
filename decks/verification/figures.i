# The figures and examples of the surface rules, each as a run: cubes are thrown at every side of every element (SI).
#
# Shows that contact acts on the faces that a surface owns and on no other, before and after element death. In front of each
# side of each element, also of those between two elements, a cube flies at it; either one surface and the cubes interact or
# all surfaces (`pairs`). Elements of the list `dead` die at 1e-4, before anything meets. Expected: cubes bounce off what the
# surfaces own, on the others no contact force ever acts; momentum and energy balance.
# ENFORCEMENT = PENALTY: cubes of one element bounce by the elastic penalty alone.
#
# {ifndef(lines)}
# {lines = "contact surface probes contains probes"} {pairs = ""} {sheet = ""} {rod = ""} {n_dead = 0} {dead = ""} {frame = 2e-3}
# {endif}
begin sierra figures
  begin material stiff
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.2
    end
  end
  begin shell section thick
    thickness = 0.5
  end
  begin beam section square
    section = bar
    width = 0.5
    height = 0.5
    t axis = 0 0 1
  end
  begin finite element model blocks
    database name = figures.g
    begin parameters for block
      include all blocks
      material = stiff
      model = elastic
    end
{if(sheet != "")}
    begin parameters for block {sheet}
      material = stiff
      model = elastic
      section = thick
    end
{endif}
{if(rod != "")}
    begin parameters for block {rod}
      material = stiff
      model = elastic
      section = square
    end
{endif}
  end
  begin presto procedure throw
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = 0.012
    end
    begin presto region blocks
      use finite element model blocks
# {loop(3, i, 0)}

      begin initial velocity
        node set = from_{2 * i}
        component = {get_word(i + 1, "x y z", " ")}
        magnitude = 10
      end
      begin initial velocity
        node set = from_{2 * i + 1}
        component = {get_word(i + 1, "x y z", " ")}
        magnitude = -10
      end
# {endloop}
{if(n_dead > 0)}
      begin element death some
        element = {dead}
        criterion is always true
        death start time = 1e-4
        logfile output = full
      end
{endif}

      begin contact definition
        enforcement = penalty
        {lines}
        {pairs}
      end
      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
