# The figures of the surface rules, with deaths: two blocks that share nodes and a side set over both (SI).
#
# Shows ownership before and after element death in a run: elements of the list `dead` die at 1e-4, and the log prints the
# table of surfaces again. A side set that comes first keeps its faces until their elements die, blocks gain what
# deaths expose, each its own; everything is as if the dead had never been. Expected: the numbers of faces by
# hand, nothing moves (there is no load), no contact force appears.
#
# {ifndef(order)}
# {order = 1} {dead = "9"} {frame = 1e-4}
# {endif}
begin sierra figure deaths
  begin material stiff
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0.2
    end
  end
  begin finite element model blocks
    database name = figure_deaths.g
    begin parameters for block block_1 block_2
      material = stiff
      model = elastic
    end
  end
  begin presto procedure p
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = 2e-3
    end
    begin presto region blocks
      use finite element model blocks

      begin element death some
        element = {dead}
        criterion is always true
        death start time = 1e-4
        logfile output = full
      end

      begin contact definition
        {if(order == 1)}
        contact surface c3 contains joint
        contact surface c1 contains block_1
        contact surface c2 contains block_2
        {elseif(order == 2)}
        contact surface c1 contains block_1
        contact surface c3 contains joint
        contact surface c2 contains block_2
        {else}
        contact surface c3 contains joint
        {endif}
        begin interaction defaults
          general contact = on
          self contact = on
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
