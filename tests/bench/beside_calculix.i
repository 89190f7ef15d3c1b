# One deck for all the models of beside_calculix.py: blocks "lower" and "upper", one load step, contact at default settings.
#
# {ifndef(number_of_steps)}
# {number_of_steps = 1}
# {endif}
# {ifndef(solver)}
# {solver = "auto"}
# {endif}
begin sierra beside calculix
  begin material below
    density = 1
    begin parameters for model elastic
      youngs modulus = {lower_youngs}
      poissons ratio = {nu}
    end
  end
  begin material above
    density = 1
    begin parameters for model elastic
      youngs modulus = {upper_youngs}
      poissons ratio = {nu}
    end
  end

  begin definition for function ramp
    type = piecewise linear
    begin values
      0 0
      1 1
    end
  end

  begin finite element model both
    database name = beside_calculix.g
    begin parameters for block lower
      material = below
      model = elastic
    end
    begin parameters for block upper
      material = above
      model = elastic
    end
  end

  begin adagio procedure press
    begin time control
      begin time stepping block all
        start time = 0
        begin parameters for adagio region both
          number of time steps = {number_of_steps}
        end
      end
      termination time = 1
    end

    begin adagio region both
      use finite element model both

      begin fixed displacement
        node set = held_x
        component = x
      end
      begin fixed displacement
        node set = held_y
        component = y
      end
      begin fixed displacement
        node set = held_z
        component = z
      end
{if(load == "pressure")}
      begin pressure
        surface = loaded
        function = ramp
        scale factor = {amount}
      end
{elseif(load == "depth")}
      begin prescribed displacement
        surface = loaded
        component = z
        function = ramp
        scale factor = {-amount}
      end
{endif}

      begin contact definition
        contact surface above contains upper_side
        contact surface below contains lower_side
        begin interaction press
          surfaces = above below
{if(tied)}
          friction model = tied
{endif}
{if(load == "overlap")}
          overlap ramp time = 1
{endif}
        end
      end

      begin solver
        begin cg
{if(tangent)}
          begin full tangent preconditioner
            linear solver = {solver}
          end
{endif}
        end
      end

      begin results output
        database name = %B.e
        at time 1 increment = 1
        nodal variables = displacement force_contact reaction
        element variables = stress
      end
    end
  end
end sierra
