# The figures of the surface rules, with deaths: a brick whose top is half covered by shells that share its nodes (SI).
#
# Shows that a shell covers the face of the solid under it whatever the order of the surfaces, that its death exposes that
# face to the solid's surface and takes its own loft away, and that it outlives the solid. Elements of the list
# `dead` die at 1e-4. Expected: the numbers of faces and of lofted shells by hand, nothing moves.
#
# {ifndef(order)}
# {order = 1} {dead = "9"} {frame = 1e-4}
# {endif}
begin sierra figure shells
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
  begin finite element model blocks
    database name = figure_shells.g
    begin parameters for block block_1
      material = stiff
      model = elastic
    end
    begin parameters for block block_2
      material = stiff
      model = elastic
      section = sheet
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
        contact surface c1 contains block_1
        contact surface c2 contains block_2
        {else}
        contact surface c2 contains block_2
        contact surface c1 contains block_1
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
