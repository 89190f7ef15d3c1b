# Trusses of 1 m and 1 cm^2 that are pulled in load steps until some of them die (SI). Three fibres side by side, of one node each
# end, hang on a grip, another such truss, whose other end moves by u. Beside them a chain of two trusses of which one is 2 %
# thinner, of a material that fails at a plastic strain of 1 %.
#
# Shows ELEMENT DEATH in load steps and CONTROL FAILURE. With n living fibres the grip carries k u n / (n + 1), each fibre
# k u / (n + 1), k = E A / L. In the fifth step, of u = 0.5 mm, one fibre passes its limit, and once it is gone the second: both die in
# this step, at whose end the grip carries k u / 2; without CONTROL FAILURE (-D control=0) it carries 3 k u / 4 in the fifth step,
# 2 k u / 3 in the sixth and k u / 2 from the seventh on. In the third step both parts of the chain pass what they withstand: under
# CONTROL FAILURE the thinner dies alone, which relieves the other. Expected: forces within 1e-3 (strains are finite), the count of
# the dead.
#
# {ifndef(control)}
# {control = 1}
# {endif}
begin sierra static breaking
  begin material brittle
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e9
      poissons ratio = 0
    end
  end
  begin material tough
    density = 1000
    begin parameters for model johnson_cook
      youngs modulus = 1e9
      poissons ratio = 0.3
      yield stress = 1e6
      hardening constant = 1e8
      hardening exponent = 1
      d1 = 0.01
    end
  end

  begin truss section fibre
    area = 1e-4
  end
  begin truss section thin
    area = 0.98e-4
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model trusses
    database name = static_breaking.g
    begin parameters for block first second third grip
      material = brittle
      model = elastic
      section = fibre
    end
    begin parameters for block bar
      material = tough
      model = johnson_cook
      section = fibre
    end
    begin parameters for block neck
      material = tough
      model = johnson_cook
      section = thin
    end
  end

  begin adagio procedure pull
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region trusses
          time increment = 0.1
        end
      end
      termination time = 1
    end

    begin adagio region trusses
      use finite element model trusses

      begin fixed displacement
        node set = held
        component = x
      end
      begin fixed displacement
        include all blocks
        components = y z
      end
      begin prescribed displacement
        node set = pulled
        component = x
        function = ramp
        scale factor = 1e-3
      end
      begin prescribed displacement
        node set = end_of_chain
        component = x
        function = ramp
        scale factor = 0.1
      end

      begin element death first
        block = first
        criterion is element value of von_mises >= 1.1e5
      end
      begin element death second
        block = second
        criterion is element value of von_mises >= 1.3e5
      end
      begin element death chain
        block = bar neck
        material criterion = on
      end

      begin solver
        begin cg
          target relative residual = 1e-8
        end
{if(control)}
        begin control failure
          maximum iterations = 10
        end
{endif}
      end

      begin user output
        node set = pulled
        compute global force as sum of nodal reaction(x)
      end
      begin user output
        node set = end_of_chain
        compute global chain_force as sum of nodal reaction(x)
      end
      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
        global force
        global chain_force
        global dead_elements
      end
    end
  end
end sierra
