# A block lies on another and is moved away and along by given displacements; each friction model answers by its law (SI).
#
# Shows every model past Coulomb's as a path of gap and slip, on one place of contact: all nodes are driven, so that the force
# is the law's at the displacement that is reached. Expected: forces as the laws' formulas by hand, to round-off where the law
# is one of the displacement; to the stick before slip, or to a step's motion, where it limits or fails.
#
# {ifndef(models)}
# {models = ""} {law = "frictionless"} {functions = ""} {form = "face_face"} {away = "0 0"} {along = "0 0"}
# {has_far = 0} {stiffness = 1e6} {half = 0.1} {end_time = 0.2} {frame = 1e-9}
# {endif}
begin sierra interaction
  begin material soft
    density = 1000
    begin parameters for model elastic
      youngs modulus = 1e8
      poissons ratio = 0
    end
  end
  begin definition for function away
    type = piecewise linear
    begin values
      {away}
    end
  end
  begin definition for function along
    type = piecewise linear
    begin values
      {along}
    end
  end
{functions}
  begin finite element model blocks
    database name = interaction.g
    begin parameters for block
      include all blocks
      material = soft
      model = elastic
    end
  end
  begin presto procedure move
    begin time control
      begin time stepping block first
        start time = 0
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      begin time stepping block second
        start time = {half}
        begin parameters for presto region blocks
          step interval = 1000
        end
      end
      termination time = {end_time}
    end
    begin presto region blocks
      use finite element model blocks

      begin fixed displacement
        block = base
        components = x y z
      end
      begin fixed displacement
        include all blocks
        remove block = base
        component = y
      end
      begin prescribed displacement
        include all blocks
        remove block = base
        component = x
        function = along
      end
      begin prescribed displacement
        include all blocks
        remove block = base
        component = z
        function = away
      end

      begin contact definition
        skin all blocks = on
        {models}
        begin interaction lower
          side a = base
          side b = top
          friction model = {law}
          constraint formulation = {form}
          penalty stiffness = {stiffness}
          capture tolerance = 1e-3
        end
{if(has_far)}
        begin interaction higher
          side a = base
          side b = far
          friction model = {law}
          constraint formulation = {form}
          penalty stiffness = {stiffness}
          capture tolerance = 1e-3
        end
{endif}
      end
      begin heartbeat output
        stream name = %B.csv
        {include("energies.inc")}
      end
      {include("results.inc")}
    end
  end
end sierra
